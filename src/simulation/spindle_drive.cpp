// SPDX-License-Identifier: Apache-2.0
// The motor of the spindle from step to step: its settings, its load, and its speed under this load.
#include "simulation/loaded_spindle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hapticut/force/friction.hpp"

namespace hapticut {
namespace {

constexpr double kSteadyLoad = 0.1;                       // [1] relative change of a torque that counts as none
constexpr double kSteadySpeed = 2e-3;                     // [1] relative change of a speed that counts as none
constexpr double kFasterHand = 1.25, kSlowHand = 0.5e-3;  // [1], [m/s] growth of the hand's speed without a trial
constexpr double kTurningSpeed = 1;                       // [m/s] speed of the rim of a head that is about to turn

}  // namespace

// --- between steps --------------------------------------------------------------------------------------------------

void SpindleDrive::set_speed(AngularSpeed speed) {
  validate(Spindle{speed});
  held_setting_ = speed;
  if (!held_) start(speed);
}

void SpindleDrive::halt() noexcept {
  held_setting_ = 0;
  stop();
}

void SpindleDrive::hold(bool hold) noexcept {
  if (hold == held_) return;
  held_ = hold;
  if (hold) {
    held_setting_ = motor_.setting();
    stop();
  } else {
    start(held_setting_);
  }
}

void SpindleDrive::stop() noexcept {
  motor_.halt();
  halted_ = true;
  set_ = false;
}

/// @param setting  [rad/s]
void SpindleDrive::start(double setting) noexcept {
  motor_.set(setting);
  set_ = true;
}

void LoadedSpindle::exchange(const Spindle& spindle) noexcept {
  motor_ = SpindleMotor(spindle);
  halted_ = set_ = false;  // the other motor was
  held_setting_ = motor_.setting();
  if (held_) stop();
  load_ = {};
}

// --- in a step ------------------------------------------------------------------------------------------------------

void LoadedSpindle::begin_step() noexcept {
  was_halted_ = std::exchange(halted_, false);
  was_set_ = std::exchange(set_, false);
  if (was_halted_) load_ = {};
}

/// Whether the load of the sub-step before is good enough: neither it nor the hand changes much, and the motor has a
/// reserve of twice the torque.
bool LoadedSpindle::knows_load(double hand_speed) const noexcept {
  return load_.settled && !motor_.stalled() && motor_.has_reserve(load_.torque) &&
         hand_speed <= kFasterHand * load_.hand_speed + kSlowHand;
}

/// Finds the speed of the motor under a torque [N·m].
void LoadedSpindle::load(double torque, double dt) noexcept {
  load_.torque = torque;
  motor_.drive(torque, dt);
}

/// Begins a sub-step with a predicted torque [N·m].
void LoadedSpindle::expect_load(double torque, double hand_speed, double dt) noexcept {
  load_.hand_speed = hand_speed;
  load(torque, dt);
  load_.first_torque = torque;
  load_.first_speed = motor_.speed();
}

/// Ends a sub-step with the load that the contact had.
void LoadedSpindle::advance(double dt, bool in_contact) noexcept {
  motor_.advance(load_.torque, dt);
  load_.settled = in_contact && std::abs(load_.torque - load_.first_torque) <= kSteadyLoad * std::abs(load_.torque) &&
                  std::abs(motor_.speed() - load_.first_speed) <= kSteadySpeed * std::abs(motor_.setting());
}

/// [1] The part of the cutting ratio that acts: what dry friction leaves of it at a slow head, or what the motor can
/// hold at a stalled one.
/// @param radius  [m] of the head
double LoadedSpindle::cutting_share(double radius) const noexcept {
  return motor_.stalled() ? std::min(1.0, motor_.stall_torque() / std::abs(load_.torque))
                          : 1 - dry_friction_fraction(motor_.speed(), radius);
}

/// [rad/s] The speed of a stalled head that is about to turn: fast enough, compared with a hand, that all of the head's
/// surface slips along the spin.
double LoadedSpindle::turning_spin(double radius) const noexcept {
  return std::copysign(std::min(std::abs(motor_.setting()), kTurningSpeed / radius), motor_.setting());
}

}  // namespace hapticut
