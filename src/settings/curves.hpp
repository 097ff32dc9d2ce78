// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/spatial.hpp"

/// @file
/// Curves that a tool follows, as polylines. Arcs are divided into steps of half a degree: the distance between chord
/// and arc is below 1e-5 of the radius.
namespace hapticut::settings {

/// The plane of a curve. `axis` is its normal and points out of the material. Angles are positive counter-clockwise,
/// seen from the tip of the axis. They start at the projection of W's x axis, or of its y axis when x is close to
/// `axis`.
struct CurvePlane {
  Vec3 center;  ///< [m] position in W
  Vec3 axis;    ///< [1] any length but 0

  [[nodiscard]] Pose frame() const;  ///< z along the axis, x along angle 0
};

[[nodiscard]] std::vector<Vec3> circle(const CurvePlane& plane, double radius, double turns, double start_angle);

/// A spiral on a disk (depth 0), a cylinder (equal radii) or a cone: radius and depth are linear in the angle.
/// @param pitch  [m] distance between turns, measured along the disk, cylinder or cone
[[nodiscard]] std::vector<Vec3> spiral(const CurvePlane& plane, double start_radius, double end_radius, double pitch,
                                       double depth);

struct CavityShape {
  double top_radius;     ///< [m] radius of the curve in the uppermost layer
  double bottom_radius;  ///< [m] radius of the curve in the lowest layer
  double depth;          ///< [m] depth of the lowest layer
  double layer;          ///< [m] maximum distance between layers
  double pitch;          ///< [m] maximum distance between turns in a layer
};

/// Clears a cavity layer by layer: the first layer spirals outwards, the second inwards, and so on. Every layer
/// includes a full turn along its wall.
[[nodiscard]] std::vector<Vec3> cavity(const CurvePlane& plane, const CavityShape& shape);

}  // namespace hapticut::settings
