// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/head.hpp"

/// @file
/// Heads by the names of the field; docs/heads-and-materials.md draws them. All lengths in [m], all angles in [rad].
/// The frame's origin is the tip, except for `round_head`, where it is the centre; +z points to the shank. Every
/// surface cuts but the disk on the shank's side, unless said.
///
/// Each function throws Error when a dimension is not positive, or when they do not fit together.
namespace hapticut {

/// A ball.
[[nodiscard]] ToolHead round_head(double diameter);

/// A truncated cone whose wide end is the tip: undercuts.
[[nodiscard]] ToolHead inverted_cone_head(double tip_diameter, double neck_diameter, double length);

/// A cylinder with a flat end (straight fissure).
[[nodiscard]] ToolHead cylinder_head(double diameter, double length);

/// A cylinder with a half ball as its end. @param length  of the whole, at least half of the diameter
[[nodiscard]] ToolHead round_end_cylinder_head(double diameter, double length);

/// A truncated cone with a flat end, narrower at the tip (tapered fissure).
[[nodiscard]] ToolHead tapered_head(double tip_diameter, double diameter, double length);

/// A truncated cone that ends in a ball, which its wall touches without an edge. @param tip_diameter  of the ball
[[nodiscard]] ToolHead round_end_tapered_head(double tip_diameter, double diameter, double length);

/// A slender pointed cone.
[[nodiscard]] ToolHead needle_head(double diameter, double length);

/// A pointed arch up to the widest place, and a gentler arch from there to the neck.
/// @param widest_height  height of the widest place above the tip; at least half of the diameter
[[nodiscard]] ToolHead flame_head(double diameter, double length, double neck_diameter, double widest_height);

/// A ball at the tip, narrowing in a straight line from where it is touched to the neck.
[[nodiscard]] ToolHead pear_head(double diameter, double length, double neck_diameter);

/// A disk that cuts with its rim and both faces; the face on the shank's side only outside of the shank.
[[nodiscard]] ToolHead wheel_head(double diameter, double thickness, double shank_diameter);

/// Cones on top of each other, each growing from `kTreeWaist` of the rim below: the X'mas cutter of the thesis.
/// @param tiers  1 ... `kMaxTiers` cones of the same height; the rim of the last has the full diameter
[[nodiscard]] ToolHead christmas_tree_head(double diameter, double length, int tiers);

/// [1] Radius at the foot of a tier of `christmas_tree_head`, of that of the rim below.
inline constexpr double kTreeWaist = 0.6;
inline constexpr int kMaxTiers = 20;  ///< of `christmas_tree_head`

inline constexpr double kCommonDrillPoint = 118 * units::deg;  ///< [rad] full angle of the point of a common drill

/// A twist drill: only the cone of its point cuts, its side is smooth. A Tool with it has two lips (`usual_cutter`).
/// @param point_angle  full angle of the point, less than pi
/// @param length       of the whole, more than that of the point
[[nodiscard]] ToolHead twist_drill_head(double diameter, double length, double point_angle = kCommonDrillPoint);

/// The numbers that describe heads.
enum class HeadDimension {
  radius,
  height,
  half_angle,
  diameter,
  length,
  tip_diameter,
  neck_diameter,
  shank_diameter,
  widest_height,
  tiers,
  point_angle
};
constexpr auto names_of(Of<HeadDimension>) {
  using enum HeadDimension;
  return std::array{
      Named{radius, "radius", "radius of a sphere or flat head"},
      Named{height, "height", "height of a cone or flat head"},
      Named{half_angle, "half_angle", "angle of a cone between axis and side"},
      Named{diameter, "diameter", "largest diameter of a head of the catalogue"},
      Named{length, "length", "length of a head of the catalogue, thickness of a wheel"},
      Named{tip_diameter, "tip_diameter", "diameter at the tip of an inverted_cone, tapered or round_end_tapered head"},
      Named{neck_diameter, "neck_diameter", "diameter at the shank of an inverted_cone, flame or pear"},
      Named{shank_diameter, "shank_diameter", "of a wheel: what of its upper face does not cut"},
      Named{widest_height, "widest_height", "of a flame: from the tip to its widest place"},
      Named{tiers, "tiers", "of a christmas_tree: number of cones"},
      Named{point_angle, "point_angle", "of a twist_drill: full angle of its point"}};
}
inline constexpr std::size_t kHeadDimensions = names_of(Of<HeadDimension>{}).size();

/// "m" or "rad", and "1" of a number of tiers.
[[nodiscard]] constexpr const char* unit_of(HeadDimension dimension) {
  using enum HeadDimension;
  if (dimension == half_angle || dimension == point_angle) return "rad";
  return dimension == tiers ? "1" : "m";
}

/// A shape of heads: what it is called, what describes it, how it is made. Settings, the browser page, tests and the
/// drawing in docs/heads-and-materials.md walk `head_shapes`. A shape has a `diameter` or a `tip_diameter`, by which
/// the browser page scales its others. CONTRIBUTING.md lists where a new bur goes.
struct HeadShape {
  struct Dimension {
    HeadDimension what;
    double usual;                  ///< [SI] of a common bur
    bool may_be_left_out = false;  ///< then it is the usual one
  };
  const char* name;                                      ///< "pear"
  const char* in_sentences;                              ///< "a pear"
  std::vector<Dimension> dimensions;                     ///< in the order in which `make` takes them
  ToolHead (*make)(std::span<const double> dimensions);  ///< [SI]

  /// Null where this shape has no such dimension.
  [[nodiscard]] const Dimension* find(HeadDimension dimension) const;
  /// With its usual dimensions.
  [[nodiscard]] ToolHead usual() const;
};
/// The sphere, cone and flat head and the catalogue above.
[[nodiscard]] const std::vector<HeadShape>& head_shapes();

}  // namespace hapticut
