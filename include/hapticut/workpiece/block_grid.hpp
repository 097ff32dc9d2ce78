// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hapticut/workpiece/block.hpp"

namespace hapticut {

/// The voxels that are in both boxes.
[[nodiscard]] inline IndexBox overlap(const IndexBox& a, const IndexBox& b) {
  IndexBox both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::max(a.min[axis], b.min[axis]);
    both.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return both;
}

/// The voxels of the block that begins at `origin`.
[[nodiscard]] constexpr IndexBox voxels_of_block(const VoxelIndex& origin) {
  return {origin, voxel_at(origin, kBlockVoxels - 1)};
}

/// Calls `function(index)` for each voxel of a box; z is the fastest index.
template <class Function>
void for_each_voxel(const IndexBox& voxels, const Function& function) {
  for (int i = voxels.min[0]; i <= voxels.max[0]; ++i)
    for (int j = voxels.min[1]; j <= voxels.max[1]; ++j)
      for (int k = voxels.min[2]; k <= voxels.max[2]; ++k) function(VoxelIndex{i, j, k});
}

/// Calls `function(origin)` for each block that a box of voxels touches; z is the fastest index.
template <class Function>
void for_each_block_origin(const IndexBox& voxels, const Function& function) {
  if (voxels.empty()) return;
  for (int i = block_start(voxels.min[0]); i <= voxels.max[0]; i += kBlockEdge)
    for (int j = block_start(voxels.min[1]); j <= voxels.max[1]; j += kBlockEdge)
      for (int k = block_start(voxels.min[2]); k <= voxels.max[2]; k += kBlockEdge) function(VoxelIndex{i, j, k});
}

/// A set of voxels of one block.
struct BlockVoxels {
  VoxelIndex origin = {0, 0, 0};  ///< index of the block's first voxel
  BlockMask voxels;

  [[nodiscard]] bool operator==(const BlockVoxels&) const = default;
};

inline constexpr int kSides = 6;  ///< sides of a block: -x, +x, -y, +y, -z, +z

/// Origin of the neighbouring block at a side.
[[nodiscard]] inline VoxelIndex beside(VoxelIndex origin, int side) noexcept {
  origin[std::size_t(side / 2)] += side % 2 == 0 ? -kBlockEdge : kBlockEdge;
  return origin;
}

/// The blocks that a box of voxels touches, numbered from 0 in the order of `for_each_block_origin`, as index for
/// tables of blocks.
class BlockGrid {
 public:
  BlockGrid() = default;  ///< without blocks
  explicit BlockGrid(const IndexBox& voxels) {
    if (voxels.empty()) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first_[axis] = block_start(voxels.min[axis]);
      const std::int64_t extent = std::int64_t(block_start(voxels.max[axis])) - first_[axis];
      dims_[axis] = int(extent / kBlockEdge) + 1;
    }
  }

  [[nodiscard]] const VoxelIndex& first() const { return first_; }        ///< origin of the first block
  [[nodiscard]] const std::array<int, 3>& dims() const { return dims_; }  ///< blocks along each axis

  /// The number of blocks. It is a double, because it may be too large for an index: check it before making a table.
  [[nodiscard]] double count() const { return double(dims_[0]) * dims_[1] * dims_[2]; }

  /// Number of a block.  @return nothing for a block outside the grid
  [[nodiscard]] std::optional<std::size_t> number_of(const VoxelIndex& origin) const noexcept {
    std::size_t number = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t from_first = std::int64_t(origin[axis]) - first_[axis];
      if (from_first < 0 || from_first / kBlockEdge >= dims_[axis]) return std::nullopt;
      number = number * std::size_t(dims_[axis]) + std::size_t(from_first / kBlockEdge);
    }
    return number;
  }
  [[nodiscard]] VoxelIndex origin_of(std::size_t number) const noexcept {
    const auto ny = std::size_t(dims_[1]), nz = std::size_t(dims_[2]);
    return {first_[0] + kBlockEdge * int(number / (ny * nz)), first_[1] + kBlockEdge * int(number / nz % ny),
            first_[2] + kBlockEdge * int(number % nz)};
  }

 private:
  VoxelIndex first_ = {0, 0, 0};
  std::array<int, 3> dims_ = {0, 0, 0};
};

}  // namespace hapticut
