// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// A mesh whose triangles are turned round until those that share a side go through it in opposite directions, as on
/// one side of a surface; a piece where most do already keeps its side. Sides of three and more triangles join nothing.
/// Some programs write the corners of faces in any order, and no winding number can tell what such a surface encloses.
///
/// Then closed pieces that lie in no other and face inwards are turned, e.g. the mirrored half of a jaw, and with each
/// what lies in it. A piece within another keeps its side: it may be a cavity. Where a piece is open this is left out.
[[nodiscard]] TriangleMesh oriented(TriangleMesh mesh);

}  // namespace hapticut
