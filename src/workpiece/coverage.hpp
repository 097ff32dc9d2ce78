// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>

#include "hapticut/workpiece/block.hpp"

/// @file
/// The part of a voxel that a body fills: antialiasing of a surface that is a function of the position.
namespace hapticut {

/// The filled fraction of a voxel and the centroid of that part.
struct Coverage {
  double fill;  ///< [1] 0 ... 1
  Vec3 offset;  ///< [voxel edges] from the voxel's centre; zero when nothing is filled
};

/// Sums `subsamples`^3 cells of one voxel. The distance at the middle of a cell gives its covered part, which is exact
/// for a plane along the grid.
/// @param distance  [m] of a point in W, negative inside; if it is less than the true distance, surfaces blur slightly
/// @param subsamples  1: the voxel is full when its centre is inside, and empty otherwise
[[nodiscard]] Coverage sample_coverage(const std::function<double(const Vec3&)>& distance, const Vec3& center,
                                       double voxel_size, int subsamples);

/// Coverage of the voxels of one block, with far fewer calls of the function and more exact than `sample_coverage`.
///
/// The function is evaluated at the 8 corners, 6 face centres and the centre of a voxel; neighbours share most of these
/// points. A trilinear function plus a parabola along each axis is fitted to the 15 values. If the values agree with
/// the fit and the parabolas are flat, the surface is smooth on the scale of the voxel. Then `subsamples`^2 rows, each
/// with the exact covered length, give the filled fraction: about 6 calls per voxel. Elsewhere (edges, thin sheets,
/// strong curvature) the function is evaluated in every cell.
class BlockCoverage {
 public:
  /// @param origin  first voxel of the block; `distance` must outlive the object
  BlockCoverage(const std::function<double(const Vec3&)>& distance, const GridFrame& frame, const VoxelIndex& origin,
                int subsamples);

  /// Value of the function at the centre of voxel (x, y, z), 0 <= x, y, z < 8.
  [[nodiscard]] double at_center(int x, int y, int z) { return value(2 * x + 1, 2 * y + 1, 2 * z + 1); }

  [[nodiscard]] Coverage coverage(int x, int y, int z);

 private:
  static constexpr int kNodes = 2 * kBlockEdge + 1;  // half-voxel steps along an edge of the block, both ends included

  [[nodiscard]] double value(int i, int j, int k);

  const std::function<double(const Vec3&)>& distance_;
  const GridFrame& frame_;
  VoxelIndex origin_;
  int subsamples_;
  std::array<double, kNodes * kNodes * kNodes> values_;  ///< [m] NaN: not evaluated yet
};

}  // namespace hapticut
