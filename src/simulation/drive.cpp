// SPDX-License-Identifier: Apache-2.0
// The motor in the step: its load by the contact, and its speed under this load.
#include <algorithm>
#include <cmath>

#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr int kMaxTrials = 6;
constexpr double kSettled = 2e-3;  // [1] relative change of a speed that counts as none

}  // namespace

/// Finds, before anything is cut, the speed at which the motor's torque equals the torque of the contact.
void Simulation::State::drive_spindle(std::span<const FoundBlock> blocks, SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::drive_spindle);
  const SpindleMotor& motor = spindle.motor();
  if (!motor.is_limited()) return;
  const Twist& path = sub_step.path_T;
  const double hand_speed = path.linear.norm() + path.angular.norm() * tool.head().reach();
  const bool known = spindle.knows_load(hand_speed);
  spindle.expect_load(blocks.empty() ? 0 : spindle.torque(), hand_speed, sub_step.duration);
  set_spin(sub_step.head);
  if (known || blocks.empty()) return;
  const auto load = [&](double torque) {
    spindle.load(torque, sub_step.duration);
    set_spin(sub_step.head);
  };
  // Secant steps on the residual torque. The first step, and steps with the wrong sign of the slope, are fixed-point
  // steps.
  double residual = 0, before = 0;  // [N·m] residual of the trial before, and its torque
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    const double torque = spindle.torque(), speed = motor.speed();
    const Encounter encounter = contact_stages.probe(blocks, sub_step.head);
    const double needed = spindle.torque_to_spin(-encounter.resultant.wrench_T.torque.z(), sub_step.head.cutting_share);
    load(needed);
    if (std::abs(motor.speed() - speed) <= kSettled * std::abs(motor.speed())) return;
    const double slope = (needed - torque - residual) / (torque - before);
    if (trial > 0 && slope < 0 && !motor.stalled()) load(torque - (needed - torque) / slope);
    residual = needed - torque;
    before = torque;
  }
}

/// Sets the spin of the head, and what depends on it. A stalled head presses as if it were about to turn.
void Simulation::State::set_spin(HeadPlacement& head) const noexcept {
  const double radius = tool.head().cutting_radius();
  const SpindleMotor& motor = spindle.motor();
  head.cutting_share = spindle.cutting_share(radius);
  head.motion.spin = float(motor.stalled() ? spindle.turning_spin(radius) : motor.speed());
  head.motion.crushes =
      !spindle.is_held() && config.removal != RemovalLaw::none && contact_stages.materials().any_crushing();
  head.motion.removal = motor.stalled() ? RemovalLaw::none : config.removal;
  using Section = VoxelSection<float>;
  head.motion.min_width = spindle.is_off() && !spindle.is_held() ? Section::kMinStandingWidth : Section::kMinWidth;
  head.motion.tooth_rate =
      contact_stages.materials().any_chips() ? float(tooth_rate(tool.cutter(), double(head.motion.spin))) : 0;
  head.motion.grain = contact_stages.grain();
  head.motion.floors = contact_stages.materials().any_floor();
  head.motion.fastest_chips = float(thickest_chip * tooth_rate(tool.cutter(), double(head.motion.spin)));
}

/// Books the work of a stalled head, which does not rub: the motor absorbs the work that the hand does against its
/// torque.
void Simulation::State::book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept {
  const double torque = -encounter.resultant.wrench_T.torque.z();
  spindle.keep_torque(spindle.torque_to_spin(torque, sub_step.head.cutting_share));
  const double spin = spindle.turning_spin(tool.head().cutting_radius());
  const double work = torque * spin * sub_step.duration;
  encounter.stall_work = work - encounter.energies.rubbing;
  encounter.energies.rubbing = 0;
}

void Simulation::State::advance_spindle(const SubStep& sub_step, const Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::advance_spindle);
  const SpindleMotor& motor = spindle.motor();
  if (!motor.stalled()) spindle.keep_torque(-encounter.resultant.wrench_T.torque.z());
  if (motor.loaded()) result.status |= StepStatus::power_limited;
  if (motor.stalled()) result.status |= StepStatus::spindle_stalled;
  spindle.advance(sub_step.duration, encounter.resultant.voxels > 0);
}

}  // namespace hapticut
