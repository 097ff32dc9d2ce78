// SPDX-License-Identifier: Apache-2.0
// Figures 7.1-7.3 of the thesis: three heads step into a cube, and whatever they touch goes. Voxels removed, force and
// torque per step, by the model of the thesis and by the default model; writes three CSV files and their plots.
// Usage: 03_figures_of_the_thesis [folder]
#include <cmath>
#include <filesystem>
#include <fstream>
#include <hapticut/hapticut.hpp>
#include <iostream>

#include "line_plot.hpp"

using namespace hapticut;
using namespace hapticut::units;

constexpr double kSize = 0.3 * mm;   // radius and height of the heads: 0.3 in the units of the thesis's scene
constexpr double kStep = 0.02 * mm;  // the thesis does not say how large its steps are
constexpr int kSteps = 14;

struct Series {
  std::string name;
  std::vector<double> voxels, force, torque;  // per step: [1], [N], [N·mm]
};

Series step_down(const std::string& name, const ToolHead& head, bool thesis) {
  Material material;
  material.name = "cube";
  material.relative_stiffness = 0.4;
  SimulationConfig config;
  config.reference_stiffness = thesis ? 1e13 : 1e15;
  ThesisLaw::Constants constants;
  constants.required_power = 0;  // whatever is touched goes
  if (thesis) config.law = std::make_shared<ThesisLaw>(constants);
  if (thesis) config.longest_sweep = 1;  // its tool jumps from step to step; the first call takes it there
  const double voxel = 0.01 * mm, lowest = head.bounding_box().min.z();
  Simulation simulation(build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, voxel, material),
                        Tool(head, RayHandle{}, Spindle{thesis ? 1000.0 : 20000.0}), config);
  Series series{name, {}, {}, {}};
  (void)simulation.step(Pose::from_translation(Vec3(0, 0, -lowest)), {}, 1 * ms);  // touching, not yet in
  for (int i = 0; i < kSteps; ++i) {
    const int ticks = thesis ? 1 : 20;  // the default model has no force for a jump: it is fed a step in 20 ms
    double volume = 0;
    Wrench mean;
    for (int tick = 1; tick <= ticks; ++tick) {
      const double z = -lowest - kStep * (i + double(tick) / ticks);
      const Pose pose = Pose::from_translation(Vec3(0.0013 * mm, 0.0021 * mm, z));
      if (thesis) (void)simulation.step(pose, {}, 1 * ms);
      const StepResult& result = simulation.step(pose, {}, 1 * ms);
      volume += result.removed_volume;
      mean.force += result.force / ticks;
      mean.torque += result.torque / ticks;
    }
    series.voxels.push_back(volume / std::pow(voxel, 3));
    series.force.push_back(mean.force.z());
    series.torque.push_back(-mean.torque.z() / N_mm);
  }
  return series;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::filesystem::create_directories(folder);
  std::vector<Series> all;
  for (const bool thesis : {true, false}) {
    const std::string mode = thesis ? " (thesis)" : " (energy)";
    all.push_back(step_down("sphere" + mode, SphereHead{kSize}, thesis));
    all.push_back(step_down("cone" + mode, ConeHead{45 * deg, kSize}, thesis));
    all.push_back(step_down("flat" + mode, FlatHead{kSize, kSize, FlatRule::bottom_only}, thesis));
  }
  const auto write = [&](const std::string& name, const std::string& title, std::vector<double> Series::*values) {
    std::vector<LinePlot::Line> lines;
    for (const Series& series : all) lines.push_back({series.name, series.*values});
    std::ofstream csv(folder / (name + ".csv")), svg(folder / (name + ".svg"));
    write_csv(csv, "step", lines);
    write_svg(svg, LinePlot{title, "step", lines, 3});
    if (!csv || !svg) throw Error("cannot write to " + folder.string() + ". Choose a folder that can be written to.");
  };
  write("figure_7_1_voxels", "Voxels removed in a step", &Series::voxels);
  write("figure_7_2_force", "Cutting force of a step [N]", &Series::force);
  write("figure_7_3_torque", "Cutting torque of a step [N mm]", &Series::torque);
  std::cout << "wrote figures 7.1, 7.2 and 7.3 to " << std::filesystem::absolute(folder).string() << "\n";
}
