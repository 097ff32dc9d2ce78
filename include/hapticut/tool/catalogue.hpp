// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/head.hpp"

/// @file
/// Heads by their usual names; docs/heads-and-materials.md shows drawings. All lengths in [m], all angles in [rad]. The
/// frame's origin is the tip, except for `round_head`, where it is the centre; +z points to the shank. Unless stated
/// otherwise, every surface cuts except the disk on the shank's side.
///
/// Each function throws Error if a dimension is not positive, or if the dimensions do not fit together.
namespace hapticut {

/// A ball.
[[nodiscard]] ToolHead round_head(double diameter);

/// A truncated cone whose wide end is the tip: undercuts.
[[nodiscard]] ToolHead inverted_cone_head(double tip_diameter, double neck_diameter, double length);

/// A cylinder with a flat end (straight fissure).
[[nodiscard]] ToolHead cylinder_head(double diameter, double length);

/// A cylinder with a half ball as its end. @param length  [m] of the whole head, at least half of the diameter
[[nodiscard]] ToolHead round_end_cylinder_head(double diameter, double length);

/// A truncated cone with a flat end, narrower at the tip (tapered fissure).
[[nodiscard]] ToolHead tapered_head(double tip_diameter, double diameter, double length);

/// A truncated cone that ends in a ball; the wall is tangent to the ball. @param tip_diameter  [m] of the ball
[[nodiscard]] ToolHead round_end_tapered_head(double tip_diameter, double diameter, double length);

/// A slender pointed cone.
[[nodiscard]] ToolHead needle_head(double diameter, double length);

/// A pointed arch up to the widest place, and a flatter arch from there to the neck.
/// @param widest_height  [m] height of the widest place above the tip; at least half of the diameter
[[nodiscard]] ToolHead flame_head(double diameter, double length, double neck_diameter, double widest_height);

/// A ball at the tip and a straight wall, tangent to the ball, that narrows towards the neck.
[[nodiscard]] ToolHead pear_head(double diameter, double length, double neck_diameter);

/// A disk that cuts with its rim and both faces; the face on the shank's side cuts only outside of the shank.
[[nodiscard]] ToolHead wheel_head(double diameter, double thickness, double shank_diameter);

/// A stack of cones: the X'mas cutter of the thesis. Each cone begins with `kTreeWaist` times the radius of the rim
/// below.
/// @param tiers  1 ... `kMaxTiers` cones of equal height; the rim of the last one has the full diameter
[[nodiscard]] ToolHead christmas_tree_head(double diameter, double length, int tiers);

/// [1] Radius at the foot of a tier of `christmas_tree_head` over the radius of the rim below.
inline constexpr double kTreeWaist = 0.6;
inline constexpr int kMaxTiers = 20;  ///< tiers of `christmas_tree_head`

inline constexpr double kCommonDrillPoint = 118 * units::deg;  ///< [rad] full angle of the point of a common drill

/// A twist drill: only the cone of its point cuts; its side is smooth. A Tool with this head has two lips
/// (`usual_cutter`).
/// @param point_angle  [rad] full angle of the point, less than pi
/// @param length       [m] of the whole head, more than that of the point
[[nodiscard]] ToolHead twist_drill_head(double diameter, double length, double point_angle = kCommonDrillPoint);

/// A number that describes heads. All heads that have it have it in the same unit.
struct HeadDimension {
  std::string_view name;     ///< "tip_diameter"
  std::string_view unit;     ///< "m", "rad"; "1" for a number without unit
  Range range;               ///< [SI] allowed values
  std::string_view meaning;  ///< "largest diameter of a catalogue head"
  bool is_whole = false;     ///< a number of things
};
/// The dimensions of all heads of `head_shapes`, each once. A number among the fields of a shape is one of them.
[[nodiscard]] const std::vector<HeadDimension>& head_dimensions();

/// A kind of head: its name, its dimensions and the function that makes it. Settings, the browser page and tests read
/// `head_shapes`. CONTRIBUTING.md lists the places to add a new shape or bur.
struct HeadShape {
  struct Dimension {
    HeadDimension what;
    double usual;           ///< [SI] value for a common bur
    bool optional = false;  ///< if left out, it is `usual`
  };
  const char* name;                                      ///< "pear"
  const char* in_sentences;                              ///< "a pear"
  std::vector<Dimension> dimensions;                     ///< ordered like the arguments of `make`
  ToolHead (*make)(std::span<const double> dimensions);  ///< [SI]

  /// Null if this shape has no dimension of that name.
  [[nodiscard]] const Dimension* find(std::string_view dimension) const;
  /// The head with its usual dimensions.
  [[nodiscard]] ToolHead usual() const;
};
/// The shapes of ToolHead that have dimensions, and the catalogue above.
[[nodiscard]] const std::vector<HeadShape>& head_shapes();

}  // namespace hapticut
