// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hapticut/workpiece/block_grid.hpp"

/// @file
/// Undo and redo of a workpiece: the content of blocks before and after they were cut.
namespace hapticut {

/// The saved content of one block.
struct SavedBlock {
  VoxelIndex origin;
  std::uint32_t saved_before;  ///< mark under which the block was saved previously
  bool has_voxels, has_fill;   ///< false: uniform; all solid voxels are full
  MaterialId uniform_material;
  BlockMask solid;
  std::array<MaterialId, kBlockVoxels> material;
  std::array<float, kBlockVoxels> fill;
};

/// Marks, and the blocks that were cut since each mark. A block is saved once per mark, before its first cut. The
/// memory is bounded: when it is full, the oldest mark is deleted with its blocks.
///
/// The journal is like a tape. Undo reads it backwards, redo forwards. When undo restores a block, it writes the
/// present content of the block in the place of the saved content, so that redo needs no additional memory. The next
/// cut overwrites the undone part.
///
///     oldest                      here                       end
///       | mark 1 | mark 2  . . .   |  . . mark 2 | mark 3 . . |
///       '--- blocks before the cuts ---'--- blocks after the cuts ---'
///
/// Memory: sizeof(SavedBlock) for each block of the capacity, and 4 bytes for each block of the bounds.
class UndoJournal {
 public:
  static constexpr std::size_t kMarks = 64;
  static constexpr std::size_t kMaxCapacity = std::size_t(1) << 22;  ///< [blocks], 11 GB

  /// @param bounds    voxels that may be cut
  /// @param capacity  [blocks] > 0
  /// @throws Error if the bounds have too many blocks for a table, the capacity is above kMaxCapacity, or the memory is
  ///         not available
  UndoJournal(const IndexBox& bounds, std::size_t capacity);

  void set_mark() noexcept;
  [[nodiscard]] std::size_t capacity() const noexcept { return ring_.size(); }
  [[nodiscard]] std::size_t marks() const noexcept { return marks_.size(); }
  [[nodiscard]] std::size_t redo_marks() const noexcept { return undone_.size() + (half_way() ? 1 : 0); }

  /// Saves a block, unless it was saved since the last mark.  @realtime no allocation, no lock; O(512)
  void save(const BlockView& block) noexcept;

  /// Deletes the undone marks, because something was cut.  @realtime no allocation, no lock; O(1)
  void forget_redo() noexcept;

  /// Undoes one block: returns the block that was saved last since the last mark. The caller exchanges the saved
  /// content with that of the workpiece.
  /// @return valid until the next call of `save`; null when all blocks are undone, and then the mark is removed
  [[nodiscard]] SavedBlock* undo_into() noexcept;

  /// Redoes one block: returns the block that was undone last. The caller exchanges the saved content with that of the
  /// workpiece.
  /// @return valid until the next call of `save`; null when all blocks of the mark are redone
  [[nodiscard]] SavedBlock* redo_into() noexcept;

 private:
  struct Mark {
    std::uint32_t number;
    std::size_t blocks;      // before the present place on the tape
    std::size_t undone = 0;  // after it
  };
  [[nodiscard]] bool half_way() const noexcept { return !marks_.empty() && marks_.back().undone > 0; }
  void drop_oldest_mark() noexcept;

  BlockGrid blocks_;                    // blocks within the bounds
  std::vector<std::uint32_t> saved_;    // mark under which each block was saved last; 0: never
  std::vector<SavedBlock> ring_;        // blocks of all marks, oldest first
  std::size_t oldest_ = 0, count_ = 0;  // place in the ring; `count_` blocks before the present place
  std::vector<Mark> marks_, undone_;    // undone_: the next mark to redo is the last
  bool redoing_ = false;                // until the last mark is complete
  std::uint32_t last_number_ = 0;
};

}  // namespace hapticut
