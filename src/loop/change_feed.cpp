// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/change_feed.hpp"

#include <utility>

#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

ChangeFeed::ChangeFeed(Simulation& simulation, const IndexBox& region, std::size_t block_capacity)
    : simulation_(simulation),
      outbox_(region, block_capacity),
      all_(std::size_t(outbox_.blocks().count())),
      swept_(all_) {}

ChangeFeed::ChangeFeed(Simulation& simulation, const ChangeFeedOptions& options)
    : ChangeFeed(simulation, simulation.workpiece().bounds(), options.block_capacity) {
  require_fields_within(options, "ChangeFeedOptions::");
  per_step_ = options.blocks_per_step;
  attach();
}

ChangeFeed::~ChangeFeed() { detach(); }

void ChangeFeed::attach() {
  if (is_observing_) return;
  simulation_.add_observer(*this);
  is_observing_ = true;
}

void ChangeFeed::detach() noexcept {
  if (std::exchange(is_observing_, false)) simulation_.remove_observer(*this);
}

void ChangeFeed::on_step(const ObservedStep& /*step*/) noexcept {
  mark_changes();
  tick(per_step_, 0);
}

void ChangeFeed::mark_changes() noexcept {
  const ChangedBlocks changed = simulation_.changed_blocks();
  for (const VoxelIndex& origin : changed.origins) outbox_.mark(origin);
  if (!changed.complete) swept_ = 0;
}

void ChangeFeed::tick(std::size_t max_blocks, std::uint32_t workpiece_number) noexcept {
  for (; swept_ < all_ && outbox_.marked() < max_blocks; ++swept_) outbox_.mark(outbox_.blocks().origin_of(swept_));
  outbox_.send(simulation_.workpiece(), workpiece_number, max_blocks);
}

}  // namespace hapticut
