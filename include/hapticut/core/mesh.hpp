// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// A triangle mesh: surfaces that come from files, and the surface of what is left of a workpiece.
struct TriangleMesh {
  std::vector<Vec3> vertices;                           ///< [m] in W
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices, counter-clockwise seen from outside
};

}  // namespace hapticut
