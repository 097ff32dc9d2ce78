// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/units.hpp"

/// @file
/// Closed forms without a C number: the alternative laws and the spindle.
namespace hapticut::closed_forms {

/// Table 5.1: force of a rigid flat punch on an elastic half space, `2 R E* d`.
/// @param modulus  [Pa] E* = E/(1 - nu^2)
/// @return [N]
[[nodiscard]] inline double flat_punch_force(double modulus, double R, double depth) { return 2 * R * modulus * depth; }

/// Table 5.1: force of a rigid ball, `(4/3) E* sqrt(R) d^1.5` (Hertz).
[[nodiscard]] inline double ball_punch_force(double modulus, double R, double depth) {
  return 4.0 / 3 * modulus * std::sqrt(R) * std::pow(depth, 1.5);
}

/// Table 5.1: force of a rigid cone, `(2/pi) E* tan(alpha) d^2` (Sneddon 1965).
[[nodiscard]] inline double cone_punch_force(double modulus, double half_angle, double depth) {
  return 2 / units::kPi * modulus * std::tan(half_angle) * depth * depth;
}

/// Force of the Hertzian burr of Agus et al. 2002, `C R^2 (h/R)^1.5`.
/// @param stiffness  [Pa] C
/// @param depth      [m] h
[[nodiscard]] inline double hertzian_burr_force(double stiffness, double R, double depth) {
  return stiffness * R * R * std::pow(depth / R, 1.5);
}

/// Speed of a spindle with droop in an axial cut that needs a constant power: the larger root of
/// `omega = omega_0 - droop P/omega`.
/// @param setting  [rad/s] omega_0 > 0
/// @param droop    [rad/(s·N·m)] >= 0
/// @param power    [W] P; above omega_0^2/(4 droop) the spindle stalls, and the result is NaN
/// @return [rad/s]
[[nodiscard]] inline double drooped_speed(double setting, double droop, double power) {
  return 0.5 * (setting + std::sqrt(setting * setting - 4 * droop * power));
}

}  // namespace hapticut::closed_forms
