// SPDX-License-Identifier: Apache-2.0
// The motor beyond its stall torque.
#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"

namespace hapticut::gestures {
namespace {

/// How often the spindle changes between nearly full speed and nearly zero from one tick to the next.
int toggles_in(const SceneLog& log, const Span& span, double full) {
  int count = 0;
  for (std::size_t n = span.first + 1; n < span.last; ++n) {
    const double a = std::abs(log.ticks[n - 1].speed), b = std::abs(log.ticks[n].speed);
    if (std::max(a, b) > 0.5 * full && std::min(a, b) < 0.05 * full) ++count;
  }
  return count;
}

/// [N] Sum of all rises of the force.
double rises_in(const SceneLog& log, const Span& span) {
  double sum = 0;
  for (std::size_t n = span.first + 1; n < span.last; ++n)
    sum += std::max(0.0, force_of(log.ticks[n]) - force_of(log.ticks[n - 1]));
  return sum;
}

void stall(Report& report) {
  struct Motor {
    std::string name;
    Spindle spindle;
    bool stalls;
  };
  constexpr double kFree = 300000 * rpm, kStallTorque = 2e-4;  // [rad/s], [N·m]: 1.57 W at most
  Spindle turbine{kFree * units::rad_per_s};
  turbine.droop = kFree / kStallTorque;
  Spindle limited{40000 * rpm};
  limited.power_limit = 3;
  for (const Motor& motor : {Motor{"air turbine, 300 000 rpm, stall 0.2 N mm", turbine, true},
                             Motor{"motor of 3 W, 40 000 rpm", limited, false}}) {
    report.scene(motor.name + ", ball 1 mm pushed into cortical bone, directly");
    const Tool ball = tool_of(SphereHead{0.5 * mm}, motor.spindle);
    ScriptedLoop loop(report, slab(1.2 * mm, 1.5 * mm, report.voxel(), presets::cortical_bone()), ball, Grip::directly);
    Hand hand(ball, Vec3(0, 0, 0.05 * mm));
    hand.move({0, 0, -0.45 * mm}, 0.0225);
    const double pushed = hand.seconds();
    hand.hold(0.1);
    const double held = hand.seconds();
    loop.play(hand.move({0, 0, 0.6 * mm}, 0.3).hold(0.05));
    const SceneLog& log = loop.log;
    const Span hold = log.within(pushed + 0.02, held), release = log.within(held, hand.seconds());
    report.at_most("toggles", toggles_in(log, {0, release.first}, motor.spindle.speed), motor.stalls ? 1 : 0, "",
                   "changes between full speed and none from tick to tick, until the release");
    report.at_most("toggles of the release", toggles_in(log, release, motor.spindle.speed), motor.stalls ? 1 : 0, "");
    if (motor.stalls)
      report.at_most("speed in the hold", log.max_of(hold, [](const Tick& t) { return std::abs(t.speed); }) / rpm,
                     0.01 * motor.spindle.speed / rpm, "rpm", "the spindle stands");
    if (motor.stalls)
      demand_steady(report, log, hold, "sd of the force in the hold");
    else
      report.at_most("rises of the force in the hold", 100 * rises_in(log, hold) / force_of(log.ticks[hold.first]), 1,
                     "%", "of the first force: the head cuts itself free");
    report.at_least("speed after the release", std::abs(log.ticks.back().speed) / rpm, 0.99 * motor.spindle.speed / rpm,
                    "rpm", "the spindle runs again");
    loop.judge();
  }
}

}  // namespace

std::vector<Gesture> motor_gestures() { return {{"G7", "push beyond the stall torque, hold, release", stall}}; }

}  // namespace hapticut::gestures
