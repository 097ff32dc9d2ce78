// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/preset_constants.hpp"

namespace hapticut {

/// One drilling test: a head of radius R fed along its axis into material, at full diameter. It is fed at least a
/// nanometre and at most its diameter per revolution.
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
  /// The cutter of the tests. What the tests do not determine is the typical value of its presets.
  CutterKind cutter = CutterKind::twist_drill;
  ChipTerm term = ChipTerm::edge_length;  ///< the third constant that was asked for
  /// The tests separate edge from chip: the standard error of the requested term is less than half of the term, or less
  /// than a tenth of thrust and torque; or there are as many numbers as constants, and only one value of the constant
  /// fits them exactly. Otherwise a pressure or size length was set to 0.
  bool edge_identified = false;
  /// The edge length is that of the presets, because the tests neither determine it nor contradict this value.
  bool edge_assumed = false;
  /// The size length is that of the presets, and the edge length 0: chips a hundred times thinner than h_s determine
  /// only u sqrt(h_s).
  bool size_assumed = false;
  /// Another third constant describes the tests with less than half of the residual.
  std::optional<ChipTerm> better_term = {};
  /// The tests determine the energy of the chip: the standard error of u is less than half of u. Otherwise the edge
  /// carries nearly all of thrust and torque, and u may be 0.
  bool chip_identified = true;
  /// Thrust and torque were both measured. Otherwise kappa is that of the presets, because thrusts alone determine only
  /// u/kappa.
  bool ratio_identified = true;
  /// More numbers were measured than constants fitted. Otherwise they always fit exactly, and nothing checks them.
  bool checked = true;
  double thrust_residual = 0;  ///< [1] root mean square of (model - measured)/measured, over the measured thrusts
  double torque_residual = 0;  ///< [1] over the measured torques
  /// [1] the largest ratio of a measured number and the model, or its inverse. Up to 2 is usual between laboratories;
  /// above, the tests contradict each other, or are not of one material and tool
  double worst_factor = 1;
  double thinnest_chip = 0;  ///< [m] smallest feed per lip of the tests
};

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
/// chip; nor can tests whose scatter exceeds the effect of the edge. Then the edge length of a drill or the size length
/// of blades is the typical value of `preset_constants`, and another requested constant is 0. No edge is assumed for
/// chips more than ten times as thick, which hardly depend on it.
/// @param term    the third constant; none: that of the presets of the cutter, for diamonds edge_length
/// @param cutter  of the tests; none: a carbide bur if the edge of a drill would be more than 30 times as long as the
///                chips are thick, else a drill
/// @throws Error when there is no test, a number of a test is out of its range, or no kappa within the range fits the
/// tests
[[nodiscard]] Calibration calibrate(std::span<const DrillingTest> tests, std::optional<ChipTerm> term = {},
                                    std::optional<CutterKind> cutter = {});

/// The range of the presets that a fitted number is compared with: that of the cutter of the tests; for an edge length
/// that the cutter does not have, that of drills; null: there is none.
/// @param number  of Material: "cutting_ratio"
[[nodiscard]] const PresetConstant* presets_beside(const Calibration& constants, std::string_view number) noexcept;

/// What to do with the constants, what is missing to know them better, and what makes them doubtful: sentences, each in
/// a line. A number more than three times out of the range of the presets has a line that begins with "Warning: ".
[[nodiscard]] std::string advice_on(const Calibration& constants);

}  // namespace hapticut
