// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// What drives a handpiece. docs/forces.md has what each can do and where that was published.
enum class MotorKind {
  ideal,           ///< keeps its speed whatever the cut takes
  air_turbine,     ///< dental high-speed handpiece: torque falls in a line from stall to free running
  electric,        ///< dental micromotor, with the contra-angle that makes its 40 000 turns a minute the head's
  surgical_drill,  ///< electric motor of otological and bone drills, up to 100 000 turns a minute
};

constexpr auto names_of(Of<MotorKind>) {
  using enum MotorKind;
  return std::array{
      Named{ideal, "ideal"},
      Named{air_turbine, "air_turbine"},
      Named{electric, "electric"},
      Named{surgical_drill, "surgical_drill"},
  };
}

/// What commonly turns a head so fast: a turbine above 200 000 turns a minute, an electric motor below.
/// @param speed  of either sign; 0: ideal
[[nodiscard]] inline MotorKind common_motor(AngularSpeed speed) {
  if (speed == 0) return MotorKind::ideal;
  return std::abs(speed) > 200e3 * units::rpm ? MotorKind::air_turbine : MotorKind::electric;
}

/// [rad/s] Beyond it there is no such handpiece.
[[nodiscard]] constexpr double max_speed(MotorKind motor) {
  if (motor == MotorKind::air_turbine) return 600e3 * units::rpm;
  if (motor == MotorKind::electric) return 250e3 * units::rpm;
  return motor == MotorKind::surgical_drill ? 150e3 * units::rpm : kMaxSpindleSpeed;
}

/// The spindle of a common handpiece: `common_spindle(MotorKind::electric, 40000 * units::rpm)`.
/// @param speed  [rad/s] free running, signed about +z of T; only an ideal one may stand
/// @throws Error when another than an ideal one shall stand, or when it is beyond any such motor
[[nodiscard]] inline Spindle common_spindle(MotorKind motor, AngularSpeed speed) {
  Spindle spindle{speed};
  validate(spindle);
  if (std::abs(speed) > max_speed(motor))
    throw Error("common_spindle: " + format_number(speed) + " rad/s are " + format_number(speed / units::rpm) +
                " turns a minute, and the motor " + std::string(name_or_null(motor)) + " has at most " +
                format_number(max_speed(motor) / units::rpm) +
                ". Write 40000 * units::rpm for 40000 turns a minute, or choose another motor.");
  if (motor == MotorKind::ideal) return spindle;
  if (speed == 0)
    throw Error(
        "a motor was given with a speed of 0. Give it its free-running speed, and stop it by set_spindle_speed(0).");
  // Of the motor itself; geared to the head it has less torque the faster that turns.
  const auto geared = [&](double motor_speed, double torque, double inertia) {
    const double gear = motor_speed * units::rpm / std::abs(speed);
    spindle.power_limit = 60;
    spindle.torque_limit = torque * gear;
    spindle.rotor_inertia = inertia * gear * gear;
  };
  if (motor == MotorKind::air_turbine) {
    spindle.droop = std::abs(speed) / (1.5 * units::N_mm);
    spindle.rotor_inertia = 1e-8;
  } else if (motor == MotorKind::electric) {
    geared(40e3, 30 * units::N_mm, 5e-8);
  } else {
    geared(80e3, 20 * units::N_mm, 5e-8);
  }
  return spindle;
}

/// The spindle of the handpiece that is common at such a speed; one that stands at 0.
/// @param speed  [rad/s] free running, signed about +z of T
/// @throws Error when it is beyond any such motor
[[nodiscard]] inline Spindle common_spindle(AngularSpeed speed) { return common_spindle(common_motor(speed), speed); }

}  // namespace hapticut
