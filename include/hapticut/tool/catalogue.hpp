// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/head.hpp"

/// @file
/// Heads by the names of the field; docs/heads.md draws them. All lengths in [m], all angles in [rad]. The frame's
/// origin is the tip, except for `round_head`, where it is the centre; +z points to the shank. Every surface cuts but
/// the disk on the shank's side, unless said.
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
/// @param tiers  1 ... 20 cones of the same height; the rim of the last has the full diameter
[[nodiscard]] ToolHead christmas_tree_head(double diameter, double length, int tiers);

/// [1] Radius at the foot of a tier of `christmas_tree_head`, of that of the rim below.
inline constexpr double kTreeWaist = 0.6;

/// A twist drill: only the cone of its point cuts, its side is smooth. A Tool with it has two lips (`usual_cutter`).
/// @param point_angle  full angle of the point, less than pi; 118 degrees for a common drill
/// @param length       of the whole, more than that of the point
[[nodiscard]] ToolHead twist_drill_head(double diameter, double length, double point_angle = 118 * units::deg);

}  // namespace hapticut
