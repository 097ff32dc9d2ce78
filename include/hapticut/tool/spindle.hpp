// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// [rad/s] a million turns a minute: twice as fast as the fastest turbine, and where turns a minute were meant.
inline constexpr double kMaxSpindleSpeed = 1e6 * units::rpm;

/// The motor that turns the head: `Spindle{40000 * units::rpm}`. Without limits it keeps its speed whatever the cut
/// takes; `common_spindle` has those of real handpieces.
struct Spindle {
  AngularSpeed speed = {};
  double power_limit = std::numeric_limits<double>::infinity();
  double acceleration_limit = std::numeric_limits<double>::infinity();
  double droop = 0;
  double torque_limit = std::numeric_limits<double>::infinity();
  double rotor_inertia = 0;

  /// Whether a load changes its speed.
  [[nodiscard]] bool is_limited() const {
    return droop > 0 || rotor_inertia > 0 || std::isfinite(power_limit) || std::isfinite(torque_limit);
  }
};

constexpr auto fields_of(Of<Spindle>) {
  return std::tuple{
      field("speed", &Spindle::speed, "rad/s", Range::between(-kMaxSpindleSpeed, kMaxSpindleSpeed),
            "signed about +z of T; 0: it stands and nothing is cut"),
      field("power_limit", &Spindle::power_limit, "W", Range::limit(), "above it the spindle slows down"),
      field("acceleration_limit", &Spindle::acceleration_limit, "rad/s^2", Range::limit(),
            "a new speed is reached on a ramp of this slope"),
      field("droop", &Spindle::droop, "rad/(s N m)", Range::not_negative(),
            "speed lost per load torque, as of an air turbine, which stalls at speed/droop"),
      field("torque_limit", &Spindle::torque_limit, "N m", Range::limit(), "a load above it stalls the spindle"),
      field("rotor_inertia", &Spindle::rotor_inertia, "kg m^2", Range::not_negative(),
            "of all that turns, as the head turns; keeps the speed up for a moment, and runs down with it"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const Spindle& spindle) {
  if (std::abs(spindle.speed) > kMaxSpindleSpeed && std::isfinite(spindle.speed))
    throw Error(
        "Spindle::speed [rad/s] = " + format_number(spindle.speed) + "; that is " +
        format_number(spindle.speed / units::rpm) +
        " turns a minute, and no spindle is faster than a million. Write 40000 * units::rpm for 40000 turns a minute.");
  require_fields_within(spindle, "Spindle::");
}

/// The speed of a spindle from one sub-step to the next. With omega along the setting and the load M that brakes it,
///
///     J (omega - omega_0)/dt = min((|setting| - omega)/droop, torque_limit, power_limit/omega) - M
///
/// is solved for omega at the end, so that a load meets no more torque and power than the motor has. A load that leaves
/// less than a thousandth of the setting stalls it, and it stands until the load falls below `stall_torque`. A rise of
/// the speed, and a new setting, take the ramp of the acceleration limit, through zero where the setting changes sign;
/// a load slows the spindle down at once, but for the inertia.
class SpindleMotor {
 public:
  explicit SpindleMotor(const Spindle& spindle)
      : spindle_(spindle),
        setting_(spindle.speed),
        start_(spindle.speed),
        ramped_(spindle.speed),
        speed_(spindle.speed) {}

  /// Asks for a speed. Reached at once without an acceleration limit, a torque limit and inertia.
  void set(double setting) noexcept {
    setting_ = setting;
    if (!std::isinf(spindle_.acceleration_limit)) return;
    ramped_ = setting;
    if (spindle_.rotor_inertia == 0) start_ = speed_ = setting, stalled_ = false;
  }

  /// Stands, whatever its ramp; the setting is 0.
  void halt() noexcept {
    setting_ = start_ = ramped_ = speed_ = 0;
    loaded_ = stalled_ = false;
  }

  /// The speed in a sub-step that takes a torque. May be asked again for the same sub-step with another torque.
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
    } else if (!runs_down) {  // running down it may be faster than its new setting allows
      speed = std::min(target, sustained(load));
    }
    if (load > 0 && !runs_down) {
      const double full = std::min(std::abs(setting_), target);
      stalled_ = full > 0 && speed <= kStalledShare * full && load > (1 - kStalledShare) * stall_torque();
      loaded_ = stalled_ || (speed < kLoadedShare * full && before >= speed) || is_at_limit(load, speed);
    }
    speed_ = stalled_ ? 0 : sign * speed;
  }

  /// The sub-step is over, in which the motor had to deliver `torque`: the ramp goes on, and `speed` is that of the
  /// coming sub-step, if that takes the same.
  void advance(double torque, double dt) noexcept {
    start_ = speed_;
    const double reach = spindle_.acceleration_limit * dt;
    ramped_ = std::isinf(reach) ? setting_ : start_ + std::clamp(setting_ - start_, -reach, reach);
    drive(torque, dt);
  }

  [[nodiscard]] double speed() const { return speed_; }  ///< [rad/s] of the sub-step; 0 where it is stalled
  [[nodiscard]] AngularSpeed setting() const { return AngularSpeed::in_rad_per_s(setting_); }  ///< asked for
  [[nodiscard]] bool is_limited() const { return spindle_.is_limited(); }

  /// Whether it runs at its power or torque limit, or below the half of its setting, where a line of droop has its
  /// largest power: more load stalls it.
  [[nodiscard]] bool loaded() const { return loaded_; }
  [[nodiscard]] bool stalled() const { return stalled_; }  ///< the load holds it

  /// [N·m] that it has while it stands; infinite without droop and torque limit.
  [[nodiscard]] double stall_torque() const {
    const double line =
        spindle_.droop > 0 ? std::abs(setting_) / spindle_.droop : std::numeric_limits<double>::infinity();
    return std::min(line, spindle_.torque_limit);
  }

  /// Whether a load of twice `torque` [N·m] would still leave it below its limits, and its speed above the half of the
  /// setting. Then what it takes now is nearly what it takes a sub-step later, and else it may be far more than it has.
  [[nodiscard]] bool has_reserve(double torque) const {
    const double load = 2 * std::abs(torque), speed = std::abs(setting_) - spindle_.droop * load;
    return setting_ == 0 || (speed > kLoadedShare * std::abs(setting_) && load < spindle_.torque_limit &&
                             load * speed < spindle_.power_limit);
  }

  static constexpr double kStalledShare = 1e-3;  ///< [1] of the setting, below which a load stalls the spindle
  static constexpr double kLoadedShare = 0.5;    ///< [1] of the setting, where a line of droop has its largest power

 private:
  /// [rad/s] at which the motor without inertia has the torque `load`.
  [[nodiscard]] double sustained(double load) const {
    if (load > spindle_.torque_limit) return 0;
    const double least = 1e-12;  // [N·m] no load at all
    return std::max(0.0,
                    std::min(std::abs(setting_) - spindle_.droop * load, spindle_.power_limit / std::max(load, least)));
  }

  /// The same with inertia: the least of where the line, the torque limit and the power limit lead to, for each falls
  /// with the speed.
  [[nodiscard]] double with_inertia(double before, double load, double target, double dt) const {
    const double inertia = spindle_.rotor_inertia / dt, most = spindle_.torque_limit;  // [N m s]
    if (before < 0) {  // turns the other way still: motor and load brake it
      const double line = spindle_.droop > 0 ? (target - before) / spindle_.droop : most;
      return std::min(0.0, before + (std::min(most, line) + load) / inertia);
    }
    const double line = spindle_.droop > 0
                            ? (target - spindle_.droop * (load - inertia * before)) / (1 + spindle_.droop * inertia)
                            : target;
    const double by_torque = before + (most - load) / inertia;
    double speed = std::min(line, by_torque);
    if (std::isfinite(spindle_.power_limit)) {
      const double half = 0.5 * (load / inertia - before);
      speed = std::min(speed, -half + std::sqrt(half * half + spindle_.power_limit / inertia));
    }
    return std::max({0.0, speed, before - (most + load) / inertia});
  }

  [[nodiscard]] bool is_at_limit(double load, double speed) const {
    return load >= spindle_.torque_limit || load * speed >= spindle_.power_limit * (1 - 1e-9);
  }

  Spindle spindle_;
  double setting_, start_, ramped_, speed_;  // [rad/s]; start_: at the end of the sub-step before
  bool loaded_ = false, stalled_ = false;
};

}  // namespace hapticut
