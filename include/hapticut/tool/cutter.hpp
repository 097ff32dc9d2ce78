// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// The kind of cutting edges of a head. Cutting constants belong to a pair of material and cutter kind; find_preset
/// takes both.
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

/// How worn the edges of a cutter are. Its presets differ in one number, which grows with wear (PresetConstant::wears):
/// the edge length of a drill, the cutting energy of other cutters.
enum class Sharpness {
  new_,  ///< fresh from the package: half as dear as used grains, a third of the edges of a used drill
  used,  ///< after some cuts, as in most publications: the default
  worn   ///< should have been replaced
};

constexpr auto names_of(Of<Sharpness>) {
  using enum Sharpness;
  return std::array{
      Named{new_, "new"},
      Named{used, "used"},
      Named{worn, "worn"},
  };
}

/// The cutting edges of a head. The number of edges that pass a place per revolution decides the chip thickness, on
/// which the cutting energy of some materials depends.
struct Cutter {
  CutterKind kind = CutterKind::carbide_bur;  ///< kind of cutting edges
  /// [1] cutting edges that pass a place per revolution; 0: the usual number of the kind
  int lips = 0;
};

constexpr auto fields_of(Of<Cutter>) {
  return std::tuple{
      field("kind", &Cutter::kind, "kind of cutting edges"),
      field("lips", &Cutter::lips, "1", Range::between(0, 1000),
            "cutting edges that pass a place per revolution; 0: the usual number of the kind"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const Cutter& cutter) { require_fields_within(cutter, "Cutter::"); }

/// The number of lips z. If `Cutter::lips` is 0, the usual number of the kind: 6 for a carbide bur, 2 for a drill, 8
/// for a mastoid cutting bur, and 1 for diamond grains, whose constants are per revolution.
[[nodiscard]] constexpr int lips_of(const Cutter& cutter) {
  if (cutter.lips > 0) return cutter.lips;
  switch (cutter.kind) {
    case CutterKind::carbide_bur:
      return 6;
    case CutterKind::twist_drill:
      return 2;
    case CutterKind::mastoid_cutting_bur:
      return 8;
    default:
      return 1;
  }
}

/// f_z, the rate at which lips pass a place.
/// @param spindle_speed  [rad/s] of either sign
/// @return [1/s]
[[nodiscard]] inline double tooth_rate(const Cutter& cutter, double spindle_speed) {
  return lips_of(cutter) * std::abs(spindle_speed) / (2 * units::kPi);
}

}  // namespace hapticut
