// SPDX-License-Identifier: Apache-2.0
// A bur drills into bone, dry and with water. Plots the highest temperature over time, and a section through the hole.
// Usage: 10_heat [folder]
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <hapticut/hapticut.hpp>
#include <hapticut/heat/heat_collector.hpp>
#include <hapticut/heat/heat_field.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "line_plot.hpp"
#include "section_plot.hpp"

using namespace hapticut;
using namespace hapticut::units;

constexpr double kFeed = 0.05 * mm_per_s, kTick = 1 * ms;
constexpr int kTicks = 12000, kFrame = 40;  // ticks; the field advances every 40 ms

struct Course {
  Line hottest;                              // [deg C] every half second
  std::vector<std::vector<double>> section;  // [deg C] at y = 0, from the top down
  StructureHeat bone;
};

Course drill(const std::string& name, double irrigation) {
  const Box box = {Vec3(-4, -4, -6) * mm, Vec3(4, 4, 0) * mm};
  Simulation simulation(build_block(box, 0.1 * mm, presets::cortical_bone()),
                        Tool(round_head(2 * mm), RayHandle{0}, Spindle{10'000 * rpm}));
  HeatConfig config;
  config.irrigation = irrigation;
  HeatCollector collector(simulation);  // observes every step; in a loop the field runs in another thread
  HeatField field(simulation.workpiece(), config);

  Course course = {{name, {}}, {}, {}};
  const double lowest = simulation.tool().head().bounding_box().min.z();
  for (int tick = 1; tick <= kTicks; ++tick) {
    const Vec3 tip(0, 0, -lowest - kFeed * kTick * tick);
    (void)simulation.step(Pose::from_translation(tip), {Vec3(0, 0, -kFeed), Vec3::Zero()}, kTick);
    if (tick % kFrame != 0) continue;
    field.advance(field.drain(collector));
    if (tick % 480 == 0) course.hottest.values.push_back(field.structures()[0].temperature);
  }
  course.bone = field.structures()[0];
  for (double z = -0.05 * mm; z > box.min.z(); z -= 0.1 * mm) {
    course.section.emplace_back();
    for (double x = box.min.x() + 0.05 * mm; x < box.max.x(); x += 0.1 * mm)
      course.section.back().push_back(simulation.workpiece().material_at({int((x - box.min.x()) / (0.1 * mm)), 40,
                                                                          int((z - box.min.z()) / (0.1 * mm))}) ==
                                              kEmpty
                                          ? std::nan("")
                                          : field.temperature_at({x, 0.05 * mm, z}));
  }
  return course;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::filesystem::create_directories(folder);
  const std::array courses = {drill("dry", 0), drill("water at 23 deg C", 3000)};
  for (const Course& course : courses)
    std::cout << course.hottest.name << ": bone reached " << shortened(course.bone.peak) << " deg C, was above 47 for "
              << shortened(course.bone.time_above) << " s, CEM43 " << shortened(course.bone.cem43) << " min, "
              << shortened(course.bone.volume_above / (mm * mm * mm)) << " mm^3 were above 47 deg C\n";
  write_to(folder / "heat.svg", [&](auto& out) {
    write_section_svg(out,
                      {{courses[0].hottest.name, courses[0].section}, {courses[1].hottest.name, courses[1].section}},
                      23, 100, "deg C");
  });
  write_to(folder / "heat_over_time.svg", [&](auto& out) {
    write_svg(out, "time [0.48 s]", {{"hottest bone [deg C]", {courses[0].hottest, courses[1].hottest}}}, 1);
  });
}
