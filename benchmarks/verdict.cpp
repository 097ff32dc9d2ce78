// SPDX-License-Identifier: Apache-2.0
// Whether the scenes that users have fit into 1 ms: heads and presets, a motor with its limits, behind the coupling of
// a Touch, pressed with 2 N, turning and stalled. Prints a verdict, then a table in Markdown, the slowest scene first.
// Usage: bench_verdict [ticks]
#include <ctime>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::bench {
namespace {

using units::deg;
using units::mm;
using units::rpm;

constexpr double kDeadline = 1e-3, kTick = 1e-3;  // [s]
constexpr double kPress = 2, kGlide = 3e-3;       // [N], [m/s] of the hand

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

struct Scene {
  std::string head;
  ToolHead shape;
  Material material;
  double voxel;        // [m]
  AngularSpeed speed;  // 0: stalled
};

struct Times {
  double p50, p99, max;  // [s]
};

/// A hand that sinks in and glides along x, behind the coupling of a Touch.
Times times_of(const Scene& scene, int ticks) {
  const double radius = scene.shape.max_radius(),
               height = scene.shape.bounding_box().max.z() - scene.shape.bounding_box().min.z();
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  config.reserved_blocks = 32768;
  const double length = kGlide * kTick * ticks;
  const Box box{Vec3(-2 * radius, -2 * radius, -height - radius), Vec3(2 * radius + length, 2 * radius, 0)};
  const Spindle spindle = scene.speed == 0 ? Spindle{0} : common_spindle(scene.speed);
  Simulation simulation(build_block(box, scene.voxel, scene.material), Tool(scene.shape, RayHandle{0}, spindle),
                        config);
  VirtualCoupling coupling(simulation, coupling_gains(capabilities(device_model("touch"))));
  std::vector<double> times;
  times.reserve(std::size_t(ticks));
  Vec3 hand(0.013 * mm, 0.021 * mm, -scene.shape.bounding_box().min.z() + 0.2 * mm);
  for (int tick = 0; tick < ticks; ++tick) {
    const double before = thread_seconds();
    const CoupledResult& felt = coupling.step(Pose::from_translation(hand), {Vec3(kGlide, 0, 0), Vec3::Zero()}, kTick);
    times.push_back(thread_seconds() - before);
    hand.x() += kGlide * kTick;
    hand.z() = std::max(hand.z() - 2e-6, felt.X_WH.translation.z() - kPress / coupling.gains().stiffness);
  }
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[std::min(times.size() - 1, std::size_t(share * double(times.size())))];
  };
  return {at(0.5), at(0.99), times.back()};
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const double voxel : {0.1 * mm, 0.05 * mm}) {
    const auto add = [&](const std::string& name, const ToolHead& head, const Material& material, AngularSpeed speed) {
      all.push_back({name, head, material, voxel, speed});
    };
    for (const double R : {1 * mm, 2 * mm, 3 * mm}) {
      const std::string size = " R " + format_number(R / mm);
      for (const AngularSpeed speed : {40'000 * rpm, 0 * rpm}) {
        add("ball" + size, SphereHead{R}, presets::cortical_bone(), speed);
        add("flat" + size, FlatHead{R, 2 * R}, presets::cortical_bone(), speed);
      }
      add("cone" + size, ConeHead{30 * deg, R / std::tan(30 * deg)}, presets::cortical_bone(), 40'000 * rpm);
    }
    for (const char* material : {"enamel", "dentin", "trabecular_bone", "clay"})
      add("ball R 1", SphereHead{1 * mm}, find_preset(material), 40'000 * rpm);
    add("pear 1.2 mm", pear_head(1.2 * mm, 2.4 * mm, 0.8 * mm), presets::dentin(), 200'000 * rpm);
  }
  return all;
}

}  // namespace
}  // namespace hapticut::bench

int main(int argc, char** argv) {
  using namespace hapticut;
  using namespace hapticut::bench;
  const int ticks = argc > 1 ? std::max(100, std::atoi(argv[1])) : 3000;
  struct Row {
    Scene scene;
    Times times;
  };
  std::vector<Row> rows;
  for (const Scene& scene : scenes()) rows.push_back({scene, times_of(scene, ticks)});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.times.p99 > b.times.p99; });
  const auto fit = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.times.p99 <= kDeadline; });
  std::printf("%d of %d scenes fit into 1 ms (p99, behind the coupling of a Touch, 2 N).\n\n", int(fit),
              int(rows.size()));
  std::printf(
      "| scene | voxels [mm] | material | spindle | p50 [us] | p99 [us] | max [us] | fits |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const auto& [scene, times] : rows)
    std::printf("| %s | %g | %s | %s | %.0f | %.0f | %.0f | %s |\n", scene.head.c_str(), scene.voxel / units::mm,
                scene.material.name.c_str(),
                scene.speed == 0 ? "stalled" : (format_number(scene.speed / units::rpm) + " rpm").c_str(),
                1e6 * times.p50, 1e6 * times.p99, 1e6 * times.max, times.p99 <= kDeadline ? "yes" : "**no**");
}
