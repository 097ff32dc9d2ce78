// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "hapticut/workpiece/block.hpp"

/// Naive surface nets of one block. A cell has eight voxel centres, its samples, as corners, and is identified by the
/// lowest. A block owns the edges whose lower end is in it. Around such an edge are four cells, some of them one before
/// the block. Their gradients reach one sample further on either side:
///
///     samples   -2 -1 | 0  1  2  3  4  5  6  7 | 8  9
///     corners      -1 | 0  .  .  .  .  .  .  7 | 8         of cells -1 ... 7
///     edges           | 0  .  .  .  .  .  .  7 |           that the block owns
namespace hapticut::surface {

/// Filled fractions and materials in and around a block.
struct BlockSamples {
  static constexpr int kMargin = 2;
  static constexpr int kEdge = kBlockEdge + 2 * kMargin;
  static constexpr int kCount = kEdge * kEdge * kEdge;

  /// Place of the sample (x, y, z) of the block, each -2 ... 9.
  [[nodiscard]] static constexpr int at(int x, int y, int z) {
    return ((x + kMargin) * kEdge + y + kMargin) * kEdge + z + kMargin;
  }

  std::array<float, kCount> fill;           // [1]
  std::array<MaterialId, kCount> material;  // kEmpty: no material
};

/// A vertex of a block. It depends only on the samples around its cell, so the blocks on both sides of a seam compute
/// the same bits.
struct NetVertex {
  std::array<int, 3> cell;       // -1 ... 7
  std::array<float, 3> in_cell;  // [voxel edges] 0 ... 1 from the cell's lowest sample
  std::array<float, 3> normal;   // unit length, out of the material
  MaterialId material;
};

struct BlockNet {
  std::vector<NetVertex> vertices;
  std::vector<std::array<std::uint16_t, 3>> triangles;  // counter-clockwise seen from outside
};

/// @param net  overwritten; its memory is used again
void mesh_block(const BlockSamples& samples, BlockNet& net);

/// Reads the samples in and around a block.
/// @param read_row  `read_row(neighbour, first, count, fill, material)` writes `count` samples of the block next to it,
///                  from voxel `first` on; neighbour is {-1, 0, 1} along each axis
template <class ReadRow>
void read_samples(BlockSamples& samples, const ReadRow& read_row) {
  struct AxisRange {
    int neighbour, first, count;
  };
  constexpr int kMargin = BlockSamples::kMargin;
  constexpr std::array<AxisRange, 3> kRanges = {
      {{-1, kBlockEdge - kMargin, kMargin}, {0, 0, kBlockEdge}, {1, 0, kMargin}}};
  for (const AxisRange& x : kRanges)
    for (const AxisRange& y : kRanges)
      for (const AxisRange& z : kRanges) {
        const std::array<int, 3> neighbour = {x.neighbour, y.neighbour, z.neighbour};
        for (int i = 0; i < x.count; ++i)
          for (int j = 0; j < y.count; ++j) {
            const int to = BlockSamples::at(kBlockEdge * x.neighbour + x.first + i,
                                            kBlockEdge * y.neighbour + y.first + j, kBlockEdge * z.neighbour + z.first);
            read_row(neighbour, block_offset(x.first + i, y.first + j, z.first), z.count,
                     &samples.fill[std::size_t(to)], &samples.material[std::size_t(to)]);
          }
      }
}

}  // namespace hapticut::surface
