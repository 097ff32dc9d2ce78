// SPDX-License-Identifier: Apache-2.0
// A workpiece that moves: a drill follows the jaw of a patient. docs/other-scenes.md.
#include <algorithm>
#include <cmath>
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

/// A body that moves in the room R: its pose, and the velocity of its origin with its angular velocity, in R.
struct Moving {
  Pose X_RW;
  Twist V_RW;
};

/// A jaw that opens and closes by 3 degrees, twice a second, about a joint 60 mm behind the tooth.
Moving jaw_at(double time) {
  const Vec3 joint(-60 * mm, 0, 0), axis = Vec3::UnitY();
  const double phase = 2 * kPi * 2 * time, angle = 3 * deg * std::sin(phase);
  const double rate = 3 * deg * 2 * kPi * 2 * std::cos(phase);  // [rad/s]
  Moving jaw;
  jaw.X_RW.rotation = rotation_from_vector(angle * axis);
  jaw.X_RW.translation = joint - jaw.X_RW.rotation * joint;
  jaw.V_RW = {rate * axis.cross(jaw.X_RW.translation - joint), rate * axis};
  return jaw;
}

/// The hand as the workpiece sees it: its pose in W, and its velocity relative to the workpiece.
StepInput seen_from(const Moving& workpiece, const Pose& X_RH, const Twist& V_RH, double dt) {
  const Pose X_WR = workpiece.X_RW.inverse();
  const Twist carried = transport(workpiece.V_RW, X_RH.translation - workpiece.X_RW.translation);
  return {X_WR * X_RH,
          {X_WR.rotation * (V_RH.linear - carried.linear), X_WR.rotation * (V_RH.angular - carried.angular)},
          dt};
}

/// A wrench about Ho, from W to the room.
Wrench in_room(const Pose& X_RW, const Wrench& wrench_W) {
  return {X_RW.rotation * wrench_W.force, X_RW.rotation * wrench_W.torque};
}

Simulation tooth() {
  const Box box{Vec3(-4, -4, -3) * mm, Vec3(4, 4, 0) * mm};
  return {build_block(box, 0.1 * mm, presets::dentin()),
          Tool(SphereHead{0.8 * mm}, RayHandle{20 * mm}, common_spindle(40000 * rpm))};
}

int main() {
  std::cout.precision(3);
  Simulation moving = tooth(), still = tooth();
  const double dt = 1 * ms;
  const Pose X_TH = moving.tool().X_HT().inverse();
  Pose X_WH_before = Pose::from_translation(Vec3(0, 0, 0.85 * mm)) * X_TH, X_RH_before = jaw_at(0).X_RW * X_WH_before;
  double largest = 0, difference = 0;  // [N]
  for (int n = 1; n <= 500; ++n) {
    // The hand feeds the drill at 2 mm/s into the tooth, and follows the jaw.
    const Pose X_WH = Pose::from_translation(Vec3(0.5 * mm * n * dt, 0, 0.85 * mm - 2 * mm * n * dt)) * X_TH;
    const Moving jaw = jaw_at(n * dt);
    const Pose X_RH = jaw.X_RW * X_WH;

    const StepInput input = seen_from(jaw, X_RH, twist_between(X_RH_before, X_RH, dt), dt);
    const StepResult& felt = moving.step(input.X_WH, input.V_WH, input.dt);
    const Wrench on_hand = in_room(jaw.X_RW, {felt.force, felt.torque});  // on the patient acts its negative

    const Wrench at_rest = [&] {
      const StepResult& result = still.step(X_WH, twist_between(X_WH_before, X_WH, dt), dt);
      return Wrench{result.force, result.torque};
    }();
    largest = std::max(largest, on_hand.force.norm());
    difference = std::max(difference, (jaw.X_RW.rotation.transpose() * on_hand.force - at_rest.force).norm());
    X_WH_before = X_WH;
    X_RH_before = X_RH;
  }
  std::cout << "force up to " << largest << " N, at most " << difference << " N from that on a jaw at rest; removed "
            << moving.totals().removed_volume[1] / mm3 << " and " << still.totals().removed_volume[1] / mm3
            << " mm^3\n";
}
