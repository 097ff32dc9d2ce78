// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/block_outbox.hpp"

#include <algorithm>
#include <boost/lockfree/spsc_queue.hpp>
#include <utility>

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
  if (region.empty())
    throw Error(
        "The region whose changed blocks are sent is empty, as the bounds of an empty workpiece are. Give it the "
        "voxels "
        "that may be cut.");
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

std::size_t BlockOutbox::room() const noexcept { return queue_->blocks.write_available(); }

void BlockOutbox::send_now(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t number) noexcept {
  scratch_.origin = blocks_.origin_of(number);
  scratch_.version = ++version_;
  scratch_.workpiece = workpiece_number;
  copy_block(workpiece, scratch_);
  // There is room, because only this thread pushes.
  (void)queue_->blocks.push(scratch_);
}

std::size_t BlockOutbox::send(const Workpiece& workpiece, std::uint32_t workpiece_number,
                              std::size_t max_blocks) noexcept {
  const std::size_t sent = std::min({max_blocks, count_, room()});
  for (std::size_t n = 0; n < sent; ++n) send_now(workpiece, workpiece_number, pop_oldest_mark());
  return sent;
}

std::size_t BlockOutbox::pop_oldest_mark() noexcept {
  const std::uint32_t number = order_[head_];
  is_marked_[number] = false;
  head_ = (head_ + 1) % order_.size();
  --count_;
  return number;
}

void BlockOutbox::count_outside(const IndexBox& voxels) noexcept {
  IndexBox region;
  region.min = blocks_.first();
  for (std::size_t axis = 0; axis < 3; ++axis)
    region.max[axis] = region.min[axis] + kBlockEdge * (blocks_.dims()[axis] - 1) + (kBlockEdge - 1);
  outside_ += std::uint64_t(BlockGrid(voxels).count() - BlockGrid(overlap(voxels, region)).count());
}

void BlockOutbox::keep_marked(const Workpiece& workpiece, std::uint32_t workpiece_number) {
  while (count_ > 0) keep(workpiece, workpiece_number, pop_oldest_mark());
}

void BlockOutbox::keep(const Workpiece& workpiece, std::uint32_t workpiece_number, std::size_t number) {
  const BlockView block = workpiece.block(blocks_.origin_of(number));
  DeferredBlock kept = {number, ++version_, workpiece_number, block.uniform_material, nullptr};
  if (block.material != nullptr || block.fill != nullptr) {
    kept.content = std::make_unique<ChangedBlock>();
    block.copy_to(kept.content->material, kept.content->fill);
  }
  const std::lock_guard lock(keeping_);
  kept_.push_back(std::move(kept));
  any_kept_ = true;
}

void BlockOutbox::mark_kept() {
  const std::lock_guard lock(keeping_);
  for (const DeferredBlock& kept : kept_) mark(blocks_.origin_of(kept.number));
  kept_.clear();
  any_kept_ = false;
}

bool BlockOutbox::receive(ChangedBlock& block) {
  if (queue_->blocks.pop(block)) return true;
  if (!any_kept_) return false;
  const std::lock_guard lock(keeping_);
  if (kept_.empty()) return false;
  const DeferredBlock& kept = kept_.front();
  if (kept.content) {
    block = *kept.content;
  } else {
    block.material.fill(kept.uniform_material);
    block.fill.fill(kept.uniform_material == kEmpty ? 0.0F : 1.0F);
  }
  block.origin = blocks_.origin_of(kept.number);
  block.version = kept.version;
  block.workpiece = kept.workpiece;
  kept_.pop_front();
  any_kept_ = !kept_.empty();
  return true;
}

}  // namespace hapticut
