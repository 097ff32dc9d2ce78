// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/mesh.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// The surface of a workpiece, with normals and materials.
struct WorkpieceSurface {
  TriangleMesh mesh;                  ///< closed; [m] in W; counter-clockwise seen from outside
  std::vector<Vec3> normals;          ///< unit normal of each vertex, out of the material; in W
  std::vector<MaterialId> materials;  ///< material of each vertex: of the nearest voxel that is at least half full
};

/// The surface of the remaining material, as SurfaceStream computes it, in one mesh and without rounding. It lies where
/// the filled fraction, interpolated between voxel centres, is one half. Partly filled voxels make it smooth: a plane
/// stays a plane in any direction, and a ball's volume is right to second order in the voxel size. Enclosed cavities
/// have surfaces too.
/// @return an empty mesh when no material is left
[[nodiscard]] WorkpieceSurface extract_surface(const Workpiece& workpiece);

/// The surface of one material alone, as if the others were empty.
/// @throws Error when there is no such material in the table
[[nodiscard]] TriangleMesh extract_surface(const Workpiece& workpiece, MaterialId material);

}  // namespace hapticut
