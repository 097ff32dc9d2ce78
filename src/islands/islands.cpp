// SPDX-License-Identifier: Apache-2.0
// Pieces that were cut loose: a search over blocks, 512 voxels at a time as bits.
#include "hapticut/islands/islands.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/interruption.hpp"
#include "hapticut/core/errors.hpp"
#include "islands/island_search.hpp"

namespace hapticut {
namespace {

constexpr double kMaxWatchedBlocks = 1 << 25;  // 2 GB of bits

}  // namespace

void validate(const IslandOptions& options) {
  require_fields_within(options, "IslandOptions::");
  const std::optional<Box>& box = options.fixed;
  if (!box) return;
  if (!is_finite(box->min) || !is_finite(box->max))
    throw Error("IslandOptions::fixed"_name + " is not finite; give both corners of the box in m, or leave it empty.");
  if (!(box->min.array() <= box->max.array()).all())
    throw Error("IslandOptions::fixed"_name +
                " has a min that is larger than its max along an axis; exchange the two.");
}

IslandFinder::IslandFinder(const IndexBox& voxels, const GridFrame& frame, const IslandOptions& options)
    : options_(options), blocks_(voxels), frame_(frame) {
  validate(options);
  const double blocks = blocks_.count();
  if (blocks > kMaxWatchedBlocks)
    throw Error("the workpiece spans " + format_number(blocks) + " blocks, more than " +
                format_number(kMaxWatchedBlocks) + " in which islands can be found; crop it.");
  unknown_ = std::size_t(blocks);
  is_known_.resize(unknown_);
  solid_.resize(unknown_);
  first_.resize(unknown_);
}

IslandFinder::IslandFinder(const Workpiece& workpiece, const IslandOptions& options)
    : IslandFinder(workpiece, workpiece.bounds(), options) {}

IslandFinder::IslandFinder(const Workpiece& workpiece, const IndexBox& voxels, const IslandOptions& options)
    : IslandFinder(voxels, workpiece.frame(), options) {
  bool any_fixed = false;
  workpiece.for_each_block([&](const BlockView& block) {
    update(block);
    any_fixed = any_fixed || is_fixed(block.origin, block.filled_voxels(min_fill()));
  });
  if (options_.fixed && !any_fixed && !workpiece.empty())
    throw Error("IslandOptions::fixed"_name +
                " contains the centre of no voxel of the workpiece, so nothing would stay. Give the box in m, "
                "in the frame W of the workpiece.");
  is_known_.assign(is_known_.size(), true);
  unknown_ = 0;
}

/// A voxel without fill is empty even if IslandOptions::min_fill is 0.
float IslandFinder::min_fill() const noexcept {
  return std::max(float(options_.min_fill), std::numeric_limits<float>::min());
}

/// Whether one of the voxels of a block is in IslandOptions::fixed.
bool IslandFinder::is_fixed(const VoxelIndex& origin, const BlockMask& voxels) const {
  const std::optional<Box>& box = options_.fixed;
  if (!box) return false;
  for (int n = 0; n < kBlockVoxels; ++n) {
    if (!voxels.has(n)) continue;
    const Vec3 p_W = frame_.center(voxel_at(origin, n));
    if ((p_W.array() >= box->min.array()).all() && (p_W.array() <= box->max.array()).all()) return true;
  }
  return false;
}

void IslandFinder::update(const VoxelIndex& origin, const float* fill) {
  BlockView block;
  block.origin = origin;
  block.uniform_material = 1;  // any material
  block.fill = fill;
  update(block);
}

void IslandFinder::update(const Workpiece& workpiece, std::span<const VoxelIndex> origins) {
  for (const VoxelIndex& origin : origins) update(workpiece.block(origin));
}

void IslandFinder::update(const BlockView& block) {
  const auto number = blocks_.number_of(block.origin);
  if (!number) return;
  const BlockMask now = block.filled_voxels(min_fill()), before = std::exchange(solid_[*number], now);
  first_[*number] = first_[*number] | now;
  if (!is_known_[*number]) {
    is_known_[*number] = true;
    --unknown_;
    return;
  }
  const auto note = [&](std::map<std::size_t, BlockMask>& blocks, const BlockMask& added, const BlockMask& undone) {
    const auto known = blocks.find(*number);
    const BlockMask all = known == blocks.end() ? added : (known->second | added).without(undone);
    if (!all.empty())
      blocks.insert_or_assign(*number, all);
    else if (known != blocks.end())
      blocks.erase(known);
  };
  note(removed_, before.without(now), now);
  note(returned_, now.without(before), BlockMask::all().without(now));
}

/// Adds the removed voxels around material that came back, at whatever time they were removed: they say which pieces
/// were one body before.
void IslandFinder::add_removed_around(const std::map<std::size_t, BlockMask>& returned) {
  std::map<std::size_t, BlockMask> reached;
  std::vector<std::pair<std::size_t, BlockMask>> frontier;
  const auto reach = [&](std::size_t block, const BlockMask& seeds) {
    const BlockMask removed = first_[block].without(solid_[block]);
    if ((seeds & removed).empty()) return;
    const BlockMask part = seeds.joined(removed), more = part.without(reached[block]);
    if (more.empty()) return;
    reached[block] = reached[block] | more;
    frontier.emplace_back(block, more);
  };
  const auto reach_beside = [&](std::size_t block, const BlockMask& voxels) {
    const VoxelIndex origin = blocks_.origin_of(block);
    for (int side = 0; side < kSides; ++side)
      if (const BlockMask there = voxels.across(side); !there.empty())
        if (const auto next = blocks_.number_of(beside(origin, side))) reach(*next, there);
  };
  for (const auto& [block, voxels] : returned) {
    reach(block, voxels.grown());
    reach_beside(block, voxels);
  }
  while (!frontier.empty()) {
    const auto [block, voxels] = frontier.back();
    frontier.pop_back();
    reach_beside(block, voxels);
  }
  for (const auto& [block, voxels] : reached) removed_[block] = removed_[block] | voxels;
}

std::vector<Island> IslandFinder::find() {
  if (unknown_ > 0) return {};
  add_removed_around(std::exchange(returned_, {}));
  IslandSearch search(*this);
  // Connected removed voxels and their neighbours were one body.
  for (auto removed = std::exchange(removed_, {}); !removed.empty();) {
    bool lost_fixed = false;
    std::map<std::size_t, BlockMask> touched;
    std::vector<std::pair<std::size_t, BlockMask>> frontier = {
        {removed.begin()->first, removed.begin()->second.first()}};
    while (!frontier.empty()) {
      const auto [block, seeds] = frontier.back();
      frontier.pop_back();
      const auto here = removed.find(block);
      if (here == removed.end()) continue;
      const BlockMask part = seeds.joined(here->second);
      if (here->second = here->second.without(part); here->second.empty()) removed.erase(here);
      touched[block] = touched[block] | part.grown();
      const VoxelIndex origin = blocks_.origin_of(block);
      lost_fixed = lost_fixed || is_fixed(origin, part);
      for (int side = 0; side < kSides; ++side)
        if (const BlockMask there = part.across(side); !there.empty())
          if (const auto next = blocks_.number_of(beside(origin, side))) {
            touched[*next] = touched[*next] | there;
            frontier.emplace_back(*next, there);
          }
    }
    const std::size_t group = search.add_group(lost_fixed);
    for (const auto& [block, seeds] : touched) search.begin(block, seeds, group);
  }
  search.grow_until_settled();
  std::vector<Island> islands;
  for (const IslandSearch::PieceBlocks& blocks : search.islands()) islands.push_back(extract(blocks));
  return islands;
}

/// Makes an island of a piece, with the blocks around it that may contain its skin, and treats it as removed.
Island IslandFinder::extract(const std::vector<std::pair<std::size_t, BlockMask>>& blocks) {
  std::map<std::size_t, BlockMask> all;
  for (const auto& [block, voxels] : blocks) {
    solid_[block] = solid_[block].without(voxels);
    all[block] = all[block] | voxels;
    const VoxelIndex origin = blocks_.origin_of(block);
    for (int side = 0; side < kSides; ++side)
      if (!voxels.across(side).empty())
        if (const auto next = blocks_.number_of(beside(origin, side))) all.try_emplace(*next, BlockMask{});
  }
  Island island;
  island.min_fill = options_.min_fill;
  for (const auto& [block, voxels] : all) {
    island.blocks.push_back({blocks_.origin_of(block), voxels});
    island.voxels += voxels.count();
  }
  return island;
}

std::vector<Island> find_islands(const Workpiece& workpiece, const IslandOptions& options) {
  IslandFinder finder(workpiece, options);
  IslandSearch search(finder);
  const std::size_t group = search.add_group(finder.options_.fixed.has_value());
  for (std::size_t block = 0; block < finder.solid_.size(); ++block) {
    look_for_interruption();
    search.begin(block, finder.solid_[block].without(search.found_in(block)), group);
    search.grow_all();
  }
  std::vector<Island> islands;
  for (const IslandSearch::PieceBlocks& blocks : search.islands()) islands.push_back(finder.extract(blocks));
  return islands;
}

}  // namespace hapticut
