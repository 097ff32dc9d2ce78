// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// Kinds of handpiece motors. docs/forces.md lists the data of each kind and its source.
enum class MotorKind {
  ideal,           ///< keeps its speed under any load
  air_turbine,     ///< dental high-speed handpiece: torque falls linearly from stall to free running
  electric,        ///< dental micromotor, with a contra-angle that gears its 40 000 rpm to the speed of the head
  surgical_drill,  ///< electric motor of otological and bone drills, up to 150 000 rpm
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

/// The usual kind of motor for a speed: a turbine above 200 000 rpm, an electric motor below, ideal for 0.
/// @param speed  [rad/s] of either sign
[[nodiscard]] inline MotorKind common_motor(AngularSpeed speed) {
  if (speed == 0) return MotorKind::ideal;
  return std::abs(speed) > 200e3 * units::rpm ? MotorKind::air_turbine : MotorKind::electric;
}

/// [rad/s] No handpiece of this kind is faster.
[[nodiscard]] constexpr double max_speed(MotorKind motor) {
  if (motor == MotorKind::air_turbine) return 600e3 * units::rpm;
  if (motor == MotorKind::electric) return 250e3 * units::rpm;
  return motor == MotorKind::surgical_drill ? 150e3 * units::rpm : kMaxSpindleSpeed;
}

/// The spindle of a common handpiece: `common_spindle(MotorKind::electric, 40000 * units::rpm)`.
/// @param speed  [rad/s] free running, signed about +z of T; 0 only for an ideal motor
/// @throws Error if the speed is 0 for a motor that is not ideal, or if no such motor reaches the speed
[[nodiscard]] inline Spindle common_spindle(MotorKind motor, AngularSpeed speed) {
  Spindle spindle{speed};
  validate(spindle);
  if (std::abs(speed) > max_speed(motor))
    throw Error("common_spindle: " + format_number(speed) + " rad/s are " + format_number(speed / units::rpm) +
                " rpm, but a motor " + std::string(name_or_null(motor)) + " has at most " +
                format_number(max_speed(motor) / units::rpm) + " rpm. Write 40000 * " + "units::rpm"_name +
                " for 40000 rpm, or choose another motor.");
  if (motor == MotorKind::ideal) return spindle;
  if (speed == 0)
    throw Error("a motor has a speed of 0; must not be 0. Give its free-running speed; a simulation can halt it.");
  // Data of the motor itself; the gear trades torque for speed.
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

/// The spindle of the usual handpiece for a speed; an ideal spindle at rest for 0.
/// @param speed  [rad/s] free running, signed about +z of T
/// @throws Error if no such motor reaches the speed
[[nodiscard]] inline Spindle common_spindle(AngularSpeed speed) { return common_spindle(common_motor(speed), speed); }

}  // namespace hapticut
