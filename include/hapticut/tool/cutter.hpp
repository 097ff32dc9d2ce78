// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// What a head cuts with. Constants of cutting belong to a pair of it and a material: find_preset has them by both.
enum class CutterKind {
  carbide_bur,          ///< dental, tungsten carbide with blades
  fine_diamond,         ///< dental, grains of 20 ... 50 um
  coarse_diamond,       ///< dental, grains of 100 ... 180 um
  twist_drill,          ///< surgical or implant drill with two lips
  mastoid_cutting_bur,  ///< otological, of steel or carbide with flutes
  mastoid_diamond_bur   ///< otological, with diamond grains
};

constexpr auto names_of(Of<CutterKind>) {
  using enum CutterKind;
  return std::array{
      Named{carbide_bur, "carbide_bur"},
      Named{fine_diamond, "fine_diamond"},
      Named{coarse_diamond, "coarse_diamond"},
      Named{twist_drill, "twist_drill"},
      Named{mastoid_cutting_bur, "mastoid_cutting_bur"},
      Named{mastoid_diamond_bur, "mastoid_diamond_bur"},
  };
}

/// The cutting edges of a head. How many pass a place in a turn decides how thick chips are, where a material's energy
/// depends on that.
struct Cutter {
  CutterKind kind = CutterKind::carbide_bur;
  int lips = 6;
};

constexpr auto fields_of(Of<Cutter>) {
  return std::tuple{
      field("kind", &Cutter::kind, "what the head cuts with"),
      field("lips", &Cutter::lips, "1", Range::between(1, 1000),
            "cutting edges that pass a place in a turn; 1 for grains, whose constants are those of a turn"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const Cutter& cutter) { require_fields_within(cutter, "Cutter::"); }

/// A cutter with as many lips as common ones of its kind have.
[[nodiscard]] constexpr Cutter common_cutter(CutterKind kind) {
  switch (kind) {
    case CutterKind::carbide_bur:
      return {kind, 6};
    case CutterKind::twist_drill:
      return {kind, 2};
    case CutterKind::mastoid_cutting_bur:
      return {kind, 8};
    default:
      return {kind, 1};
  }
}

/// f_z, how often a lip passes.
/// @param spindle_speed  [rad/s] of either sign
/// @return [1/s]
[[nodiscard]] inline double tooth_rate(const Cutter& cutter, double spindle_speed) {
  return cutter.lips * std::abs(spindle_speed) / (2 * units::kPi);
}

}  // namespace hapticut
