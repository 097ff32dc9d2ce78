// SPDX-License-Identifier: Apache-2.0
// Whether the scenes that users have fit into a tick: heads and presets with their chips, a motor with its limits. A
// hand behind the coupling of a Touch presses with 2 N, or less where the tool is then deeper than 1 mm, and glides; or
// a hand leads the tool through a groove 1 mm deep. Prints a verdict, then two tables in Markdown: the scenes with a
// goal, and all, the slowest first.
#include <ctime>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "kernel_choice.hpp"

namespace hapticut::bench {
namespace {

using units::deg;
using units::mm;
using units::rpm;

constexpr double kPress = 2;      // [N] force of the hand
constexpr double kGlide = 3e-3;   // [m/s] speed of the hand
constexpr double kPlunge = 2e-3;  // [m/s] speed of the hand, at most
constexpr double kDepth = 1e-3;   // [m] depth of a groove; a coupled tool that is deeper is not pressed further
constexpr int kTicks = 3000;      // measured

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
  bool coupled = true;
  double rate = 1000;  // [1/s] ticks
  // Wanted: a share of the ticks within a time [s]; 0: only the tick must be kept.
  double goal = 0, share = 0.5;

  [[nodiscard]] std::string name() const {
    return head + ", " + format_number(voxel / mm) + " mm, " + material.name + ", " +
           (speed == 0 ? "stalled" : format_number(speed / rpm) + " rpm") + (coupled ? ", coupled" : ", groove") +
           (rate == 1000 ? "" : ", " + format_number(rate / 1000) + " kHz");
  }
};

struct Times {
  std::vector<double> ticks;                  // [s] ascending
  double voxels = 0, steps = 0, newtons = 0;  // per tick: in contact at its end, steps of the simulation, Newton steps
  double pressed = 0;                         // [N] mean force on the hand, upwards

