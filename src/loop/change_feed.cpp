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
      copy_([this](ChangedBlock& block) { copy_block(simulation_.workpiece(), block); }),
      all_(std::size_t(outbox_.blocks().count())),
      swept_(all_) {
  require_fields_within(options, "ChangeFeedOptions::");
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
  for (std::size_t n = 0; n < kSweptPerStep && swept_ < all_; ++n, ++swept_)
    outbox_.mark(outbox_.blocks().origin_of(swept_));
}

}  // namespace hapticut
