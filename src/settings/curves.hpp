// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/spatial.hpp"

/// @file
/// The curves that a tool follows, as polylines. Arcs are cut into steps of half a degree: the chords leave the arc by
/// less than a hundred-thousandth of its radius.
namespace hapticut::settings {

/// Where a plane curve lies: `axis` is its normal and points out of the material, angles count counter-clockwise seen
/// from its tip, from the direction in which W's x axis (or y, where x is close to the axis) is projected.
struct CurvePlane {
  Vec3 center;  ///< [m] in W
  Vec3 axis;    ///< [1] any length but 0

  [[nodiscard]] Pose frame() const;  ///< z along the axis, x where angles start
};

[[nodiscard]] std::vector<Vec3> circle(const CurvePlane& plane, double radius, double turns, double start_angle);

/// A spiral on a disk (depth 0), a cylinder (equal radii) or a cone: radius and depth change evenly with the angle.
/// @param pitch  [m] distance of neighbouring turns, measured along the disk, cylinder or cone
[[nodiscard]] std::vector<Vec3> spiral(const CurvePlane& plane, double start_radius, double end_radius, double pitch,
                                       double depth);

struct CavityShape {
  double top_radius;     ///< [m] of the curve in the uppermost layer
  double bottom_radius;  ///< [m] of the curve in the lowest layer
  double depth;          ///< [m] of the lowest layer
  double layer;          ///< [m] largest distance of neighbouring layers
  double pitch;          ///< [m] largest distance of neighbouring turns in a layer
};

/// Clears a cavity layer by layer: spirals outwards in the first, inwards in the second, and so on; every layer is
/// finished by a full turn along its wall.
[[nodiscard]] std::vector<Vec3> cavity(const CurvePlane& plane, const CavityShape& shape);

}  // namespace hapticut::settings
