// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// A number for each vertex, the same for vertices at the same place.
[[nodiscard]] std::vector<std::uint32_t> places_of(const std::vector<Vec3>& vertices);

/// Returns a mesh without the triangles that are there more than once, and without those that have no area. Vertices at
/// the same place count as one. A mesh without such triangles does not change.
///
/// Programs that draw faces from both sides write each triangle twice, once turned. Both together wind around nothing,
/// so a body of such faces would be lost. Two bodies that touch share a face in the same way, and there both copies or
/// none are right. So, for each connected sheet of such faces, one copy or none is kept, whichever leaves fewer sides
/// with an odd number of triangles; of a closed sheet one copy is kept.
///
/// Of triangles that are there twice the same way round one is kept, unless the others need both: a body inside another
/// that shares a face with it.
/// @throws Error when a sheet of two-sided faces is neither closed nor flat and touches nothing, while there are other
///         triangles: it may be a body with a hole or a wall
[[nodiscard]] TriangleMesh without_repeated_faces(TriangleMesh mesh);

}  // namespace hapticut
