// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// One drilling test: a head of radius R fed along its axis into material, at full diameter.
struct DrillingTest {
  double radius;               ///< [m] > 0
  AngularSpeed spindle_speed;  ///< not 0
  double feed_speed;           ///< [m/s] > 0, at most kMaxFeed
  double thrust;               ///< [N] steady; 0: not measured
  double torque;               ///< [N·m] steady; 0: not measured
  double lips = 2;             ///< [1] z > 0
};

/// What is fitted beside u and kappa: how thrust and torque do not go to zero with the chip.
enum class ChipTerm {
  edge_length,   ///< h_e, an edge force per length of lip
  size_length,   ///< h_s, more energy for thinner chips
  edge_pressure  ///< p_e, a pressure on the whole section
};

constexpr auto names_of(Of<ChipTerm>) {
  using enum ChipTerm;
  return std::array{
      Named{edge_length, "edge_length"},
      Named{size_length, "size_length"},
      Named{edge_pressure, "edge_pressure"},
  };
}

/// The constants of a material with a kind of tool that explain drilling tests.
struct Calibration {
  double specific_cutting_energy = 0;  ///< [J/m^3] u
  double cutting_ratio = 0;            ///< [1] kappa
  double edge_pressure = 0;            ///< [Pa] p_e
  double edge_length = 0;              ///< [m] h_e
  double size_length = 0;              ///< [m] h_s
  /// The tests tell edge from chip: the standard error of the term that was asked for is less than half of it, or than
  /// a tenth of thrust and torque; or it is the one constant with which as many numbers as there are constants fit
  /// exactly. Otherwise a pressure or size length was taken as 0.
  bool edge_identified = false;
  /// The edge length is kAssumedEdgeLength, because the tests neither tell it nor contradict that.
  bool edge_assumed = false;
  /// The tests tell how much energy the chip costs: the standard error of u is less than half of it. Otherwise the edge
  /// carries nearly all of thrust and torque, and u may be 0.
  bool chip_identified = true;
  /// Thrust and torque were both measured. Otherwise kappa was taken as kAssumedRatio: thrusts alone fix u/kappa only.
  bool ratio_identified = true;
  /// More numbers were measured than constants fitted. Otherwise they fit whatever they are, and nothing checks them.
  bool checked = true;
  double thrust_residual = 0;  ///< [1] root mean square of (model - measured)/measured, of those measured
  double torque_residual = 0;  ///< [1]
};

inline constexpr double kAssumedRatio = 0.5;  ///< [1] kappa where tests do not tell: that of burs
/// [m] h_e where tests do not tell: the middle of what was found in bone, 20 ... 40 um (docs/heads-and-materials.md).
inline constexpr double kAssumedEdgeLength = 30e-6;

/// Steady thrust and torque of a flat head fed axially (C22, C35).
struct AxialCutForce {
  double thrust;  ///< [N]      pi R^2 p_e + 2 pi R u V/(kappa omega),   V = v_f + sqrt(h_s f_z v_f) + h_e f_z
  double torque;  ///< [N·m]    (2 pi/3) kappa p_e R^3 + u pi R^2 V/omega
};
/// @param lips  [1] z
[[nodiscard]] AxialCutForce axial_cut_force(const Calibration& constants, double radius, AngularSpeed spindle_speed,
                                            double feed_speed, double lips = 2);

/// Fits u, kappa and one more constant to drilling tests by least squares of the relative errors of what was measured.
///
/// For a given kappa thrust and torque are linear in u and in u h_e, u sqrt(h_s) or p_e, neither of which may be
/// negative; kappa is searched from 0.001 to 1000. One test, or several at the same chip, cannot tell edge from chip,
/// nor can tests that scatter more than the edge adds: then an edge length is assumed, and the other two taken as 0.
/// @throws Error when there is no test, a number of one is out of its range, or no kappa within that range explains
///         them
[[nodiscard]] Calibration calibrate(std::span<const DrillingTest> tests, ChipTerm term = ChipTerm::edge_length);

}  // namespace hapticut
