// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace hapticut {

/// One drilling test: a head of radius R fed along its axis into material, at full diameter.
struct DrillingTest {
  double radius;         ///< [m] > 0
  double spindle_speed;  ///< [rad/s] not 0
  double feed_speed;     ///< [m/s] > 0
  double thrust;         ///< [N] > 0, steady
  double torque;         ///< [N·m] > 0, steady
};

/// The constants of a material with a kind of tool that explain drilling tests.
struct Calibration {
  double specific_cutting_energy = 0;  ///< [J/m^3] u
  double cutting_ratio = 0;            ///< [1] kappa
  double edge_pressure = 0;            ///< [Pa] p_e
  /// The tests tell edge from chip: the standard error of p_e is less than half of it, or than a tenth of the thrust.
  /// Otherwise p_e was taken as 0.
  bool edge_identified = false;
  /// The tests tell how much energy the chip costs: the standard error of u is less than half of it. Otherwise the edge
  /// carries nearly all of thrust and torque, and u may be 0.
  bool chip_identified = true;
  double thrust_residual = 0;  ///< [1] root mean square of (model - measured)/measured
  double torque_residual = 0;  ///< [1]
};

/// Steady thrust and torque of a flat head fed axially (C22).
struct AxialCutForce {
  double thrust;  ///< [N]      pi R^2 p_e + 2 pi R u v_f/(kappa omega)
  double torque;  ///< [N·m]    (2 pi/3) kappa p_e R^3 + u pi R^2 v_f/omega
};
[[nodiscard]] AxialCutForce axial_cut_force(const Calibration& constants, double radius, double spindle_speed,
                                            double feed_speed);

/// Fits u, kappa and p_e to drilling tests by least squares of the relative errors of thrust and torque.
///
/// For a given kappa both are linear in u and p_e, neither of which may be negative; kappa is searched from 0.001 to
/// 1000. One test, or several at the same feed per turn over radius, cannot tell edge from chip, nor can tests that
/// scatter more than the edge adds: then p_e = 0.
/// @throws Error when there is no test, a number of one is out of its range, or no kappa within that range explains
///         them
[[nodiscard]] Calibration calibrate(std::span<const DrillingTest> tests);

}  // namespace hapticut
