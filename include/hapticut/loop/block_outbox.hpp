// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {

class Workpiece;

/// A copy of one block of the workpiece, on its way to a picture or a recording.
struct ChangedBlock {
  VoxelIndex origin = {0, 0, 0};                    ///< of its first voxel
  std::uint64_t version = 0;                        ///< grows with every block that is sent
  std::uint32_t workpiece = 0;                      ///< how often it was exchanged before: ToolSnapshot::workpiece
  std::array<MaterialId, kBlockVoxels> material{};  ///< kEmpty where there is nothing
  std::array<float, kBlockVoxels> fill{};           ///< [1]
};

/// Content of a block of a workpiece, for pictures and copies.
/// @param block  `origin` is given
/// @realtime no allocation, no lock; O(512)
void copy_block(const Workpiece& workpiece, ChangedBlock& block) noexcept;

/// Changed blocks out of the loop: bounded, never blocking, and never losing a block for good.
///
/// The loop marks a block when it changes and sends what is marked as far as the queue has room; a block that finds no
/// room stays marked, and its newest content goes out later. So a slow reader sees fewer versions of a block, but in
/// the end the last one of each.
///
/// One thread marks and sends, one other receives.
class BlockOutbox {
 public:
  /// @param region    voxels whose blocks may be marked
  /// @param capacity  [blocks] > 0 under way at once; 2.6 kB each
  /// @throws Error when the region is empty or too large for a table of its blocks
  BlockOutbox(const IndexBox& region, std::size_t capacity);
  ~BlockOutbox();
  BlockOutbox(const BlockOutbox&) = delete;
  BlockOutbox& operator=(const BlockOutbox&) = delete;

  /// Notes that a block changed.  @return false when it is outside of the region
  /// @realtime no allocation, no lock; O(1)
  bool mark(const VoxelIndex& origin) noexcept;

  /// Sends marked blocks as they are now, oldest mark first, at max_blocks `max_blocks` of them and as many as there is
  /// room for.
  /// @param workpiece_number  ChangedBlock::workpiece
  /// @realtime no allocation, no lock; O(max_blocks)
  void send(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t max_blocks) noexcept;

  /// The blocks that may be marked.
  [[nodiscard]] const BlockGrid& blocks() const noexcept { return blocks_; }

  /// Blocks that are marked and not sent. For the thread that marks.
  [[nodiscard]] std::size_t marked() const noexcept { return count_; }

  /// Marks that were outside of the region. For the thread that marks.
  [[nodiscard]] std::uint64_t outside() const noexcept { return outside_; }

  /// Takes one block. For the receiving thread.  @return false when there is none
  bool receive(ChangedBlock& block);

 private:
  struct Queue;

  BlockGrid blocks_;
  std::vector<bool> is_marked_;
  std::vector<std::uint32_t> order_;  // ring of marked blocks; has room for all there are
  std::size_t head_ = 0, count_ = 0;
  std::uint64_t version_ = 0, outside_ = 0;
  ChangedBlock scratch_;
  std::unique_ptr<Queue> queue_;
};

}  // namespace hapticut
