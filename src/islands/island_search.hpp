// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hapticut/islands/islands.hpp"

namespace hapticut {

/// Disjoint sets that can be joined, with data of each set.
template <class Of>
class JoinedSets {
 public:
  std::size_t add(Of of) {
    parent_.push_back(parent_.size());
    of_.push_back(std::move(of));
    return parent_.size() - 1;
  }
  [[nodiscard]] std::size_t root(std::size_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  /// @pre both are roots
  void join(std::size_t into, std::size_t other) { parent_[other] = into; }
  [[nodiscard]] Of& operator[](std::size_t root) { return of_[root]; }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

 private:
  std::vector<std::size_t> parent_;
  std::vector<Of> of_;
};

/// A search for pieces. Each grows over the voxels that are joined to it, until it meets another piece or is closed.
/// Pieces that were one body before belong to one group; one piece of each group stays.
class IslandSearch {
 public:
  using PieceBlocks = std::vector<std::pair<std::size_t, BlockMask>>;  // voxels of a piece, by number of the block

  explicit IslandSearch(const IslandFinder& finder) : finder_(finder) {}

  /// @param lost_fixed  a voxel in IslandOptions::fixed was removed, so perhaps no piece of the group is fixed any more
  std::size_t add_group(bool lost_fixed) { return groups_.add({0, 0, false, lost_fixed}); }

  /// Begins pieces at some voxels of a block, all of one group.
  void begin(std::size_t block, BlockMask seeds, std::size_t group) {
    for (seeds = seeds & finder_.solid_[block]; !seeds.empty();) {
      const BlockMask one = seeds.first();
      const std::size_t piece = pieces_.add({groups_.root(group), 0, true, false, {{block, one}}});
      ++groups_[groups_.root(group)].open;
      grow(piece);
      enqueue(piece);
      for (const PieceInBlock& found : found_[block])  // those of other groups must still be met
        if (!(one & found.voxels).empty()) seeds = seeds.without(found.voxels);
    }
  }

  /// Grows the smallest pieces until it is known which pieces of each group are closed and do not stay.
  void grow_until_settled() {
    while (!waiting_.empty()) {
      const auto [voxels, piece] = waiting_.top();
      waiting_.pop();
      const bool has_grown = pieces_.root(piece) != piece || pieces_[piece].voxels != voxels;
      if (has_grown || !pieces_[piece].open || is_settled(piece)) continue;
      grow(piece);
      enqueue(piece);
    }
  }

  /// Grows all pieces completely.
  void grow_all() {
    for (std::size_t n = 0; n < pieces_.size(); ++n)
      while (pieces_.root(n) == n && pieces_[n].open) grow(n);
  }

  [[nodiscard]] BlockMask found_in(std::size_t block) const {
    BlockMask all = {};
    if (const auto here = found_.find(block); here != found_.end())
      for (const PieceInBlock& found : here->second) all = all | found.voxels;
    return all;
  }

  /// The closed pieces, except the one of each group that stays.
  [[nodiscard]] std::vector<PieceBlocks> islands() {
    std::unordered_map<std::size_t, PieceBlocks> blocks_of;
    for (const auto& [block, here] : found_)
      for (const PieceInBlock& found : here) blocks_of[pieces_.root(found.piece)].emplace_back(block, found.voxels);
    for (auto& [piece, all] : blocks_of) std::ranges::sort(all);
    std::unordered_map<std::size_t, std::size_t> stays;  // piece of each group
    for (const auto& [piece, all] : blocks_of) {
      const auto [known, first] = stays.try_emplace(groups_.root(pieces_[piece].group), piece);
      if (!first && is_preferred(piece, known->second, blocks_of)) known->second = piece;
    }
    std::vector<PieceBlocks> islands;
    for (auto& [piece, all] : blocks_of) {
      const Piece& of = pieces_[piece];
      const std::size_t group = groups_.root(of.group);
      if (!of.open && !of.fixed && (groups_[group].lost_fixed || stays[group] != piece))
        islands.push_back(std::move(all));
    }
    std::ranges::sort(islands);
    return islands;
  }

 private:
  struct Piece {
    std::size_t group;
    std::int64_t voxels;                                      // found so far
    bool open;                                                // it may grow further
    bool fixed;                                               // it contains a fixed voxel, and need not grow further
    std::vector<std::pair<std::size_t, BlockMask>> frontier;  // where it grows: blocks, and voxels of them
  };
  struct Group {
    int open = 0;             // open pieces of the group
    std::int64_t closed = 0;  // [voxels] size of its largest closed piece
    bool fixed = false;       // a piece of it is fixed
    bool lost_fixed = false;  // perhaps none is
  };
  struct PieceInBlock {
    BlockMask voxels;  // joined inside the block
    std::size_t piece;
  };

