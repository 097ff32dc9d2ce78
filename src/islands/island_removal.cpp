// SPDX-License-Identifier: Apache-2.0
// The removal of an island: the voxels to remove with a block, and the check whether it is still loose.
#include <algorithm>

#include "hapticut/islands/islands.hpp"

namespace hapticut {
namespace {

/// The block of an island that begins there; null: it has none.
const BlockVoxels* block_at(const Island& island, const VoxelIndex& origin) noexcept {
  const auto at = std::ranges::lower_bound(island.blocks, origin, {}, &BlockVoxels::origin);
  return at != island.blocks.end() && at->origin == origin ? &*at : nullptr;
}

/// The voxels of a block that belong to an island or touch it.
BlockMask around(const Island& island, const BlockVoxels& block) noexcept {
  BlockMask mask = block.voxels.grown();
  for (int side = 0; side < kSides; ++side)
    if (const BlockVoxels* next = block_at(island, beside(block.origin, side)))
      mask = mask | next->voxels.across(side ^ 1);
  return mask;
}

BlockMask filled_enough(const Island& island, const BlockView& block) noexcept {
  return block.filled_voxels(float(island.min_fill));
}

}  // namespace

bool is_loose(const Island& island, std::size_t block, const Workpiece& workpiece) noexcept {
  const BlockVoxels& here = island.blocks[block];
  const BlockMask others = filled_enough(island, workpiece.block(here.origin)).without(here.voxels);
  if (!(around(island, here) & others).empty()) return false;
  for (int side = 0; side < kSides; ++side) {
    const VoxelIndex origin = beside(here.origin, side);
    const BlockMask touched = here.voxels.across(side);
    if (touched.empty() || block_at(island, origin) != nullptr) continue;  // a listed block is checked itself
    if (!(touched & filled_enough(island, workpiece.block(origin))).empty()) return false;
  }
  return true;
}

BlockVoxels with_skin(const Island& island, std::size_t block, const Workpiece& workpiece) noexcept {
  const BlockVoxels& here = island.blocks[block];
  const BlockView now = workpiece.block(here.origin);
  const BlockMask there = now.filled_voxels(0), skin = there.without(filled_enough(island, now));
  return {here.origin, there & (here.voxels | (skin & around(island, here)))};
}

bool remove_island(Simulation& simulation, IslandRemoval& removal, std::size_t max_blocks) noexcept {
  const Workpiece& workpiece = simulation.workpiece();
  std::size_t done = 0;
  do {  // at least one, or a caller that passes 0 would never finish
    if (removal.checked == 0) removal.exchange = simulation.totals().exchanges;
    if (removal.exchange != simulation.totals().exchanges) removal.joined = true;
    if (removal.is_over()) return true;
    if (removal.checked < removal.island.blocks.size()) {
      if (!is_loose(removal.island, removal.checked++, workpiece)) removal.joined = true;
    } else {
      if (!simulation.remove_voxels(with_skin(removal.island, removal.removed, workpiece))) return false;
      ++removal.removed;
    }
  } while (++done < max_blocks);
  return removal.is_over();
}

}  // namespace hapticut
