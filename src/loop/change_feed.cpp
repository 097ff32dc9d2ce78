// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/change_feed.hpp"

#include <algorithm>
#include <utility>

#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

ChangeFeed::ChangeFeed(Simulation& simulation, const IndexBox& region, std::size_t block_capacity)
    : simulation_(simulation),
      outbox_(region, block_capacity),
      all_(std::size_t(outbox_.blocks().count())),
      swept_(all_) {}

ChangeFeed::ChangeFeed(Simulation& simulation, const ChangeFeedOptions& options)
    : ChangeFeed(simulation, simulation.first_bounds(), options.block_capacity) {
  require_fields_within(options, "ChangeFeedOptions::");
  per_step_ = options.blocks_per_step;
  first_workpiece_ = simulation.totals().replacements;
  attach();
}

ChangeFeed::~ChangeFeed() { detach(); }

ChangeFeed::Counts ChangeFeed::counts() const noexcept {
  return {simulation_.steps(), simulation_.totals().exchanges, simulation_.totals().detached_volume};
}

void ChangeFeed::attach() {
  if (is_observing_) return;
  simulation_.observers().add(*this);
  is_observing_ = true;
  outbox_.mark_kept();
  if (!at_detach_) workpiece_ = simulation_.totals().replacements;
  note_replacement();
  if (at_detach_ && *at_detach_ != counts()) send_all();
}

void ChangeFeed::detach() noexcept {
  if (!std::exchange(is_observing_, false)) return;
  simulation_.observers().remove(*this);
  at_detach_ = counts();
}

void ChangeFeed::on_step(const ObservedStep& /*step*/) noexcept {
  mark_changes();
  tick(per_step_, std::uint32_t(simulation_.totals().replacements - first_workpiece_));
}

void ChangeFeed::on_exchange() noexcept {
  note_replacement();
  mark_changes();
}

/// Counts the blocks outside the region of a workpiece that was put in place.
void ChangeFeed::note_replacement() noexcept {
  const std::uint64_t workpiece = simulation_.totals().replacements;
  if (std::exchange(workpiece_, workpiece) != workpiece) outbox_.count_outside(simulation_.first_bounds());
}

void ChangeFeed::keep_rest(std::uint32_t workpiece_number) {
  outbox_.keep_marked(simulation_.workpiece(), workpiece_number);
  while (swept_ < all_) outbox_.keep(simulation_.workpiece(), workpiece_number, swept_++);
}

void ChangeFeed::mark_changes() noexcept {
  const ChangedBlocks changed = simulation_.changed_blocks();
  for (const VoxelIndex& origin : changed.origins) outbox_.mark(origin);
  if (!changed.complete) send_all();
}

void ChangeFeed::tick(std::size_t max_blocks, std::uint32_t workpiece_number) noexcept {
  const std::size_t room = std::min(max_blocks, outbox_.room()), unswept = all_ - swept_;
  // Half of the room is for the sweep, or a steady cut would keep it from ending. It gets an odd place in turns.
  const std::size_t for_sweep = std::min(unswept, (room + std::size_t(sweeps_more_)) / 2);
  if (unswept > 0 && room % 2 == 1) sweeps_more_ = !sweeps_more_;
  std::size_t sent = outbox_.send(simulation_.workpiece(), workpiece_number, room - for_sweep);
  for (; sent < room && swept_ < all_; ++sent) outbox_.send_now(simulation_.workpiece(), workpiece_number, swept_++);
}

}  // namespace hapticut
