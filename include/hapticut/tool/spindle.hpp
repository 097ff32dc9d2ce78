// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// [rad/s] A million rpm: twice the speed of the fastest turbine. A larger value is most likely an rpm value passed as
/// rad/s.
inline constexpr double kMaxSpindleSpeed = 1e6 * units::rpm;

/// The motor that drives the head: `Spindle{40000 * units::rpm}`. Without limits it keeps its speed under any load;
/// `common_spindle` gives the limits of real handpieces.
struct Spindle {
  /// [rad/s] signed about +z of T; 0: the spindle is at rest and cuts nothing
  AngularSpeed speed = {};
  /// [W] power above which the spindle slows down
  double power_limit = std::numeric_limits<double>::infinity();
  double acceleration_limit = std::numeric_limits<double>::infinity();  ///< [rad/s^2] slope of the ramp to a new speed
  /// [rad/(s N m)] speed lost per load torque, as in an air turbine, which stalls at speed/droop
  double droop = 0;
  double torque_limit = std::numeric_limits<double>::infinity();  ///< [N m] a load above it stalls the spindle
  /// [kg m^2] inertia of all rotating parts, at the speed of the head; delays every change of the speed
  double rotor_inertia = 0;

  /// Whether a load changes the speed.
  [[nodiscard]] bool is_limited() const {
    return droop > 0 || rotor_inertia > 0 || std::isfinite(power_limit) || std::isfinite(torque_limit);
  }
};

