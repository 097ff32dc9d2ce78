// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {

class Workpiece;

/// A copy of one block of the workpiece, for a picture or a recording.
struct ChangedBlock {
  VoxelIndex origin = {0, 0, 0};  ///< index of the block's first voxel
  std::uint64_t version = 0;      ///< grows with every block that is sent
  std::uint32_t workpiece = 0;    ///< number of exchanges of the workpiece so far: ToolSnapshot::workpiece, or as
                                  ///< the constructor of ChangeFeed tells
  std::array<MaterialId, kBlockVoxels> material{};  ///< kEmpty for an empty voxel
  std::array<float, kBlockVoxels> fill{};           ///< [1]
};

/// Copies the content of a block of a workpiece.
/// @param block  its `origin` is the input, its arrays are the output
/// @realtime no allocation, no lock; O(512)
void copy_block(const Workpiece& workpiece, ChangedBlock& block) noexcept;

/// A bounded queue of changed blocks from the loop to another thread. It never blocks, and never loses the last version
/// of a block.
///
/// The loop marks a block when it changes, and sends marked blocks while the queue has room. A block that does not fit
/// stays marked, and its newest content is sent later. So a slow reader receives fewer versions of a block, but always
/// the last one.
///
/// One thread marks and sends, one other thread receives.
class BlockOutbox {
 public:
  /// @param region    voxels whose blocks may be marked
  /// @param capacity  [blocks] > 0 of the queue; 2.6 kB each
  /// @throws Error when the region is empty or too large for a table of its blocks
  BlockOutbox(const IndexBox& region, std::size_t capacity);
  ~BlockOutbox();
  BlockOutbox(const BlockOutbox&) = delete;
  BlockOutbox& operator=(const BlockOutbox&) = delete;

  /// Marks a block as changed.  @return false when the block is outside the region
  /// @realtime no allocation, no lock; O(1)
  bool mark(const VoxelIndex& origin) noexcept;

  /// Sends the current content of marked blocks, oldest mark first, while the queue has room.
  /// @param workpiece_number  ChangedBlock::workpiece
  /// @param max_blocks        [blocks] to be sent at most
  /// @return [blocks] that were sent
  /// @realtime no allocation, no lock; O(max_blocks)
  std::size_t send(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t max_blocks) noexcept;

  /// Sends a block now, marked or not.  @pre `room` > 0
  /// @param number  of the block in `blocks`
  /// @realtime no allocation, no lock; O(512)
  void send_now(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t number) noexcept;

  /// Keeps the current content of all marked blocks for `receive`, in memory beyond the queue. For the end of a loop.
  void keep_marked(const Workpiece& workpiece, std::uint32_t workpiece_number);

  /// Keeps a block as `keep_marked` does, marked or not.
  /// @param number  of the block in `blocks`
  void keep(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t number);

  /// Marks the kept blocks that were not received, because newer versions of them may follow.
  void mark_kept();

  /// [blocks] The places that are free in the queue. For the thread that sends.
  [[nodiscard]] std::size_t room() const noexcept;

  /// The grid of blocks that may be marked.
  [[nodiscard]] const BlockGrid& blocks() const noexcept { return blocks_; }

  /// The number of blocks that are marked and not yet sent. For the thread that marks.
  [[nodiscard]] std::size_t marked() const noexcept { return count_; }

  /// Whether a block is marked and not yet sent; false outside the region. For the thread that marks.
  [[nodiscard]] bool is_marked(const VoxelIndex& origin) const noexcept {
    const auto number = blocks_.number_of(origin);
    return number && is_marked_[*number];
  }

  /// The number of marks outside the region. For the thread that marks.
  [[nodiscard]] std::uint64_t outside() const noexcept { return outside_; }

  /// Counts the blocks of a box that are outside the region as marks. For the thread that marks.
  /// @realtime no allocation, no lock; O(1)
  void count_outside(const IndexBox& voxels) noexcept;

  /// Receives one block. For the receiving thread.  @return false when the queue is empty
  bool receive(ChangedBlock& block);

 private:
  struct Queue;
  /// A block that is kept beyond the queue. A uniform block needs no content.
  struct DeferredBlock {
    std::size_t number;
    std::uint64_t version;
    std::uint32_t workpiece;
    MaterialId uniform_material;
    std::unique_ptr<ChangedBlock> content;
  };

  [[nodiscard]] std::size_t pop_oldest_mark() noexcept;

  BlockGrid blocks_;
  std::vector<bool> is_marked_;
  std::vector<std::uint32_t> order_;  // ring of marked blocks, with room for all blocks
  std::size_t head_ = 0, count_ = 0;
  std::uint64_t version_ = 0, outside_ = 0;
  ChangedBlock scratch_;
  std::unique_ptr<Queue> queue_;
  std::mutex keeping_;  // guards `kept_`; not locked while the loop runs and nothing is kept
  std::deque<DeferredBlock> kept_;
  std::atomic<bool> any_kept_ = false;
};

}  // namespace hapticut
