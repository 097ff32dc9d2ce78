// SPDX-License-Identifier: Apache-2.0
// Friction, spindle and effects: C17, C18 and formulas without a number.
#include <algorithm>
#include <cmath>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/force/limit_surface.hpp"

namespace hapticut::experiments {
namespace {

/// A drag from rest at constant normal force.
struct Drag {
  double work = 0, peak = 0, plateau = 0;  // [J], [N]
  double unbooked = 0;                     // [J] neither stored nor dissipated

  /// @param lead  0: force at the middle of a step; 0.5: at its end
  Drag(const DryFriction& friction, double normal, double length, int steps, double lead) {
    LimitSurface anchor;
    const SpreadFriction contact = SpreadFriction::at_point(Vec3(0, 0, normal), friction);
    const Vec3 move(length / steps, 0, 0);
    for (int i = 0; i < steps; ++i) {
      const auto moved = anchor.move(contact, {move, Vec3::Zero()}, 1, lead);
      plateau = moved.wrench.force.norm();
      peak = std::max(peak, plateau);
      work -= moved.wrench.force.dot(move);
      unbooked -= moved.dissipated;
    }
    unbooked += work - anchor.stored();
  }
};

std::vector<Check> stick_slip() {
  constexpr double kDynamic = 0.3, kAnchor = 500, kNormal = 2, kLength = 10 * mm;  // [1], [N/m], [N], [m]
  const Drag fine({0.45, kDynamic, kAnchor}, kNormal, kLength, 20000, 0);
  Largest off;
  for (const double ratio : {0.3, 0.4, 0.5})
    for (const int steps : {500, 5000})
      for (const double lead : {0.0, 0.5}) {
        const Drag drag({ratio, kDynamic, kAnchor}, kNormal, kLength, steps, lead);
        const double step = kLength / steps, most = forms::drag_peak(ratio, kNormal);
        off.add(drag.work - forms::drag_work(ratio, kDynamic, kAnchor, kNormal, kLength), (1 + lead) * most * step);
        off.add(most - drag.peak, 2 * kAnchor * step);
        off.add(std::max(0.0, drag.peak / most - 1), 1e-12);
        off.add(drag.plateau - forms::drag_plateau(kDynamic, kNormal), 1e-12);
        off.add(drag.unbooked, 1e-12);
      }
  return {{"C17 work", "drag from rest over 10 mm: work", "J",
           forms::drag_work(0.45, kDynamic, kAnchor, kNormal, kLength), fine.work, kFineSteps},
          {"C17 peak", "drag: largest force before the contact slips", "N", forms::drag_peak(0.45, kNormal), fine.peak,
           kInvariant},
          {"C17 plateau", "drag: force while the contact slides", "N", forms::drag_plateau(kDynamic, kNormal),
           fine.plateau, kDoublePrecision},
          off.check("C17 drags", "12 drags in longer steps: work, peak, plateau, unbooked energy; error",
                    "the step in which the contact slips")};
}

std::vector<Check> friction_in_the_step() {
  SimulationConfig config = static_config();
  config.max_sweep = 64;
  config.friction = DryFriction{0.45, 0.3, 2000};
  // On a grid whose lines match neither the surface nor the head.
  Simulation simulation(
      build_block({Vec3(-2.23, -2.267, -0.661) * mm, Vec3(2.23, 2.23, 0) * mm}, 0.1 * mm, plain_material()),
      Tool(FlatHead{1 * mm, 2 * mm, FlatRule::bottom_only}), config);
  Pose pose = Pose::from_translation(Vec3(-0.5 * mm, 0, 0));
  for (int i = 0; i < 600; ++i) {
    if (i < 100)
      pose.translation.z() -= 3e-6;
    else
      pose.translation.x() += 2e-6;
    (void)simulation.step(pose, {}, 1e-3);
  }
  const StepResult& result = simulation.last_result();
  return {{"friction ratio", "standing flat head dragged over a half space: tangential over normal force", "1", 0.3,
           -result.force.x() / result.force.z(), kPartialVoxels},
          {"friction ledger", "energy balance of the drag", "J", 0, result.energy.imbalance(), kInvariant,
           result.energy.hand_work}};
}

std::vector<Check> effects() {
  const double rate = 500, size = 5;  // [N/s], [N]
  const Vec3 target(3, 4, 0);
  double across = 0;
  const auto time_to_reach = [&](double dt) {
    Vec3 force = Vec3::Zero();
    double time = 0;
    for (; (force - target).norm() > 1e-9; time += dt) {
      force = growth_limited(force, target, rate * dt);
      across = std::max(across, force.cross(target).norm());
    }
    return time;
  };
  const double slow = time_to_reach(1e-3), fast = time_to_reach(1e-4);
  VibrationPhase phase;
  const Vibration vibration;
  double squares = 0;
  for (int i = 0; i < 10000; ++i) squares += std::pow(phase.advance(vibration, true, 0, 1e-3), 2) / 10000;
  const Gravity tool{0.1, Vec3(0, 0, -0.05)};
  const Mat3 level = rotation_from_vector(Vec3(0, kPi / 2, 0));
  return {{"C18 at 1 kHz", "growth limit: time to grow by 5 N at 500 N/s", "s", forms::growth_time(size, rate), slow,
           kDoublePrecision},
          {"C18 at 10 kHz", "growth limit with a tenth of the step: time to grow", "s", forms::growth_time(size, rate),
           fast, kDoublePrecision},
          {"C18 direction", "growth limit: largest component across the direction of growth", "N^2", 0, across,
           kDoublePrecision, size},
          {"vibration", "root mean square of 0.3 N at 150 Hz, 1 kHz", "N", 0.3 / std::sqrt(2.0), std::sqrt(squares),
           kInvariant},
          {"gravity", "torque of 0.1 kg, 50 mm from the hand, level", "N m", 0.1 * 9.80665 * 0.05,
           gravity_wrench(tool, level).torque.norm(), kDoublePrecision}};
}

std::vector<Check> droop() {
  const double speed = 2e-3, setting = 2000;
  const double power = forms::cutting_power({3e8, 0.5, setting, speed}, kPi * kR * kR * speed);
  const double droop = 0.15 * setting * setting / power;
  std::vector<Check> checks;
  for (const double sign : {1.0, -1.0}) {
    Spindle spindle{sign * setting * units::rad_per_s};
    spindle.droop = droop;
    SimulationConfig config;
    config.reference_stiffness = 1e14;
    Simulation simulation(build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, plain_material()),
                          Tool(FlatHead{kR, 4 * mm}, RayHandle{0}, spindle), config);
    double mean = 0;
    for (int i = 1; i <= 800; ++i) {
      const Vec3 at(0.029 * mm, 0.011 * mm, -speed * kTick * i);
      const StepResult& result = simulation.step(Pose::from_translation(at), {Vec3(0, 0, -speed), Vec3::Zero()}, kTick);
      if (i > 400) mean += result.spindle.speed / 400;
    }
    checks.push_back({sign > 0 ? "droop" : "droop, other way",
                      sign > 0 ? "speed of a spindle that loses speed with its torque, flat head fed axially"
                               : "speed of a spindle that loses speed with its torque, other direction",
                      "rad/s", sign * forms::drooped_speed(setting, droop, power), mean, kPartialVoxels});
  }
  return checks;
}

}  // namespace

std::vector<Experiment> term_experiments() {
  return {// Proves: sticking.
          {"stick and slip", stick_slip},
          {"friction in the step", friction_in_the_step},
          // Proves: growth limit.
          {"effects", effects},
          // Proves: droop.
          {"droop", droop}};
}

}  // namespace hapticut::experiments
