// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tool/meridian.hpp"

namespace hapticut::detail {

/// Fits lines and arcs to points, greedily from the first point on. All points lie within the tolerance [m] of them,
/// and each line or arc begins and ends at a point. An arc needs five points and no angle of more than 35 degrees
/// between its segments, because any three points of a corner fit an arc.
[[nodiscard]] std::vector<ProfileEdge> fit_lines_and_arcs(const std::vector<Vec2>& points, double tolerance);

}  // namespace hapticut::detail
