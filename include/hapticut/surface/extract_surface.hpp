// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/mesh.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// The surface of a workpiece and what it is made of.
struct WorkpieceSurface {
  TriangleMesh mesh;                  ///< closed; [m] in W; counter-clockwise seen from outside
  std::vector<Vec3> normals;          ///< of each vertex, of length 1, out of the material; in W
  std::vector<MaterialId> materials;  ///< of each vertex: of the nearest voxel around that is at least half full
};

/// The surface of what is left, as SurfaceStream finds it, in one mesh and without its rounding: where the filled
/// fraction, interpolated between voxel centres, is one half. Partly filled voxels make it smooth (a plane comes out
/// plane, whatever its direction; a ball's volume is right to second order in the voxel size); enclosed cavities have
/// surfaces too.
/// @return an empty mesh when nothing is left
[[nodiscard]] WorkpieceSurface extract_surface(const Workpiece& workpiece);

/// The surface of one material alone, as if the others were empty.
/// @throws Error when there is no such material in the table
[[nodiscard]] TriangleMesh extract_surface(const Workpiece& workpiece, MaterialId material);

}  // namespace hapticut