  [[nodiscard]] double at(double share) const {
    return ticks[std::min(ticks.size() - 1, std::size_t(share * double(ticks.size())))];
  }
};

Simulation simulation_of(const Scene& scene, double length) {
  const double radius = scene.shape.max_radius(),
               height = scene.shape.bounding_box().max.z() - scene.shape.bounding_box().min.z();
  SimulationConfig config;
  if (scene.coupled) config.contact_time = ContactTime::end;
  config.reserved_blocks = 32768;
  const Box box{Vec3(-2 * radius, -2 * radius, -height - radius), Vec3(2 * radius + length, 2 * radius, 0)};
  const Spindle spindle = scene.speed == 0 ? Spindle{0} : common_spindle(scene.speed);
  return Simulation(build_block(box, scene.voxel, scene.material), Tool(scene.shape, RayHandle{0}, spindle), config);
}

Times times_of(const Scene& scene) {
  const double dt = 1 / scene.rate, bottom = scene.shape.bounding_box().min.z();
  Simulation simulation = simulation_of(scene, kGlide * dt * kTicks);
  std::optional<VirtualCoupling> coupling;
  if (scene.coupled) coupling.emplace(simulation, coupling_gains(capabilities(device_model("touch"))));
  Times times;
  times.ticks.reserve(std::size_t(kTicks));
  Vec3 hand(0.013 * mm, 0.021 * mm, -bottom + 0.02 * mm);
  double lowest = -std::numeric_limits<double>::infinity();  // [m] where the hand stops
  double depth = 0, pressed = 0;                             // [m], [N] depth of the tool, force on the hand
  int steps = 0, newtons = 0;
  // One tick. Behind the coupling the hand follows the tool, so that it presses with kPress at most.
  const auto move = [&](double glide, double plunge) {
    const double z = std::max(hand.z() - plunge * dt, lowest);
    const Twist velocity{Vec3(glide, 0, (z - hand.z()) / dt), Vec3::Zero()};
    hand += velocity.linear * dt;
    if (coupling) {
      const CoupledResult& felt = coupling->step(Pose::from_translation(hand), velocity, dt);
      steps = felt.sub_ticks, newtons = felt.newton_steps, pressed = felt.coupling.force.z();
      const double tool = felt.X_WH.translation.z();
      depth = -bottom - tool;
      lowest = depth > kDepth ? hand.z() : tool - kPress / coupling->gains().stiffness;
    } else {
      const StepResult& felt = simulation.step(Pose::from_translation(hand), velocity, dt);
      steps = felt.sub_steps, pressed = felt.force.z(), depth = -bottom - hand.z();
    }
  };
  while (depth < kDepth && !(coupling && pressed > 0.95 * kPress)) move(0, kPlunge);
  for (int tick = 0; tick < kTicks; ++tick) {
    const double before = thread_seconds();
    move(kGlide, coupling ? kPlunge : 0);
    times.ticks.push_back(thread_seconds() - before);
    times.steps += steps, times.newtons += newtons, times.pressed += pressed;
    times.voxels += double(simulation.last_result().contact.voxels);
  }
  std::sort(times.ticks.begin(), times.ticks.end());
  for (double* sum : {&times.voxels, &times.steps, &times.newtons, &times.pressed}) *sum /= kTicks;
  return times;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  const auto ball = [](double R) { return SphereHead{R}; };
  const auto flat = [](double R) { return FlatHead{R, 2 * R}; };
  const auto cone = [](double R) { return ConeHead{30 * deg, R / std::tan(30 * deg)}; };
  const ToolHead pear = pear_head(1.2 * mm, 2.4 * mm, 0.8 * mm);
  const Material bone = presets::cortical_bone(), dentin = presets::dentin();
  for (const double voxel : {0.1 * mm, 0.05 * mm}) {
    const auto add = [&](const std::string& name, const ToolHead& head, const Material& material, AngularSpeed speed) {
      all.push_back({name, head, material, voxel, speed});
    };
    for (const double R : {1 * mm, 2 * mm, 3 * mm}) {
      const std::string size = " R " + format_number(R / mm);
      for (const AngularSpeed speed : {40'000 * rpm, 0 * rpm}) {
        add("ball" + size, ball(R), bone, speed);
        add("flat" + size, flat(R), bone, speed);
      }
      add("cone" + size, cone(R), bone, 40'000 * rpm);
    }
    for (const char* material : {"enamel", "dentin", "trabecular_bone", "clay"})
      add("ball R 1", ball(1 * mm), find_preset(material), 40'000 * rpm);
    add("pear 1.2 mm", pear, dentin, 200'000 * rpm);
    for (const auto& [name, head] : {std::pair<std::string, ToolHead>{"ball R 2", ball(2 * mm)},
                                     {"flat R 2", flat(2 * mm)},
                                     {"cone R 2", cone(2 * mm)},
                                     {"pear 1.2 mm", pear}})
      all.push_back({name, head, dentin, voxel, 40'000 * rpm, false});
  }
  const auto find = [&](const std::string& name) -> Scene& {
    return *std::find_if(all.begin(), all.end(), [&](const Scene& scene) { return scene.name() == name; });
  };
  find("ball R 2, 0.1 mm, dentin, 40000 rpm, groove").goal = 14e-6;
  find("ball R 2, 0.05 mm, dentin, 40000 rpm, groove").goal = 60e-6;
  find("flat R 2, 0.1 mm, dentin, 40000 rpm, groove").goal = 20e-6;
  find("flat R 3, 0.05 mm, cortical_bone, stalled, coupled").goal = 1.5e-3;
  all.push_back({"ball R 1.5", ball(1.5 * mm), bone, 0.1 * mm, 40'000 * rpm, true, 4000, 0.2e-3, 0.999});
  all.push_back({"mastoid bur 5 mm", ball(2.5 * mm), bone, 0.1 * mm, 80'000 * rpm, true, 1000, 0.1e-3, 0.99});
  return all;
}

}  // namespace
}  // namespace hapticut::bench

int main(int argc, char** argv) {
  using namespace hapticut;
  using namespace hapticut::bench;
  const std::string part = argc > 1 ? argv[1] : "";
  if (argc > 2 || part.starts_with("-")) {
    std::fprintf(part == "--help" ? stdout : stderr, "Usage: bench_verdict [part of the names of scenes]\n");
    return part == "--help" ? 0 : 2;
  }
  const char* kernels = choose_kernels();
  if (kernels == nullptr) return 2;
  struct Row {
    Scene scene;
    Times times;
    [[nodiscard]] bool fits() const { return times.at(0.99) <= 1 / scene.rate; }
  };
  std::vector<Row> rows;
  for (const Scene& scene : scenes())
    if (scene.name().find(part) != std::string::npos) rows.push_back({scene, times_of(scene)});
  if (rows.empty()) {
    std::fprintf(stderr, "bench_verdict: no scene has \"%s\" in its name.\n", part.c_str());
    return 2;
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.times.at(0.99) > b.times.at(0.99); });
  const auto fit = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.fits(); });
  std::printf("%d of %d scenes of users fit into their tick (p99 of the processor time, kernels for %s).\n\n", int(fit),
              int(rows.size()), kernels);
  std::printf("| goal | at most [us] | measured [us] | met |\n|---|---|---|---|\n");
  for (const auto& [scene, times] : rows) {
    if (scene.goal == 0) continue;
    const double measured = times.at(scene.share);
    std::printf("| p%g: %s | %.0f | %.0f | %s |\n", 100 * scene.share, scene.name().c_str(), 1e6 * scene.goal,
                1e6 * measured, measured <= scene.goal ? "yes" : "**no**");
  }
  std::printf(
      "\n| scene | pressed [N] | voxels in contact | steps, Newton steps | p50 [us] | p99 [us] | max [us] | fits |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows)
    std::printf("| %s | %.1f | %.0f | %.1f, %.1f | %.0f | %.0f | %.0f | %s |\n", row.scene.name().c_str(),
                row.times.pressed, row.times.voxels, row.times.steps, row.times.newtons, 1e6 * row.times.at(0.5),
                1e6 * row.times.at(0.99), 1e6 * row.times.at(1), row.fits() ? "yes" : "**no**");
}
