// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut::surface {

/// The content of each block of a region as one number: the material's id if it is uniform, kEmpty if it is empty, and
/// otherwise kMixed plus its place in a table.
class BlockCodes {
 public:
  static constexpr std::uint32_t kMixed = 256;
  static constexpr double kMaxBlocks = 268'435'456;  // 2^28, 1 GiB

  /// The region around these voxels, with the samples of cells at its border.
  /// @param step  [voxels] a power of two, of which the region's ends are multiples
  /// @throws Error when there are too many blocks
  BlockCodes(const IndexBox& voxels, int step) {
    if (!voxels.empty()) {
      IndexBox region;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // Edges whose upper end is the lowest voxel belong to the block before it.
        region.min[axis] = (voxels.min[axis] - 1) & ~(step - 1);
        region.max[axis] = voxels.max[axis] | (step - 1);
      }
      blocks_ = BlockGrid(region);
    }
    if (blocks_.count() > kMaxBlocks)
      throw Error("the workpiece spans " + format_number(blocks_.count()) +
                  " blocks of 8 x 8 x 8 voxels; a surface can have at most " + format_number(kMaxBlocks) +
                  ". Crop it, or use larger voxels.");
    codes_.resize(std::size_t(blocks_.count()), kEmpty);
  }

  [[nodiscard]] const VoxelIndex& first() const { return blocks_.first(); }        // voxel
  [[nodiscard]] const std::array<int, 3>& dims() const { return blocks_.dims(); }  // blocks along each axis
  [[nodiscard]] std::size_t count() const { return codes_.size(); }

  /// Whether the block with this origin is in the region.
  [[nodiscard]] bool contains(const VoxelIndex& origin) const { return blocks_.number_of(origin).has_value(); }

  [[nodiscard]] std::uint32_t at(const VoxelIndex& origin) const {
    const auto number = blocks_.number_of(origin);
    return number ? codes_[*number] : kEmpty;
  }
  std::uint32_t& operator[](const VoxelIndex& origin) { return codes_[*blocks_.number_of(origin)]; }

 private:
  BlockGrid blocks_;
  std::vector<std::uint32_t> codes_;
};

/// The codes of a block and its neighbours, looked up once for all their rows.
struct CodesAround {
  std::array<std::uint32_t, 27> codes;

  CodesAround(const BlockCodes& all, const VoxelIndex& origin) {
    for (int n = 0; n < 27; ++n)
      codes[std::size_t(n)] = all.at({origin[0] + kBlockEdge * (n / 9 - 1), origin[1] + kBlockEdge * (n / 3 % 3 - 1),
                                      origin[2] + kBlockEdge * (n % 3 - 1)});
  }
  /// Whether no surface can cross the cells of the middle block: all blocks are empty, or all are full.
  [[nodiscard]] bool are_plain() const {
    const bool empty = codes[0] == kEmpty;
    return std::ranges::all_of(
        codes, [&](std::uint32_t code) { return code < BlockCodes::kMixed && (code == kEmpty) == empty; });
  }

  [[nodiscard]] std::uint32_t at(const std::array<int, 3>& neighbour) const {
    const int n = (neighbour[0] + 1) * 9 + (neighbour[1] + 1) * 3 + neighbour[2] + 1;
    return codes[std::size_t(n)];
  }
};

}  // namespace hapticut::surface
