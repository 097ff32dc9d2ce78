// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/core/description.hpp"

namespace hapticut {

/// [rad/s] ten million turns a minute: beyond any spindle, and well within the single precision of the contact.
inline constexpr double kFastestSpindle = 1e6;

/// The motor that turns the head.
struct Spindle {
  double speed = 0;
  double power_limit = std::numeric_limits<double>::infinity();
  double acceleration_limit = std::numeric_limits<double>::infinity();
  double droop = 0;
};

constexpr auto fields_of(Of<Spindle>) {
  return std::tuple{
      field("speed", &Spindle::speed, "rad/s", Range::between(-kFastestSpindle, kFastestSpindle),
            "signed about +z of T; 0: it stands and nothing is cut"),
      field("power_limit", &Spindle::power_limit, "W", Range::limit(), "above it the spindle slows down"),
      field("acceleration_limit", &Spindle::acceleration_limit, "rad/s^2", Range::limit(),
            "a new speed is reached on a ramp of this slope"),
      field("droop", &Spindle::droop, "rad/(s N m)", Range::not_negative(),
            "speed lost per load torque, as of an air turbine"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const Spindle& spindle) { require_fields_within(spindle, "Spindle::"); }

/// The speed of a spindle from one step to the next: its setting, reached on a ramp, less what the load takes.
///
///     sustained = min(|setting| - droop M, power_limit / M)      M: the load torque, where it brakes
///     speed     = sign(setting) min(sustained, ramped)           ramped: from the last speed, |slope| <= acceleration
///
/// The load slows the spindle down at once; recovering from it takes the ramp. Turning the other way ramps through
/// zero.
class SpindleMotor {
 public:
  explicit SpindleMotor(const Spindle& spindle) : spindle_(spindle), setting_(spindle.speed), speed_(spindle.speed) {}

  /// Asks for a speed. Reached at once without an acceleration limit.
  void set(double setting) noexcept {
    setting_ = setting;
    if (std::isinf(spindle_.acceleration_limit)) speed_ = setting;
  }

  /// Stands, whatever its ramp; the setting is 0.
  void halt() noexcept { setting_ = speed_ = 0; }

  /// The step of duration dt is over, in which the motor had to deliver `torque`.
  /// @param torque  [N·m] about +z; a load that brakes has the sign of the speed
  /// @param dt      [s]
  /// @realtime no allocation, no lock; O(1)
  void advance(double torque, double dt) noexcept {
    const double reach = spindle_.acceleration_limit * dt;
    const double ramped = std::isinf(reach) ? setting_ : speed_ + std::clamp(setting_ - speed_, -reach, reach);
    const double direction = ramped != 0 ? ramped : setting_;
    const double load = std::max(0.0, std::copysign(1.0, direction) * torque);
    const double least = 1e-12;  // [N·m] no load at all
    const double sustained = std::max(
        0.0, std::min(std::abs(setting_) - spindle_.droop * load, spindle_.power_limit / std::max(load, least)));
    // Running down, or down through zero, the spindle may be faster than its new setting allows.
    const bool runs_down = std::abs(setting_) < std::abs(speed_) || setting_ * speed_ < 0;
    const double bound = runs_down ? std::max(sustained, std::abs(ramped)) : sustained;
    loaded_ = !runs_down && sustained < std::min(std::abs(setting_), std::abs(ramped));
    speed_ = std::copysign(std::min(std::abs(ramped), bound), ramped);
  }

  [[nodiscard]] double speed() const { return speed_; }      ///< [rad/s] of the coming step
  [[nodiscard]] double setting() const { return setting_; }  ///< [rad/s] asked for
  [[nodiscard]] bool loaded() const { return loaded_; }      ///< the load holds it below its ramp and its setting

 private:
  Spindle spindle_;
  double setting_, speed_;  // [rad/s]
  bool loaded_ = false;
};

}  // namespace hapticut
