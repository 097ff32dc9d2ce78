// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>

#include "hapticut/workpiece/block.hpp"

/// @file
/// How much of a voxel a body fills: antialiasing of a surface that is given as a function of the position.
namespace hapticut {

/// The filled fraction of a voxel and the centroid of that part.
struct Coverage {
  double fill;  ///< [1] 0 ... 1
  Vec3 offset;  ///< [voxel edges] from the voxel's centre; zero when nothing is filled
};

/// Counts which points of a lattice of `subsamples`^3 in one voxel the body contains, asking for each of them.
/// @param distance  [m] of a point in W, negative inside
[[nodiscard]] Coverage sample_coverage(const std::function<double(const Vec3&)>& distance, const Vec3& center,
                                       double voxel_size, int subsamples);

/// Counts the same lattice for the voxels of one block, but asks the function far less often.
///
/// The function is known at the 8 corners, 6 face centres and the centre of a voxel, most of which neighbours share.
/// Through them runs one trilinear function plus a parabola along each axis. Where the 15 values agree with it, and it
/// bends little, the surface is smooth on the scale of the voxel and the lattice is counted on the polynomial: about 6
/// calls per voxel. Elsewhere (edges, thin sheets, strong curvature) the function is asked at every point of the
/// lattice.
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
