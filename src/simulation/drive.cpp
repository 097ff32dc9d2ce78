// SPDX-License-Identifier: Apache-2.0
// The motor in the step: what the contact takes of it, and how fast it turns the head then.
#include <algorithm>
#include <cmath>

#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr int kMaxTrials = 6;
constexpr double kSettled = 2e-3;                         // [1] of a speed
constexpr double kSteadyLoad = 0.1;                       // [1] of a torque
constexpr double kFasterHand = 1.25, kSlowHand = 0.5e-3;  // [1], [m/s] what a hand may hurry without a trial
constexpr double kTurningSpeed = 1;                       // [m/s] of the rim of a head that is about to turn

}  // namespace

/// Finds, before anything is cut, the speed at which the motor has the torque that the contact takes at that speed.
/// What the load of the sub-step before tells is enough while neither it nor the hand changes much, and the motor has
/// twice as much to give.
void Simulation::State::drive_spindle(std::span<const CuttableBlock> blocks, SubStep& sub_step) noexcept {
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
  // Secants on what a torque asks for too much; the first, and those that point elsewhere, are plain repetition.
  double lack = 0, before = 0;  // [N·m] of the trial before, and its torque
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    const double torque = load.torque, speed = motor.speed();
    const double taken = torque_to_spin(contact_stages.press(blocks, sub_step.head));
    load_spindle(taken, sub_step);
    if (std::abs(motor.speed() - speed) <= kSettled * std::abs(motor.speed())) return;
    const double slope = (taken - torque - lack) / (torque - before);
    if (trial > 0 && slope < 0 && !motor.stalled()) load_spindle(torque - (taken - torque) / slope, sub_step);
    lack = taken - torque;
    before = torque;
  }
}

/// The speed of the motor under a torque, and the head with it.
void Simulation::State::load_spindle(double torque, SubStep& sub_step) noexcept {
  load.torque = torque;
  motor.drive(torque, sub_step.duration);
  update_cutting_share();
  set_spin(sub_step.head.motion);
}

/// A stalled head presses as if it were about to turn.
void Simulation::State::set_spin(HeadMotion& motion) const noexcept {
  motion.spin = float(motor.stalled() ? turning_spin() : motor.speed());
  motion.crushes = !held && config.removal != RemovalLaw::none && contact_stages.any_crushing();
  motion.removal = motor.stalled() ? RemovalLaw::none : config.removal;
  motion.tooth_rate = contact_stages.any_chips() ? float(tooth_rate(tool.cutter(), double(motion.spin))) : 0;
}

/// [rad/s] Fast enough beside a hand that all of the head's surface slips along the spin.
double Simulation::State::turning_spin() const noexcept {
  return std::copysign(std::min(std::abs(motor.setting()), kTurningSpeed / tool.head().cutting_radius()),
                       motor.setting());
}

/// How much of the cutting ratio acts: all but what dry friction has of a slow head, or what the motor can hold.
void Simulation::State::update_cutting_share() noexcept {
  cutting_share = motor.stalled() ? std::min(1.0, motor.stall_torque() / std::abs(load.torque))
                                  : 1 - standing_share(motor.speed(), tool.head().cutting_radius());
  contact_stages.set_cutting_share(cutting_share);
}

/// [N·m] about +z
double Simulation::State::torque_to_spin(const Encounter& encounter) const noexcept {
  const double torque = -encounter.resultant.wrench_T.torque.z();
  return motor.stalled() ? torque / cutting_share : torque;
}

/// Nothing turns against the material of a stalled head: what its hand does against the motor's torque, the motor
/// takes.
void Simulation::State::book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept {
  load.torque = torque_to_spin(encounter);
  const double turning = -encounter.resultant.wrench_T.torque.z() * turning_spin() * sub_step.duration;
  const double by_motor = turning - encounter.energies.rubbing;
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
  update_cutting_share();
}

}  // namespace hapticut
