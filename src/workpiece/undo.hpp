// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hapticut/workpiece/block_grid.hpp"

/// @file
/// Steps back of a workpiece, and forth again: what blocks were before they were cut, and after.
namespace hapticut {

/// One block as it was.
struct SavedBlock {
  VoxelIndex origin;
  std::uint32_t saved_before;  ///< mark under which the block had been saved last
  bool has_voxels, has_fill;   ///< false: uniform; all that is solid is full
  MaterialId uniform_material;
  BlockMask solid;
  std::array<MaterialId, kBlockVoxels> material;
  std::array<float, kBlockVoxels> fill;
};

/// Marks, and the blocks that were cut since each: every block once a mark, before its first cut. Bounded: when there
/// is no room, the oldest mark goes with its blocks.
///
/// A tape: the way back reads it from its end, the way forth the other way. A block that is put back leaves on the tape
/// what it was until then, so going forth again needs no memory of its own. The next cut records over it.
///
///     oldest                      here                       end
///       | mark 1 | mark 2  . . .   |  . . mark 2 | mark 3 . . |
///       '--- blocks before the cuts ---'--- blocks after the cuts ---'
///
/// Its memory: sizeof(SavedBlock) for each block of its capacity, and a table of 4 bytes for each block of the bounds.
class UndoJournal {
 public:
  static constexpr std::size_t kMarks = 64;
  static constexpr std::size_t kMaxCapacity = std::size_t(1) << 22;  ///< [blocks], 11 GB

  /// @param bounds    voxels that may be cut
  /// @param capacity  [blocks] > 0
  /// @throws Error when the bounds are too large for a table of their blocks, the capacity is above kMaxCapacity, or
  ///         there is no such memory
  UndoJournal(const IndexBox& bounds, std::size_t capacity);

  void set_mark() noexcept;
  [[nodiscard]] std::size_t capacity() const noexcept { return ring_.size(); }
  [[nodiscard]] std::size_t marks() const noexcept { return marks_.size(); }
  [[nodiscard]] std::size_t redo_marks() const noexcept { return undone_.size() + (half_way() ? 1 : 0); }

  /// Saves a block, unless it has been since the last mark.  @realtime no allocation, no lock; O(512)
  void save(const BlockView& block) noexcept;

  /// There is no way forth any more, because something else was cut.  @realtime no allocation, no lock; O(1)
  void forget_redo() noexcept;

  /// The block that was saved last since the last mark; null when there is none, and then the mark is gone.
  /// @return to be put back, and to be overwritten with what the block was before; valid until the next call of `save`
  [[nodiscard]] SavedBlock* take_back() noexcept;

  /// The block that was put back last since the mark that is to be there again; null when it is done.
  /// @return as of `take_back`
  [[nodiscard]] SavedBlock* redo_into() noexcept;

 private:
  struct Mark {
    std::uint32_t number;
    std::size_t blocks;      // before the place where we are on the tape
    std::size_t undone = 0;  // after it
  };
  [[nodiscard]] bool half_way() const noexcept { return !marks_.empty() && marks_.back().undone > 0; }
  void drop_oldest_mark() noexcept;

  BlockGrid blocks_;                    // of the bounds
  std::vector<std::uint32_t> saved_;    // mark under which each block was saved last; 0: never
  std::vector<SavedBlock> ring_;        // of all marks, oldest first
  std::size_t oldest_ = 0, count_ = 0;  // in the ring; `count_` blocks before the place where we are
  std::vector<Mark> marks_, undone_;    // the latter: the one to come next is the last
  bool redoing_ = false;                // to the end of the last mark
  std::uint32_t last_number_ = 0;
};

}  // namespace hapticut
