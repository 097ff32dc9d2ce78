// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Pieces that were cut loose. Voxels are joined where they share a face and both are filled enough; what is joined to
/// nothing that is fixed is an island.
namespace hapticut {

/// What is an island.
struct IslandOptions {
  double min_fill = 0.05;
  std::optional<Box> fixed;
};

constexpr auto fields_of(Of<IslandOptions>) {
  using O = IslandOptions;
  return std::tuple{
      field("min_fill", &O::min_fill, "1", Range::between(0, 1),
            "voxels that are filled less join nothing; those that touch an island leave with it"),
      field("fixed", &O::fixed,
            "[m] in W: what is joined to a voxel centred in this box stays; empty: the largest of the pieces stays"),
  };
}

/// A piece that nothing holds.
struct Island {
  std::vector<BlockVoxels> blocks;  ///< in the order of their origins; without a voxel where only its skin may be
  std::int64_t voxels = 0;          ///< in all of them
  double min_fill = 0;              ///< [1] IslandOptions::min_fill that it was found with

  [[nodiscard]] bool operator==(const Island&) const = default;
};

/// Finds islands beside a loop: it knows which voxels are filled, is told of blocks that have changed, and looks at
/// what is left around the voxels that went.
///
/// The pieces around them grow alternately, the smallest first, until all but one are closed: so a search costs as much
/// as the smaller pieces have blocks, and next to nothing where they are joined nearby. Bodies that were apart from the
/// beginning are left alone.
///
/// Not thread-safe; needs 64 bytes for every block within the workpiece's bounds.
class IslandFinder {
 public:
  /// @throws Error when an option is out of range, or the workpiece spans too many blocks
  explicit IslandFinder(const Workpiece& workpiece, const IslandOptions& options = {});

  /// A block as it is now. Material that came back, by an undo, joins again.
  /// @param fill  [512] 0 where there is nothing
  void update(const VoxelIndex& origin, const float* fill);

  /// The same for blocks of a workpiece, those that a step has changed.
  void update(const Workpiece& workpiece, std::span<const VoxelIndex> origins);

  /// Pieces that have come loose by what went since the last call, in the order of their first voxels. Each is found
  /// once, and from then on is taken to be gone; where it stayed, say so by `update`.
  [[nodiscard]] std::vector<Island> find();

 private:
  void update(const BlockView& block);
  [[nodiscard]] Island take_out(const std::vector<std::pair<std::size_t, BlockMask>>& parts);

  friend class IslandSearch;
  friend std::vector<Island> find_islands(const Workpiece& workpiece, const IslandOptions& options);
  IslandOptions options_;
  BlockGrid blocks_;
  std::vector<BlockMask> solid_;           // filled enough
  std::map<std::size_t, BlockMask> gone_;  // since the last search, by number of the block
  GridFrame frame_;
};

/// All pieces of a workpiece as it is that nothing holds, whether they were cut loose or not: all but the largest one,
/// or all that are not joined to IslandOptions::fixed. In the order of their first voxels.
/// @throws Error as IslandFinder
[[nodiscard]] std::vector<Island> find_islands(const Workpiece& workpiece, const IslandOptions& options = {});

/// The way of an island out of a workpiece, in slices: see remove_island.
struct IslandRemoval {
  Island island;               ///< what is to leave
  std::size_t checked = 0;     ///< blocks of it that were seen to touch nothing else
  std::size_t removed = 0;     ///< blocks of it that have left
  bool joined = false;         ///< it touches something, by an undo since it was found, or was exchanged: it stays
  std::uint64_t exchange = 0;  ///< Simulation::workpiece_exchanges when it began

  [[nodiscard]] bool is_over() const noexcept { return joined || removed == island.blocks.size(); }
};

/// Goes on with the removal of an island, by up to `most` blocks (and at least one), 1 us each: first it is seen
/// whether it still is one, then it leaves block by block (Simulation::remove_voxels). Between two steps; the tool goes
/// on as it does, and `Simulation::changed_blocks` names the blocks as well. To be called until it says that it is
/// over.
/// @return true when the island is gone, or cannot go: IslandRemoval::joined
/// @realtime no allocation, no lock; O(most)
bool remove_island(Simulation& simulation, IslandRemoval& removal, std::size_t most) noexcept;

/// Whether one block of an island touches no voxel that is filled enough and does not belong to it.
/// @param block  number of the block in Island::blocks
/// @realtime no allocation, no lock; O(512)
[[nodiscard]] bool is_loose(const Island& island, std::size_t block, const Workpiece& workpiece) noexcept;

/// What leaves with one block of an island: its voxels that are still there, and those that are filled less than
/// `min_fill` and touch it.
/// @realtime no allocation, no lock; O(512)
[[nodiscard]] BlockVoxels with_skin(const Island& island, std::size_t block, const Workpiece& workpiece) noexcept;

}  // namespace hapticut
