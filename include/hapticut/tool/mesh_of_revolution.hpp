// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/profile.hpp"

namespace hapticut {

/// The closed surface of a profile, its vertices on the surface.
/// @param sides  3 ... 10000 facets around the axis; arcs are divided equally finely
[[nodiscard]] TriangleMesh mesh_of_revolution(const Profile& profile, int sides);

}  // namespace hapticut
