// SPDX-License-Identifier: Apache-2.0
// The motor in the step: its load by the contact, and its speed under this load.
#include <algorithm>
#include <cmath>

#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr int kMaxTrials = 6;
constexpr double kSettled = 2e-3;                         // [1] of a speed
constexpr double kSteadyLoad = 0.1;                       // [1] of a torque
constexpr double kFasterHand = 1.25, kSlowHand = 0.5e-3;  // [1], [m/s] growth of the hand's speed without a trial
constexpr double kTurningSpeed = 1;                       // [m/s] of the rim of a head that is about to turn

}  // namespace

/// Finds, before anything is cut, the speed at which the motor's torque equals the torque of the contact. The load of
/// the sub-step before is good enough while neither it nor the hand changes much, and the motor has a reserve of twice
/// the torque.
void Simulation::State::drive_spindle(std::span<const FoundBlock> blocks, SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::drive_spindle);
  if (!motor.is_limited()) return;
  const Twist& path = sub_step.path_T;
  const double hand_speed = path.linear.norm() + path.angular.norm() * tool.head().reach();
  const bool known = load.settled && !motor.stalled() && motor.has_reserve(load.torque) &&
                     hand_speed <= kFasterHand * load.hand_speed + kSlowHand;
  load.hand_speed = hand_speed;
  load_spindle(blocks.empty() ? 0 : load.torque, sub_step);
  load.first_torque = load.torque;
  load.first_speed = motor.speed();
  if (known || blocks.empty()) return;
  // Secant steps on the residual torque. The first step, and steps with the wrong sign of the slope, are fixed-point
  // steps.
  double residual = 0, before = 0;  // [N·m] of the trial before, and its torque
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    const double torque = load.torque, speed = motor.speed();
    const double needed = torque_to_spin(sub_step, contact_stages.press(blocks, sub_step.head));
    load_spindle(needed, sub_step);
    if (std::abs(motor.speed() - speed) <= kSettled * std::abs(motor.speed())) return;
    const double slope = (needed - torque - residual) / (torque - before);
    if (trial > 0 && slope < 0 && !motor.stalled()) load_spindle(torque - (needed - torque) / slope, sub_step);
    residual = needed - torque;
    before = torque;
  }
}

/// Sets the speed of the motor under a torque, and the spin of the head.
void Simulation::State::load_spindle(double torque, SubStep& sub_step) noexcept {
  load.torque = torque;
  motor.drive(torque, sub_step.duration);
  set_spin(sub_step.head);
}

/// Sets the spin of the head, and what depends on it. A stalled head presses as if it were about to turn.
void Simulation::State::set_spin(HeadPlacement& head) const noexcept {
  head.cutting_share = cutting_share();
  HeadMotion& motion = head.motion;
  motion.spin = float(motor.stalled() ? turning_spin() : motor.speed());
  motion.crushes = !held && config.removal != RemovalLaw::none && contact_stages.materials().any_crushing();
  motion.removal = motor.stalled() ? RemovalLaw::none : config.removal;
  const bool is_off = motor.setting() == 0 && motor.speed() == 0 && !held;
  using Section = VoxelSection<float>;
  motion.min_width = is_off ? Section::kMinStandingWidth : Section::kMinWidth;
  motion.tooth_rate =
      contact_stages.materials().any_chips() ? float(tooth_rate(tool.cutter(), double(motion.spin))) : 0;
}

/// [rad/s] Fast enough, compared with a hand, that all of the head's surface slips along the spin.
double Simulation::State::turning_spin() const noexcept {
  return std::copysign(std::min(std::abs(motor.setting()), kTurningSpeed / tool.head().cutting_radius()),
                       motor.setting());
}

/// [1] The part of the cutting ratio that acts: what dry friction leaves of it at a slow head, or what the motor can
/// hold at a stalled one.
double Simulation::State::cutting_share() const noexcept {
  return motor.stalled() ? std::min(1.0, motor.stall_torque() / std::abs(load.torque))
                         : 1 - dry_friction_fraction(motor.speed(), tool.head().cutting_radius());
}

/// [N·m] Torque about +z that turns the head.
double Simulation::State::torque_to_spin(const SubStep& sub_step, const Encounter& encounter) const noexcept {
  const double torque = -encounter.resultant.wrench_T.torque.z();
  return motor.stalled() ? torque / sub_step.head.cutting_share : torque;
}

/// Books the work of a stalled head, which does not rub: the motor absorbs the work that the hand does against its
/// torque.
void Simulation::State::book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept {
  load.torque = torque_to_spin(sub_step, encounter);
  const double work = -encounter.resultant.wrench_T.torque.z() * turning_spin() * sub_step.duration;
  const double by_motor = work - encounter.energies.rubbing;
  result.energy.motor_work += by_motor;
  result.energy.turnover += std::abs(by_motor);
  encounter.energies.rubbing = 0;
}

void Simulation::State::advance_spindle(const SubStep& sub_step, const Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::advance_spindle);
  if (!motor.stalled()) load.torque = -encounter.resultant.wrench_T.torque.z();
  if (motor.loaded()) result.status |= StepStatus::power_limited;
  if (motor.stalled()) result.status |= StepStatus::spindle_stalled;
  motor.advance(load.torque, sub_step.duration);
  load.settled = encounter.resultant.voxels > 0 &&
                 std::abs(load.torque - load.first_torque) <= kSteadyLoad * std::abs(load.torque) &&
                 std::abs(motor.speed() - load.first_speed) <= kSettled * std::abs(motor.setting());
}

}  // namespace hapticut
