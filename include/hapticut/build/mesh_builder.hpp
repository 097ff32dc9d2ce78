// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hapticut/build/work_estimate.hpp"
#include "hapticut/core/mesh.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// A closed surface and the material inside it.
struct MeshShell {
  TriangleMesh mesh;             ///< [m] surface in W; small holes are closed, and all faces are oriented outwards
  MaterialId material = kEmpty;  ///< material of the enclosed space; kEmpty makes a cavity
};

/// Options for the conversion of surfaces to voxels.
struct MeshImport {
  double voxel_size = 1e-4;    ///< [m]
  int subsamples = 8;          ///< points per voxel edge in voxels that a surface cuts, 1 ... 16
  bool large = false;          ///< lifts the limits of work_estimate.hpp
  WorkObserver observer = {};  ///< called with the estimate before the work begins

  /// Receives a sentence about a surface that is open, with the volume that it fills, or of which parts are too thin
  /// for the voxels, so that its volume differs by more than 5 %, and about materials that fill over 5 % less or more
  /// than the space between their surface and the next, e.g. a thin layer: a voxel has one material.
  std::function<void(const std::string&)> warn = {};
};

/// Estimates the work of `build_from_shells`.
/// @pre indices are in range and voxel_size is positive
[[nodiscard]] WorkEstimate estimate_work(const std::vector<MeshShell>& shells, const MeshImport& options);

/// Builds a workpiece from nested surfaces, e.g. enamel, dentin, pulp. If several surfaces enclose a point, **the last
/// one of the list decides**, so list them from the outside to the inside. Voxels that a surface cuts get the filled
/// fraction and its centroid by subsampling, and the material that fills the largest part.
///
/// A point is inside a surface if the generalised winding number exceeds one half (Jacobson, Kavan and Sorkine-Hornung
/// 2013). This is exact for closed surfaces, also if they overlap or intersect themselves, and robust to holes. Faces
/// that are there twice, also turned (two-sided), count once.
/// @throws Error if there is no shell, a vertex is not finite, an index is out of range, a material is not in the
///         table, a shell or a part of it encloses nothing, is a sheet or is too open to decide what is inside, there
///         would be too many voxels, or the work exceeds the limits of work_estimate.hpp
[[nodiscard]] Workpiece build_from_shells(const std::vector<MeshShell>& shells, MaterialTable materials,
                                          const MeshImport& options = {});

/// Builds a workpiece from one surface and one material.  @throws Error as `build_from_shells`
[[nodiscard]] Workpiece build_from_mesh(const TriangleMesh& mesh, Material material, const MeshImport& options = {});

}  // namespace hapticut
