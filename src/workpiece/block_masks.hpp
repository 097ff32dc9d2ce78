// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "hapticut/workpiece/block.hpp"

/// @file
/// The 512 voxels of a block as bits: which of them touch which by a face.
namespace hapticut {

using BlockMask = std::array<std::uint64_t, 8>;  ///< word x, bit 8 y + z

[[nodiscard]] inline bool any(const BlockMask& mask) noexcept {
  std::uint64_t bits = 0;
  for (const std::uint64_t word : mask) bits |= word;
  return bits != 0;
}
[[nodiscard]] inline int count(const BlockMask& mask) noexcept {
  int voxels = 0;
  for (const std::uint64_t word : mask) voxels += std::popcount(word);
  return voxels;
}
[[nodiscard]] inline BlockMask operator&(BlockMask a, const BlockMask& b) noexcept {
  for (std::size_t x = 0; x < 8; ++x) a[x] &= b[x];
  return a;
}
[[nodiscard]] inline BlockMask operator|(BlockMask a, const BlockMask& b) noexcept {
  for (std::size_t x = 0; x < 8; ++x) a[x] |= b[x];
  return a;
}
[[nodiscard]] inline BlockMask without(BlockMask a, const BlockMask& b) noexcept {
  for (std::size_t x = 0; x < 8; ++x) a[x] &= ~b[x];
  return a;
}

/// The first voxel alone.  @pre there is one
[[nodiscard]] inline BlockMask first_of(const BlockMask& mask) noexcept {
  BlockMask one = {};
  std::size_t x = 0;
  while (mask[x] == 0) ++x;
  one[x] = mask[x] & (~mask[x] + 1);
  return one;
}

/// The voxels and those of the same block that share a face with one of them.
[[nodiscard]] inline BlockMask grown(const BlockMask& mask) noexcept {
  constexpr std::uint64_t kLowZ = 0x0101010101010101ULL, kHighZ = kLowZ << 7;
  BlockMask result;
  for (std::size_t x = 0; x < 8; ++x) {
    const std::uint64_t m = mask[x];
    result[x] = m | m << 8 | m >> 8 | (m << 1 & ~kLowZ) | (m >> 1 & ~kHighZ);
    if (x > 0) result[x] |= mask[x - 1];
    if (x < 7) result[x] |= mask[x + 1];
  }
  return result;
}

/// The voxels of `within` that faces join to one of `seed`, inside the block.
[[nodiscard]] inline BlockMask joined_to(const BlockMask& seed, const BlockMask& within) noexcept {
  BlockMask reached = seed & within;
  for (;;) {
    const BlockMask next = grown(reached) & within;
    if (next == reached) return reached;
    reached = next;
  }
}

inline constexpr int kSides = 6;  ///< -x, +x, -y, +y, -z, +z

/// Origin of the block at a side.
[[nodiscard]] inline VoxelIndex beside(VoxelIndex origin, int side) noexcept {
  origin[std::size_t(side / 2)] += side % 2 == 0 ? -kBlockEdge : kBlockEdge;
  return origin;
}

/// What touches the voxels of a block in the block at one of its sides, as bits of that block.
[[nodiscard]] inline BlockMask across(const BlockMask& mask, int side) noexcept {
  constexpr std::uint64_t kLowZ = 0x0101010101010101ULL, kLowY = 0xffULL;
  BlockMask result = {};
  if (side == 0) result[7] = mask[0];
  if (side == 1) result[0] = mask[7];
  if (side < 2) return result;
  for (std::size_t x = 0; x < 8; ++x) {
    const std::uint64_t m = mask[x];
    result[x] = side == 2 ? (m & kLowY) << 56 : side == 3 ? m >> 56 : side == 4 ? (m & kLowZ) << 7 : m >> 7 & kLowZ;
  }
  return result;
}

/// The voxels of a block that hold something and are filled at least so much.
[[nodiscard]] inline BlockMask filled_voxels(const BlockView& block, float least_fill) noexcept {
  BlockMask mask;
  if (block.material == nullptr && block.fill == nullptr) {
    mask.fill(block.uniform_material == kEmpty ? 0 : ~std::uint64_t(0));
    return mask;
  }
  for (int x = 0; x < 8; ++x) {
    std::uint64_t bits = block.material == nullptr ? ~std::uint64_t(0) : block.solid[x];
    if (block.fill != nullptr) {
      std::uint64_t filled = 0;
      for (int n = 0; n < 64; ++n) filled |= std::uint64_t(block.fill[64 * x + n] >= least_fill) << n;
      bits &= filled;
    }
    mask[std::size_t(x)] = bits;
  }
  return mask;
}

}  // namespace hapticut
