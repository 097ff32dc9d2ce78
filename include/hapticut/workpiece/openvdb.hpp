// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openvdb/openvdb.h>

#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Conversion between workpieces and OpenVDB grids of your program. This is the only public header that includes
/// OpenVDB; a program that includes it must link OpenVDB.
namespace hapticut {

/// What the values of a float grid mean.
enum class GridKind {
  from_class,  ///< the class stored in the grid: level set or fog volume; other classes are refused
  level_set,   ///< signed distance, negative inside
  fog_volume,  ///< filled fraction of each voxel, 0 ... 1; larger values are refused
};

/// How a grid becomes a workpiece.
struct GridImport {
  GridKind kind = GridKind::from_class;
  double unit = 1;     ///< [m] length of one world unit of the grid's transform
  int subsamples = 8;  ///< points per voxel edge in voxels that a level set cuts, 1 ... 32; 1: voxels are full or empty
};

/// Makes a workpiece from a grid. Index (i, j, k) of the grid becomes index (i, j, k) of the workpiece. A level set is
/// sampled within the voxels that its surface cuts, which gives filled fractions and centroids.
/// @throws Error if the transform is not a rotation with one voxel size, the kind is not clear, nothing is inside, a
///         value is not finite, or there would be too many voxels
[[nodiscard]] Workpiece workpiece_from_grid(const openvdb::FloatGrid& grid, Material material,
                                            const GridImport& options = {});

/// Makes a workpiece from a grid, with a material per voxel.
/// @param ids  material id of every voxel that is not empty, in the index space of `grid`
/// @throws Error as `workpiece_from_grid`, and if a voxel that is not empty has an id that is not in the table
[[nodiscard]] Workpiece workpiece_from_grids(const openvdb::FloatGrid& grid, const openvdb::Int32Grid& ids,
                                             MaterialTable materials, const GridImport& options = {});

/// The filled fractions as a fog volume: 0 outside, active where the workpiece is not empty; uniform regions are tiles.
/// @param unit  [m] length of one world unit of the grid's transform
[[nodiscard]] openvdb::FloatGrid::Ptr density_grid(const Workpiece& workpiece, double unit = 1);

/// The material ids: 0 outside, active where the workpiece is not empty; uniform regions are tiles.
[[nodiscard]] openvdb::Int32Grid::Ptr material_grid(const Workpiece& workpiece, double unit = 1);

}  // namespace hapticut
