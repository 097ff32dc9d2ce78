// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

/// @file
/// The numbers of the presets, each with its range and source: one table, which presets, documentation, Python and page
/// read.
namespace hapticut {

/// A place in the range of a number of the presets.
enum class Estimate {
  low,      ///< the lower end
  typical,  ///< what presets use
  high      ///< the upper end
};

constexpr auto names_of(Of<Estimate>) {
  using enum Estimate;
  return std::array{
      Named{low, "low"},
      Named{typical, "typical"},
      Named{high, "high"},
  };
}

/// A number of the presets. `fields_of` below has the meaning of each field.
struct PresetConstant {
  std::string_view of;  ///< a material or a kind of cutter; "solid": every material that has no row of its own
  /// a number of Material; "share": cutting energy over that of dentin; "heat_share": part of the work of a cut that
  /// heats the wall
  std::string_view number;
  double low = 0;           ///< lower end of the range, in `unit`
  double typical = 0;       ///< what presets use, in `unit`
  double high = 0;          ///< upper end of the range, in `unit`
  std::string_view unit;    ///< "J/m^3"; "1": a pure number
  bool wears = false;       ///< whether the range is that from a new to a worn cutter; see Sharpness
  std::string_view source;  ///< who measured it, under which assumptions

  /// The value at a place of the range, in `unit`.
  [[nodiscard]] constexpr double at(Estimate estimate) const {
    return estimate == Estimate::low ? low : estimate == Estimate::high ? high : typical;
  }
};

constexpr auto fields_of(Of<PresetConstant>) {
  using C = PresetConstant;
  return std::tuple{
      field("of", &C::of, "a material or a kind of cutter; \"solid\": every material that has no row of its own"),
      field(
          "number", &C::number,
          "a number of Material; \"share\": cutting energy over that of dentin; \"heat_share\": part of the work of a "
          "cut that heats the wall"),
      field("low", &C::low, "lower end of the range, in `unit`"),
      field("typical", &C::typical, "what presets use, in `unit`"),
      field("high", &C::high, "upper end of the range, in `unit`"),
      field("unit", &C::unit, "\"J/m^3\"; \"1\": a pure number"),
      field("wears", &C::wears, "whether the range is that from a new to a worn cutter; see Sharpness"),
      field("source", &C::source, "who measured it, under which assumptions"),
  };
}

/// All numbers of the presets: first of the cutters, then of the materials.
[[nodiscard]] std::span<const PresetConstant> preset_constants();

/// A number of a material or of a kind of cutter; null if the table does not have it.
[[nodiscard]] const PresetConstant* find_constant(std::string_view of, std::string_view number) noexcept;

/// The row of the table that gives a number of a preset under a cutter: that of the material, else of the cutter, else
/// of all solids; null for a number that presets leave at its default.
[[nodiscard]] const PresetConstant* constant_of(std::string_view preset, std::string_view cutter,
                                                std::string_view number) noexcept;

}  // namespace hapticut
