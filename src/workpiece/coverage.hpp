// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>

#include "hapticut/workpiece/block.hpp"

/// @file
/// How much of a voxel a body fills: antialiasing of a surface that is given as a function of the position.
namespace hapticut {

inline constexpr double kMaxVoxelSize = 0.02;  // [m]

/// The filled fraction of a voxel and the centroid of that part.
struct Coverage {
  double fill;  ///< [1] 0 ... 1
  Vec3 offset;  ///< [voxel edges] from the voxel's centre; zero when nothing is filled
};

/// Adds up `subsamples`^3 cells of one voxel, asking for the distance of each: a cell counts by how far the surface is
/// from its middle, which is exact for a plane along the grid.
/// @param distance  [m] of a point in W, negative inside; where it is less than the true distance, surfaces blur a
/// little
/// @param subsamples  1: the voxel is full when its centre is inside, and empty otherwise
[[nodiscard]] Coverage sample_coverage(const std::function<double(const Vec3&)>& distance, const Vec3& center,
                                       double voxel_size, int subsamples);

/// The same for the voxels of one block, but asks the function far less often and is more exact.
///
/// The function is known at the 8 corners, 6 face centres and the centre of a voxel, most of which neighbours share.
/// Through them runs one trilinear function plus a parabola along each axis. Where the 15 values agree with it, and it
/// bends little, the surface is smooth on the scale of the voxel and `subsamples`^2 rows, each with the exact length
/// that the polynomial covers of it, add up to the fraction: about 6 calls per voxel. Elsewhere (edges, thin sheets,
/// strong curvature) the function is asked in every cell.
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
  std::array<double, kNodes * kNodes * kNodes> values_;  ///< [m] NaN where not yet asked
};

}  // namespace hapticut
