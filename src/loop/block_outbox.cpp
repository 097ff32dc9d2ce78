// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/block_outbox.hpp"

#include <algorithm>
#include <boost/lockfree/spsc_queue.hpp>

#include "hapticut/core/errors.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {
namespace {

constexpr double kMaxBlocks = 64e6;  // 1 bit and 4 bytes each: 264 MB

}  // namespace

void copy_block(const Workpiece& workpiece, ChangedBlock& block) noexcept {
  workpiece.block(block.origin).copy_to(block.material, block.fill);
}

struct BlockOutbox::Queue {
  explicit Queue(std::size_t capacity) : blocks(capacity) {}
  boost::lockfree::spsc_queue<ChangedBlock> blocks;
};

BlockOutbox::BlockOutbox(const IndexBox& region, std::size_t capacity) : blocks_(region) {
  if (region.empty()) throw Error("The region of a BlockOutbox is empty; give it the voxels that may be cut.");
  require_within(double(capacity), range_of(&ChangeFeedOptions::block_capacity),
                 "the capacity of a BlockOutbox [blocks]");
  const double blocks = blocks_.count();
  if (blocks > kMaxBlocks)
    throw Error("The region of a BlockOutbox has " + format_number(blocks) + " blocks; at most " +
                format_number(kMaxBlocks) + " are possible. Give it only the voxels that may be cut.");
  is_marked_.resize(std::size_t(blocks), false);
  order_.resize(std::size_t(blocks));
  queue_ = std::make_unique<Queue>(capacity);
}

BlockOutbox::~BlockOutbox() = default;

bool BlockOutbox::mark(const VoxelIndex& origin) noexcept {
  const auto number = blocks_.number_of(origin);
  if (!number) {
    ++outside_;
    return false;
  }
  if (is_marked_[*number]) return true;
  is_marked_[*number] = true;
  order_[(head_ + count_++) % order_.size()] = std::uint32_t(*number);
  return true;
}

void BlockOutbox::send(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t max_blocks) noexcept {
  const std::size_t sent = std::min({max_blocks, count_, queue_->blocks.write_available()});
  for (std::size_t n = 0; n < sent; ++n) {
    const std::uint32_t number = order_[head_];
    scratch_.origin = blocks_.origin_of(number);
    scratch_.version = ++version_;
    scratch_.workpiece = workpiece_number;
    copy_block(workpiece, scratch_);
    // There is room, because only this thread pushes.
    (void)queue_->blocks.push(scratch_);
    is_marked_[number] = false;
    head_ = (head_ + 1) % order_.size();
    --count_;
  }
}

bool BlockOutbox::receive(ChangedBlock& block) { return queue_->blocks.pop(block); }

}  // namespace hapticut
