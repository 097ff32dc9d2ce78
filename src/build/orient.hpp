// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// Returns a mesh with consistent orientation. Some programs write the corners of faces in any order, and winding
/// numbers are meaningless for such a surface.
///
/// First, repeated faces are dropped (`without_repeated_faces`). Then triangles are flipped until neighbours traverse
/// their shared side in opposite directions. The orientation of a piece is that of most of its triangles. Sides of
/// three or more triangles do not connect triangles.
///
/// At last, closed outer pieces that face inwards are flipped, e.g. the mirrored half of a jaw, together with all
/// pieces inside them. Otherwise a piece inside another keeps its orientation, because it may be a cavity. Open pieces
/// stay as they are. If they face inwards, taken together, all closed ones do so too: the whole surface is inside out,
/// which `WindingNumber` mends.
/// @throws Error as `without_repeated_faces`
[[nodiscard]] TriangleMesh oriented(TriangleMesh mesh);

}  // namespace hapticut
