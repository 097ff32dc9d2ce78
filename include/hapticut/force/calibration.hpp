// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

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

/// The third constant of the fit, beside u and kappa: why thrust and torque do not go to zero with the chip.
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

/// The constants of a material and a kind of tool that fit drilling tests.
struct Calibration {
  double specific_cutting_energy = 0;  ///< [J/m^3] u
  double cutting_ratio = 0;            ///< [1] kappa
  double edge_pressure = 0;            ///< [Pa] p_e
  double edge_length = 0;              ///< [m] h_e
  double size_length = 0;              ///< [m] h_s
  /// The tests separate edge from chip: the standard error of the requested term is less than half of the term, or less
  /// than a tenth of thrust and torque; or there are as many numbers as constants, and only one value of the constant
  /// fits them exactly. Otherwise a pressure or size length was set to 0.
  bool edge_identified = false;
  /// The edge length is kAssumedEdgeLength, because the tests neither determine it nor contradict this value.
  bool edge_assumed = false;
  /// The size length is kAssumedSizeLength and the edge length 0, because the chips are so thin that an edge of a drill
  /// would be more than 30 times as long: they are those of blades.
  bool size_assumed = false;
  /// Another third constant describes the tests with less than half of the residual.
  std::optional<ChipTerm> better_term = {};
  /// The tests determine the energy of the chip: the standard error of u is less than half of u. Otherwise the edge
  /// carries nearly all of thrust and torque, and u may be 0.
  bool chip_identified = true;
  /// Thrust and torque were both measured. Otherwise kappa was set to kAssumedRatio, because thrusts alone determine
  /// only u/kappa.
  bool ratio_identified = true;
  /// More numbers were measured than constants fitted. Otherwise they always fit exactly, and nothing checks them.
  bool checked = true;
  double thrust_residual = 0;  ///< [1] root mean square of (model - measured)/measured, over the measured thrusts
  double torque_residual = 0;  ///< [1] over the measured torques
  /// [1] the largest ratio of a measured number and the model, or its inverse: from 1.5 on the tests contradict each
  /// other, or are not of one material and tool
  double worst_factor = 1;
  double thinnest_chip = 0;  ///< [m] smallest feed per lip of the tests
};

inline constexpr double kAssumedRatio = 0.5;  ///< [1] kappa when tests do not determine it: that of burs
/// [m] h_e when tests do not determine it: the middle of the range found in bone, 20 ... 40 um
/// (docs/heads-and-materials.md). It is assumed for chips of 1 um to 0.3 mm; a thicker chip hardly depends on it.
inline constexpr double kAssumedEdgeLength = 30e-6;
inline constexpr double kAssumedSizeLength = 180e-6;  ///< [m] h_s of blades, when tests do not determine it

/// Steady thrust and torque of a flat head fed axially (C22, C35).
struct AxialCutForce {
  double thrust;  ///< [N]      pi R^2 p_e + 2 pi R u V/(kappa omega),   V = v_f + sqrt(h_s f_z v_f) + h_e f_z
  double torque;  ///< [N·m]    (2 pi/3) kappa p_e R^3 + u pi R^2 V/omega
};
/// @param lips  [1] z
[[nodiscard]] AxialCutForce axial_cut_force(const Calibration& constants, double radius, AngularSpeed spindle_speed,
                                            double feed_speed, double lips = 2);

/// Fits u, kappa and one more constant to drilling tests by least squares of the relative errors of the measured
/// numbers.
///
/// For a given kappa, thrust and torque are linear in u and in u h_e, u sqrt(h_s) or p_e. None of these may be
/// negative. kappa is searched from 0.001 to 1000. One test, or several with the same chip, cannot separate edge from
/// chip; nor can tests whose scatter exceeds the effect of the edge. Then an edge length is assumed, with very thin
/// chips a size length, and another requested constant is set to 0.
/// @throws Error when there is no test, a number of a test is out of its range, or no kappa within the range fits the
/// tests
[[nodiscard]] Calibration calibrate(std::span<const DrillingTest> tests, ChipTerm term = ChipTerm::edge_length);

/// What to do with the constants, what is missing to know them better, and what makes them doubtful: sentences, each in
/// a line.
/// @param term  that was asked for
[[nodiscard]] std::string advice_on(const Calibration& constants, ChipTerm term = ChipTerm::edge_length);

}  // namespace hapticut
