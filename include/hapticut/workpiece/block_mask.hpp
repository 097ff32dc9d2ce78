// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace hapticut {

/// A set of the 512 voxels of a block, each named by its `block_offset`, with operations on voxels that share a face.
struct BlockMask {
  std::array<std::uint64_t, 8> words = {};  ///< word x, bit 8 y + z

  [[nodiscard]] static constexpr BlockMask all() {
    BlockMask mask;
    mask.words.fill(~std::uint64_t(0));
    return mask;
  }

  /// @param words  8 of them
  [[nodiscard]] static constexpr bool has(const std::uint64_t* words, int voxel) {
    return (words[unsigned(voxel) / 64] >> (unsigned(voxel) % 64) & 1U) != 0;
  }
  [[nodiscard]] constexpr bool has(int voxel) const { return has(words.data(), voxel); }
  constexpr void add(int voxel) { words[unsigned(voxel) / 64] |= std::uint64_t(1) << (unsigned(voxel) % 64); }

  [[nodiscard]] constexpr bool empty() const { return *this == BlockMask{}; }
  [[nodiscard]] constexpr int count() const {
    int voxels = 0;
    for (const std::uint64_t word : words) voxels += std::popcount(word);
    return voxels;
  }

  /// Calls `function(voxel)` for each voxel of the set, in their order.
  template <class Function>
  constexpr void for_each(const Function& function) const {
    for (int x = 0; x < 8; ++x)
      for (std::uint64_t bits = words[std::size_t(x)]; bits != 0; bits &= bits - 1)
        function(64 * x + std::countr_zero(bits));
  }

  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm
  [[nodiscard]] constexpr auto operator<=>(const BlockMask&) const = default;
  [[nodiscard]] friend constexpr BlockMask operator&(BlockMask a, const BlockMask& b) {
    for (std::size_t x = 0; x < 8; ++x) a.words[x] &= b.words[x];
    return a;
  }
  [[nodiscard]] friend constexpr BlockMask operator|(BlockMask a, const BlockMask& b) {
    for (std::size_t x = 0; x < 8; ++x) a.words[x] |= b.words[x];
    return a;
  }
  [[nodiscard]] constexpr BlockMask without(const BlockMask& other) const {
    BlockMask rest = *this;
    for (std::size_t x = 0; x < 8; ++x) rest.words[x] &= ~other.words[x];
    return rest;
  }

  /// The first voxel alone.  @pre the set is not empty
  [[nodiscard]] constexpr BlockMask first() const {
    BlockMask one;
    std::size_t x = 0;
    while (words[x] == 0) ++x;
    one.words[x] = words[x] & (~words[x] + 1);
    return one;
  }

  /// The voxels, and all voxels of the block that share a face with one of them.
  [[nodiscard]] constexpr BlockMask grown() const {
    BlockMask result;
    for (std::size_t x = 0; x < 8; ++x) {
      const std::uint64_t m = words[x];
      result.words[x] = m | m << 8 | m >> 8 | (m << 1 & ~kLowZ) | (m >> 1 & ~(kLowZ << 7));
      if (x > 0) result.words[x] |= words[x - 1];
      if (x < 7) result.words[x] |= words[x + 1];
    }
    return result;
  }

  /// The voxels of `within` that are connected to this set over faces, inside the block.
  [[nodiscard]] constexpr BlockMask joined(const BlockMask& within) const {
    BlockMask reached = *this & within;
    for (;;) {
      const BlockMask next = reached.grown() & within;
      if (next == reached) return reached;
      reached = next;
    }
  }

  /// The voxels of the neighbouring block at a side (`beside`) that touch voxels of this set.
  [[nodiscard]] constexpr BlockMask across(int side) const {
    BlockMask result;
    if (side == 0) result.words[7] = words[0];
    if (side == 1) result.words[0] = words[7];
    if (side < 2) return result;
    for (std::size_t x = 0; x < 8; ++x) {
      const std::uint64_t m = words[x];
      result.words[x] = side == 2   ? (m & 0xff) << 56
                        : side == 3 ? m >> 56
                        : side == 4 ? (m & kLowZ) << 7
                                    : m >> 7 & kLowZ;
    }
    return result;
  }

 private:
  static constexpr std::uint64_t kLowZ = 0x0101010101010101ULL;  // the voxels with z = 0
};

}  // namespace hapticut
