// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/tool/head.hpp"

/// @file
/// The parts that hold a cutting head: neck, shank and handpiece. They are smooth: they press and rub, for example on
/// the rim of a hole, and cut only within the land of a cutting edge. They are part of the head's profile, so that the
/// step handles one surface; docs/heads-and-materials.md states the cost.
namespace hapticut {

/// A neck that begins at the end of the head and widens or narrows to a shank.
struct Shank {
  double neck_diameter = 0;  ///< [m] diameter of the neck, where it leaves the head; less than the head's there
  double neck_length = 0;    ///< [m] length of the cylindrical part of the neck, from the head's end
  double taper_length = 0;   ///< [m] length from the neck to the shank; not 0 if their diameters differ
  double diameter = 0;       ///< [m] diameter of the shank
  double length = 0;         ///< [m] length of the whole tool, from the head's tip to the shank's end

  bool operator==(const Shank&) const = default;
};

constexpr auto fields_of(Of<Shank>) {
  return std::tuple{
      field("neck_diameter", &Shank::neck_diameter, "m", Range::positive(),
            "diameter of the neck, where it leaves the head; less than the head's there"),
      field("neck_length", &Shank::neck_length, "m", Range::not_negative(),
            "length of the cylindrical part of the neck, from the head's end"),
      field("taper_length", &Shank::taper_length, "m", Range::not_negative(),
            "length from the neck to the shank; not 0 if their diameters differ"),
      field("diameter", &Shank::diameter, "m", Range::positive(), "diameter of the shank"),
      field("length", &Shank::length, "m", Range::positive(),
            "length of the whole tool, from the head's tip to the shank's end"),
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

/// A standard shank. Necks have no standard: a neck of 2 mm and a taper of 4 mm are those of common burs.
/// @param neck_diameter  [m] > 0
[[nodiscard]] Shank standard_shank(ShankKind kind, double neck_diameter);

/// Adds neck and shank to a head. Frame and cutting edges stay those of the head.
/// @throws Error if the neck is not narrower than the head where it leaves the head, or if the tool is not longer than
///         head, neck and taper together
[[nodiscard]] ToolHead on_shank(const ToolHead& head, const Shank& shank);

/// Adds a body of revolution around the end of a head, such as the nose of a handpiece.
/// @param body  in the head's frame; begins on the axis inside the head or its shank and leaves it once; all its edges
///              become smooth
/// @throws Error if the body does not leave the head, or if the two together are not a valid profile
[[nodiscard]] ToolHead with_body(const ToolHead& head, const Profile& body);

}  // namespace hapticut
