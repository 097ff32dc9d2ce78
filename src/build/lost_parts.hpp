// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "build/winding_number.hpp"
#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// Checks that each part of a surface bounds something. A part is lost if the surface winds around neither side of its
/// faces: a body that is inside out beside another, or whose faces are there twice in different triangles. Parts that
/// are thinner than two voxels are let pass.
/// @param winding  of the same surface
/// @throws Error that says where the part is
void require_no_lost_part(const TriangleMesh& mesh, const WindingNumber& winding, double voxel_size);

}  // namespace hapticut
