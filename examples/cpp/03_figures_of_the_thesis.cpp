// SPDX-License-Identifier: Apache-2.0
// Figures 7.1-7.3 of the thesis: three heads step into a cube. Writes the removed voxels, the force and the torque of
// each step as three CSV files and one plot, in thesis mode and by the default model.
// Usage: 03_figures_of_the_thesis [folder]
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "line_plot.hpp"

using namespace hapticut;
using namespace hapticut::units;

constexpr double kSize = 0.3 * mm;   // radius and height of the heads: 0.3 in the units of the thesis's scene
constexpr double kStep = 0.02 * mm;  // the thesis does not say how large its steps are
constexpr int kSteps = 14;
constexpr AngularSpeed kTurbine = 300'000 * rpm;  // at which voxels go as soon as their centres are 2 um deep

constexpr std::array kFiles = {"figure_7_1_voxels", "figure_7_2_force", "figure_7_3_torque"};
constexpr std::array kTitles = {"voxels removed in a step", "force of a step [N]", "torque of a step [N mm]"};

struct Series {
  std::string name;
  std::array<std::vector<double>, 3> values;  // per step: voxels [1], force [N], torque [N·mm]
};

Series step_down(const std::string& name, const ToolHead& head, bool thesis) {
  Material material;
  material.name = "cube";
  material.relative_stiffness = 0.4;
  const double voxel = 0.01 * mm, lowest = head.bounding_box().min.z();
  Simulation simulation(build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, voxel, material),
                        Tool(head, RayHandle{0}, Spindle{kTurbine}), thesis ? thesis_mode() : SimulationConfig{});
  Series series{name, {}};
  const auto pose_at = [&](double depth) {
    return Pose::from_translation(Vec3(0.0013 * mm, 0.0021 * mm, -lowest - depth));
  };
  (void)simulation.step(pose_at(0), {}, 1 * ms);  // touches the cube
  for (int i = 0; i < kSteps; ++i) {
    const int ticks = thesis ? 1 : 20;  // a cut of the default model takes time
    double volume = 0;
    Wrench mean;
    for (int tick = 1; tick <= ticks; ++tick) {
      const StepResult& result = simulation.step(pose_at(kStep * (i + double(tick) / ticks)), {}, 1 * ms);
      volume += result.removed_volume;
      mean.force += result.force / ticks;
      mean.torque += result.torque / ticks;
    }
    series.values[0].push_back(volume / std::pow(voxel, 3));
    series.values[1].push_back(mean.force.z());
    series.values[2].push_back(-mean.torque.z() / N_mm);
  }
  return series;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::filesystem::create_directories(folder);
  std::array<std::vector<Line>, 3> tables;
  std::vector<Panel> panels;
  for (const bool thesis : {true, false}) {
    const std::string mode = thesis ? "thesis: " : "energy: ";
    const std::array<Series, 3> heads = {
        step_down("sphere", SphereHead{kSize}, thesis), step_down("cone", ConeHead{45 * deg, kSize}, thesis),
        step_down("flat", FlatHead{kSize, kSize, FlatRule::bottom_only}, thesis)};  // its side does not rub
    for (std::size_t n = 0; n < tables.size(); ++n) {
      panels.push_back({mode + kTitles[n], {}});
      for (const Series& head : heads) {
        panels.back().lines.push_back({head.name, head.values[n]});
        tables[n].push_back({mode + head.name, head.values[n]});
        std::cout << mode << head.name << ", " << kTitles[n] << ": " << shortened(head.values[n][5]) << " in the 6th, "
                  << shortened(head.values[n].back()) << " in the last\n";
      }
    }
  }
  for (std::size_t n = 0; n < tables.size(); ++n)
    write_to(folder / (std::string(kFiles[n]) + ".csv"), [&](auto& out) { write_csv(out, "step", tables[n]); });
  write_to(folder / "figures_7_1_to_7_3.svg", [&](auto& out) { write_svg(out, "step", panels, 3); });
}