constexpr auto fields_of(Of<Spindle>) {
  return std::tuple{
      field("speed", &Spindle::speed, "rad/s", Range::between(-kMaxSpindleSpeed, kMaxSpindleSpeed),
            "signed about +z of T; 0: the spindle is at rest and cuts nothing"),
      field("power_limit", &Spindle::power_limit, "W", Range::limit(), "power above which the spindle slows down"),
      field("acceleration_limit", &Spindle::acceleration_limit, "rad/s^2", Range::limit(),
            "slope of the ramp to a new speed"),
      field("droop", &Spindle::droop, "rad/(s N m)", Range::not_negative(),
            "speed lost per load torque, as in an air turbine, which stalls at speed/droop"),
      field("torque_limit", &Spindle::torque_limit, "N m", Range::limit(), "a load above it stalls the spindle"),
      field("rotor_inertia", &Spindle::rotor_inertia, "kg m^2", Range::not_negative(),
            "inertia of all rotating parts, at the speed of the head; delays every change of the speed"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const Spindle& spindle) {
  if (std::abs(spindle.speed) > kMaxSpindleSpeed && std::isfinite(spindle.speed))
    throw Error("Spindle::speed"_name + " [rad/s] = " + format_number(spindle.speed) + "; that is " +
                format_number(spindle.speed / units::rpm) +
                " rpm, and no spindle is faster than a million rpm. Write 40000 * " + "units::rpm"_name +
                " for 40000 rpm.");
  require_fields_within(spindle, "Spindle::");
}

/// The speed of a spindle from one sub-step to the next. With omega along the setting and the load M that brakes it,
///
///     J (omega - omega_0)/dt = min((|setting| - omega)/droop, torque_limit, power_limit/omega) - M
///
/// is solved for omega at the end of the sub-step, so that the motor never exceeds its torque and power. If the load
/// leaves less than a thousandth of the setting, the spindle stalls; it is then at rest until the load falls below
/// `stall_torque`. A rise of the speed, and a new setting, follow the ramp of the acceleration limit, through zero if
/// the setting changes sign. A load slows the spindle down at once, unless the rotor has inertia.
class SpindleMotor {
 public:
  explicit SpindleMotor(const Spindle& spindle)
      : spindle_(spindle),
        setting_(spindle.speed),
        start_(spindle.speed),
        ramped_(spindle.speed),
        speed_(spindle.speed) {}

  /// Sets the demanded speed [rad/s]. It is reached at once without an acceleration limit and without inertia.
  void set(double setting) noexcept {
    setting_ = setting;
    if (!std::isinf(spindle_.acceleration_limit)) return;
    ramped_ = setting;
    if (spindle_.rotor_inertia == 0) start_ = speed_ = setting, stalled_ = false;
  }

  /// Stops at once, without a ramp; the setting is then 0.
  void halt() noexcept {
    setting_ = start_ = ramped_ = speed_ = 0;
    loaded_ = stalled_ = false;
  }

  /// Finds the speed in a sub-step with a load torque. May be called again for the same sub-step with another torque.
  /// @param torque  [N·m] about +z; a load that brakes has the sign of the speed
  /// @param dt      [s] of the sub-step
  /// @realtime no allocation, no lock; O(1)
  void drive(double torque, double dt) noexcept {
    const double direction = ramped_ != 0 ? ramped_ : setting_ != 0 ? setting_ : start_;
    const double sign = std::copysign(1.0, direction), target = std::abs(ramped_), before = sign * start_;
    const double load = std::max(0.0, sign * torque);
    const bool runs_down = std::abs(setting_) < std::abs(start_) || setting_ * start_ < 0;
    stalled_ = loaded_ = false;
    double speed = target;
    if (spindle_.rotor_inertia > 0) {
      speed = with_inertia(before, load, target, dt);
    } else if (!runs_down) {  // while running down it may be faster than its new setting
      speed = std::min(target, sustained(load));
    }
    if (load > 0 && !runs_down) {
      const double full = std::min(std::abs(setting_), target);
      stalled_ = full > 0 && speed <= kStalledFraction * full && load > (1 - kStalledFraction) * stall_torque();
      loaded_ = stalled_ || (speed < kLoadedFraction * full && before >= speed) || is_at_limit(load, speed);
    }
    speed_ = stalled_ ? 0 : sign * speed;
  }

  /// Ends a sub-step in which the motor delivered `torque` [N·m]: continues the ramp, and sets `speed` to that of the
  /// next sub-step for the same torque.
  void advance(double torque, double dt) noexcept {
    start_ = speed_;
    const double reach = spindle_.acceleration_limit * dt;
    ramped_ = std::isinf(reach) ? setting_ : start_ + std::clamp(setting_ - start_, -reach, reach);
    drive(torque, dt);
  }

  [[nodiscard]] double speed() const { return speed_; }  ///< [rad/s] speed in the sub-step; 0 when stalled
  [[nodiscard]] AngularSpeed setting() const { return AngularSpeed::in_rad_per_s(setting_); }  ///< demanded speed
  [[nodiscard]] bool is_limited() const { return spindle_.is_limited(); }

  /// Whether the motor is at its power or torque limit, or below half of its setting, where a motor with droop has its
  /// largest power. More load stalls it.
  [[nodiscard]] bool loaded() const { return loaded_; }
  [[nodiscard]] bool stalled() const { return stalled_; }  ///< the load stops it

  /// [N·m] Torque of the motor at rest; infinite without droop and torque limit.
  [[nodiscard]] double stall_torque() const {
    const double line =
        spindle_.droop > 0 ? std::abs(setting_) / spindle_.droop : std::numeric_limits<double>::infinity();
    return std::min(line, spindle_.torque_limit);
  }

  /// Whether the motor stays below its limits, and above half of its setting, under twice the load `torque` [N·m]. Then
  /// the torque of the next sub-step will be close to the present one; otherwise it may exceed the limits by far.
  [[nodiscard]] bool has_reserve(double torque) const {
    const double load = 2 * std::abs(torque), speed = std::abs(setting_) - spindle_.droop * load;
    return setting_ == 0 || (speed > kLoadedFraction * std::abs(setting_) && load < spindle_.torque_limit &&
                             load * speed < spindle_.power_limit);
  }

  /// [1] Speed over the setting below which a load stalls the spindle.
  static constexpr double kStalledFraction = 1e-3;
  /// [1] Speed over the setting at which a motor with droop has its largest power.
  static constexpr double kLoadedFraction = 0.5;

 private:
  friend struct SimulationMemory;
  /// [rad/s] Speed at which the motor, without inertia, balances the torque `load`.
  [[nodiscard]] double sustained(double load) const {
    if (load > spindle_.torque_limit) return 0;
    const double min_load = 1e-12;  // [N·m] practically no load
    return std::max(
        0.0, std::min(std::abs(setting_) - spindle_.droop * load, spindle_.power_limit / std::max(load, min_load)));
  }

  /// [rad/s] Speed at the end of the sub-step with inertia: the smallest of the speeds that droop, torque limit and
  /// power limit lead to, since the torque of each falls with the speed.
  [[nodiscard]] double with_inertia(double before, double load, double target, double dt) const {
    const double inertia = spindle_.rotor_inertia / dt;  // [N m s]
    const double max_torque = spindle_.torque_limit;
    if (before < 0) {  // still rotates in the opposite direction: motor and load brake it
      const double line = spindle_.droop > 0 ? (target - before) / spindle_.droop : max_torque;
      return std::min(0.0, before + (std::min(max_torque, line) + load) / inertia);
    }
    const double line = spindle_.droop > 0
                            ? (target - spindle_.droop * (load - inertia * before)) / (1 + spindle_.droop * inertia)
                            : target;
    const double by_torque = before + (max_torque - load) / inertia;
    double speed = std::min(line, by_torque);
    if (std::isfinite(spindle_.power_limit)) {
      const double half = 0.5 * (load / inertia - before);
      speed = std::min(speed, -half + std::sqrt(half * half + spindle_.power_limit / inertia));
    }
    return std::max({0.0, speed, before - (max_torque + load) / inertia});
  }

  [[nodiscard]] bool is_at_limit(double load, double speed) const {
    return load >= spindle_.torque_limit || load * speed >= spindle_.power_limit * (1 - 1e-9);
  }

  Spindle spindle_;
  double setting_, start_, ramped_, speed_;  // [rad/s]; start_: at the end of the previous sub-step
  bool loaded_ = false, stalled_ = false;
};

}  // namespace hapticut
