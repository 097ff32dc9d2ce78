// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tool/meridian.hpp"

namespace hapticut::detail {

/// The fewest lines and arcs, taken greedily from the first point on, that pass within a distance of all points and
/// begin and end at points. An arc needs five points and no turn of more than 35 degrees between them: three points of
/// a corner would pass for one.
[[nodiscard]] std::vector<ProfileEdge> fit_lines_and_arcs(const std::vector<Vec2>& points, double tolerance);

}  // namespace hapticut::detail
