// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/change_feed.hpp"

#include "hapticut/loop/simulation_model.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kSweptPerStep = 256;  // blocks that are marked; a mark takes some nanoseconds

}  // namespace

ChangeFeed::ChangeFeed(Simulation& simulation, const ChangeFeedOptions& options)
    : simulation_(simulation),
      per_step_(options.blocks_per_step),
      outbox_(simulation.workpiece().bounds(), options.block_capacity),
      copy_([this](ChangedBlock& block) { copy_block(simulation_.workpiece(), block); }) {
  require_fields_within(options, "ChangeFeedOptions::");
  const IndexBox bounds = simulation.workpiece().bounds();
  all_ = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first_[axis] = block_start(bounds.min[axis]);
    blocks_[axis] = (block_start(bounds.max[axis]) - first_[axis]) / kBlockEdge + 1;
    all_ *= std::size_t(blocks_[axis]);
  }
  swept_ = all_;
  simulation.add_observer(*this);
}

ChangeFeed::~ChangeFeed() { simulation_.remove_observer(*this); }

void ChangeFeed::on_step(const ObservedStep& step) noexcept {
  const ChangedBlocks changed = step.simulation.changed_blocks();
  for (const VoxelIndex& origin : changed.origins) outbox_.mark(origin);
  if (!changed.complete) swept_ = 0;
  sweep();
  outbox_.send(copy_, per_step_);
}

/// Marks some more of all blocks, where all are to be sent.
void ChangeFeed::sweep() noexcept {
  for (std::size_t n = 0; n < kSweptPerStep && swept_ < all_; ++n, ++swept_) {
    const auto ny = std::size_t(blocks_[1]), nz = std::size_t(blocks_[2]);
    outbox_.mark({first_[0] + kBlockEdge * int(swept_ / (ny * nz)), first_[1] + kBlockEdge * int(swept_ / nz % ny),
                  first_[2] + kBlockEdge * int(swept_ % nz)});
  }
}

}  // namespace hapticut
