// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/build/work_estimate.hpp"
#include "hapticut/core/mesh.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// A closed surface and what it is filled with.
struct MeshShell {
  TriangleMesh mesh;             ///< [m] in W; small holes are closed, faces turned to one side, and that outwards
  MaterialId material = kEmpty;  ///< of what it encloses; kEmpty makes a cavity of it
};

/// How surfaces become voxels.
struct MeshImport {
  double voxel_size = 1e-4;  ///< [m]
  int subsamples = 8;        ///< points per voxel edge in the voxels that a surface cuts, 1 ... 16
  bool large = false;        ///< lifts the limits of work_estimate.hpp
  WorkObserver tell = {};    ///< is told of the work before it begins
};

/// How much work the surfaces will make.
/// @pre indices are in range and voxel_size is positive
[[nodiscard]] WorkEstimate estimate_work(const std::vector<MeshShell>& shells, const MeshImport& options);

/// A workpiece from nested surfaces, e.g. enamel, dentin, pulp. Where several enclose a point, **the last one of the
/// list wins**, so list them from the outside in. Voxels that a surface cuts get the filled fraction and its centroid
/// by subsampling, and the material with the largest share.
///
/// Inside is where the generalised winding number of a surface exceeds one half (Jacobson, Kavan and Sorkine-Hornung
/// 2013): right for closed surfaces, also when they overlap or intersect themselves, and robust to holes.
/// @throws Error when there is no shell, a vertex is not finite, an index is out of range, a material is not in the
///         table, a shell encloses nothing or is too open to say what is inside, there would be too many voxels, or
///         more work than is begun unasked
[[nodiscard]] Workpiece build_from_shells(const std::vector<MeshShell>& shells, MaterialTable materials,
                                          const MeshImport& options = {});

/// The same for one surface of one material.
[[nodiscard]] Workpiece build_from_mesh(const TriangleMesh& mesh, Material material, const MeshImport& options = {});

}  // namespace hapticut
