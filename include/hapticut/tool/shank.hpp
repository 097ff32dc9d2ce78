// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/tool/head.hpp"

/// @file
/// What holds a cutting head: neck, shank and handpiece. All of it is smooth: it presses and rubs where it leans on the
/// rim of a hole, and cuts only within the land of a cutting edge. It is part of the head's profile, so that the step
/// asks one surface; docs/heads-and-materials.md says what that costs.
namespace hapticut {

/// A neck that begins at the head's end, and widens or narrows to a shank.
struct Shank {
  double neck_diameter = 0;  ///< [m] > 0, where it leaves the head; less than the head's diameter there
  double neck_length = 0;    ///< [m] >= 0, of equal diameter, beyond the head's end
  double taper_length = 0;   ///< [m] > 0 where the diameters differ: from the neck to the shank
  double diameter = 0;       ///< [m] > 0, of the shank
  double length = 0;         ///< [m] of the whole tool, from the head's tip to the shank's end

  bool operator==(const Shank&) const = default;
};

constexpr auto fields_of(Of<Shank>) {
  return std::tuple{
      field("neck_diameter", &Shank::neck_diameter, "m", Range::positive(), "where it leaves the head"),
      field("neck_length", &Shank::neck_length, "m", Range::not_negative(), "of equal diameter, beyond the head's end"),
      field("taper_length", &Shank::taper_length, "m", Range::not_negative(), "from the neck to the shank"),
      field("diameter", &Shank::diameter, "m", Range::positive(), "of the shank"),
      field("length", &Shank::length, "m", Range::positive(), "of the whole tool, from tip to end"),
  };
}

/// Shanks of dental burs, by their diameter (ISO 1797) and the usual length of the whole bur.
enum class ShankKind {
  friction_grip,  ///< for turbines: 1.6 mm, 19 mm long
  latch,          ///< for contra-angles: 2.35 mm, 22 mm long
  handpiece       ///< for straight handpieces: 2.35 mm, 44.5 mm long
};

constexpr auto names_of(Of<ShankKind>) {
  using enum ShankKind;
  return std::array{
      Named{friction_grip, "friction_grip"},
      Named{latch, "latch"},
      Named{handpiece, "handpiece"},
  };
}

/// A standard shank. Necks have no standard: a taper of 4 mm after a neck of 2 mm is that of common burs.
/// @param neck_diameter  [m] > 0
[[nodiscard]] Shank standard_shank(ShankKind kind, double neck_diameter);

/// A head with its neck and shank. Frame and cutting edges stay those of the head.
/// @throws Error when the neck is not narrower than the head where it leaves it, or the tool not longer than head, neck
///         and taper
[[nodiscard]] ToolHead on_shank(const ToolHead& head, const Shank& shank);

/// A head with another body of revolution around its end, such as the nose of a handpiece.
/// @param body  in the head's frame, begins on the axis inside of the head or its shank, and leaves it once; its kinds
///              of edges do not matter
/// @throws Error when it does not leave the head, or the two together are no profile
[[nodiscard]] ToolHead with_body(const ToolHead& head, const Profile& body);

}  // namespace hapticut