  void enqueue(std::size_t piece) {
    const std::size_t at = pieces_.root(piece);
    if (pieces_[at].open) waiting_.push({pieces_[at].voxels, at});
  }

  /// Whether the open piece is the only one of its group, and is known to stay: it is the largest one, or the only one
  /// that can be fixed.
  [[nodiscard]] bool is_settled(std::size_t piece) {
    const Group& group = groups_[groups_.root(pieces_[piece].group)];
    if (group.open > 1) return false;
    if (finder_.options_.fixed) return !group.fixed && !group.lost_fixed;
    return pieces_[piece].voxels > group.closed;
  }

  [[nodiscard]] bool is_preferred(std::size_t a, std::size_t b,
                                  std::unordered_map<std::size_t, PieceBlocks>& blocks_of) {
    const Piece &of_a = pieces_[a], &of_b = pieces_[b];
    if (of_a.fixed != of_b.fixed) return of_a.fixed;
    if (of_a.open != of_b.open) return of_a.open;
    if (of_a.voxels != of_b.voxels) return of_a.voxels > of_b.voxels;
    return blocks_of[a] < blocks_of[b];
  }

  /// Grows a piece by one block.
  void grow(std::size_t piece) {
    auto [block, bits] = pieces_[piece].frontier.back();
    pieces_[piece].frontier.pop_back();
    std::vector<PieceInBlock>& here = found_[block];
    for (PieceInBlock& found : here)
      if (!(bits & found.voxels).empty()) {
        bits = bits.without(found.voxels);
        piece = join(piece, pieces_.root(found.piece));
      }
    bits = bits.joined(finder_.solid_[block]);
    if (!bits.empty()) {
      here.push_back({bits, piece});
      Piece& of = pieces_[piece];
      of.voxels += bits.count();
      const VoxelIndex origin = finder_.blocks_.origin_of(block);
      for (int side = 0; side < kSides; ++side) {
        const auto next = finder_.blocks_.number_of(beside(origin, side));
        if (!next) continue;
        const BlockMask there = bits.across(side) & finder_.solid_[*next];
        if (!there.empty()) of.frontier.emplace_back(*next, there);
      }
      if (finder_.is_fixed(origin, bits)) fix(piece);
    }
    if (pieces_[piece].open && pieces_[piece].frontier.empty()) close(piece);
  }

  /// Joins two pieces and their groups.  @return the root
  std::size_t join(std::size_t a, std::size_t b) {
    if (a == b) return a;
    if (pieces_[a].frontier.size() < pieces_[b].frontier.size()) std::swap(a, b);
    Piece &into = pieces_[a], &other = pieces_[b];
    const std::size_t group = join_groups(groups_.root(into.group), groups_.root(other.group));
    groups_[group].open -= int(into.open) + int(other.open);
    pieces_.join(a, b);
    into.voxels += other.voxels;
    into.fixed |= other.fixed;
    into.open = !into.fixed;
    into.group = group;
    into.frontier.insert(into.frontier.end(), other.frontier.begin(), other.frontier.end());
    other.frontier = {};
    groups_[group].open += int(into.open);
    return a;
  }

  std::size_t join_groups(std::size_t a, std::size_t b) {
    if (a == b) return a;
    Group& into = groups_[a];
    const Group& other = groups_[b];
    into.open += other.open;
    into.closed = std::max(into.closed, other.closed);
    into.fixed |= other.fixed;
    into.lost_fixed |= other.lost_fixed;
    groups_.join(a, b);
    return a;
  }

  void close(std::size_t piece) {
    Group& group = groups_[groups_.root(pieces_[piece].group)];
    pieces_[piece].open = false;
    --group.open;
    group.closed = std::max(group.closed, pieces_[piece].voxels);
  }

  void fix(std::size_t piece) {
    if (pieces_[piece].fixed) return;
    Group& group = groups_[groups_.root(pieces_[piece].group)];
    if (std::exchange(pieces_[piece].open, false)) --group.open;
    pieces_[piece].fixed = group.fixed = true;
  }

  using Entry = std::pair<std::int64_t, std::size_t>;  // voxels, piece

  const IslandFinder& finder_;
  JoinedSets<Piece> pieces_;
  JoinedSets<Group> groups_;
  std::unordered_map<std::size_t, std::vector<PieceInBlock>> found_;  // by number of the block
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

}  // namespace hapticut
