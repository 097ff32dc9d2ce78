// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hapticut/workpiece/block.hpp"

/// @file
/// Steps back of a workpiece: what blocks were before they were cut.
namespace hapticut {

/// One block as it was.
struct SavedBlock {
  VoxelIndex origin;
  std::uint32_t saved_before;  ///< mark under which the block had been saved last
  bool has_voxels, has_fill;   ///< false: uniform; all that is solid is full
  MaterialId uniform_material;
  std::array<std::uint64_t, 8> solid;
  std::array<MaterialId, kBlockVoxels> material;
  std::array<float, kBlockVoxels> fill;
};

/// Marks, and the blocks that were cut since each: every block once a mark, before its first cut. Bounded: when there
/// is no room, the oldest mark goes with its blocks.
///
/// Its memory: sizeof(SavedBlock) for each block of its capacity, and a table of 4 bytes for each block of the bounds.
class UndoJournal {
 public:
  static constexpr std::size_t kMarks = 64;
  static constexpr std::size_t kMostCapacity = std::size_t(1) << 22;  ///< [blocks], 11 GB

  /// @param bounds    voxels that may be cut
  /// @param capacity  [blocks] > 0
  /// @throws Error when the bounds are too large for a table of their blocks, the capacity is above kMostCapacity, or
  ///         there is no such memory
  UndoJournal(const IndexBox& bounds, std::size_t capacity);

  void set_mark() noexcept;
  [[nodiscard]] std::size_t capacity() const noexcept { return ring_.size(); }
  [[nodiscard]] std::size_t marks() const noexcept { return marks_.size(); }

  /// Saves a block, unless it has been since the last mark.  @realtime no allocation, no lock; O(512)
  void save(const BlockView& block) noexcept;

  /// The block that was saved last since the last mark; null when there is none, and then the mark is gone.
  /// @return valid until the next call of `save`
  [[nodiscard]] const SavedBlock* take() noexcept;

 private:
  struct Mark {
    std::uint32_t number;
    std::size_t blocks;
  };
  [[nodiscard]] std::size_t number_of(const VoxelIndex& origin) const noexcept;
  void drop_oldest_mark() noexcept;

  VoxelIndex first_, blocks_;           // origin of the first block of the bounds; blocks along each axis
  std::vector<std::uint32_t> saved_;    // mark under which each block was saved last; 0: never
  std::vector<SavedBlock> ring_;        // of all marks, oldest first
  std::size_t oldest_ = 0, count_ = 0;  // in the ring
  std::vector<Mark> marks_;
  std::uint32_t last_number_ = 0;
};

}  // namespace hapticut
