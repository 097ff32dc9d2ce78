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
/// @param speed  [turns a minute] of either sign; 0: ideal
[[nodiscard]] inline MotorKind common_motor(double speed) {
  if (speed == 0) return MotorKind::ideal;
  return std::abs(speed) > 200e3 ? MotorKind::air_turbine : MotorKind::electric;
}

/// The spindle of a common handpiece.
/// @param speed  [turns a minute] free running, signed about +z of T; only an ideal one may stand
/// @throws Error when it is 0 or beyond any spindle
[[nodiscard]] inline Spindle common_spindle(MotorKind motor, double speed) {
  Spindle spindle = Spindle::rpm(speed);
  validate(spindle);
  if (motor == MotorKind::ideal) return spindle;
  if (speed == 0)
    throw Error(
        "a motor was given with a speed of 0. Give it its free-running speed, and stop it by set_spindle_speed(0).");
  // Of the motor itself; geared to the head it has less torque the faster that turns.
  const auto geared = [&](double motor_speed, double torque, double inertia) {
    const double gear = motor_speed / std::abs(speed);
    spindle.power_limit = 60;
    spindle.torque_limit = torque * gear;
    spindle.rotor_inertia = inertia * gear * gear;
  };
  if (motor == MotorKind::air_turbine) {
    spindle.droop = std::abs(spindle.speed) / (1.5 * units::N_mm);
    spindle.rotor_inertia = 1e-8;
  } else if (motor == MotorKind::electric) {
    geared(40e3, 30 * units::N_mm, 5e-8);
  } else {
    geared(80e3, 20 * units::N_mm, 5e-8);
  }
  return spindle;
}

/// The same with the motor that is common at such a speed.
[[nodiscard]] inline Spindle common_spindle(double speed) { return common_spindle(common_motor(speed), speed); }

}  // namespace hapticut
