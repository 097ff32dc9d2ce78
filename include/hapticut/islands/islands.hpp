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

/// Pieces that were cut loose. Voxels are joined if they share a face and both are filled enough. A piece that is not
/// joined to anything fixed is an island.
namespace hapticut {

/// Definition of an island.
struct IslandOptions {
  double min_fill = 0.05;  ///< [1] voxels with less fill join nothing; those that touch an island are removed with it
  /// [m] box in W: pieces joined to a voxel centred in it stay; empty: the largest piece stays
  std::optional<Box> fixed;
};

constexpr auto fields_of(Of<IslandOptions>) {
  using O = IslandOptions;
  return std::tuple{
      field("min_fill", &O::min_fill, "1", Range::between(0, 1),
            "voxels with less fill join nothing; those that touch an island are removed with it"),
      field("fixed", &O::fixed,
            "[m] box in W: pieces joined to a voxel centred in it stay; empty: the largest piece stays"),
  };
}

/// @throws Error when a value is out of range, or the box `fixed` is not finite or has a min above its max
void validate(const IslandOptions& options);

/// A piece that nothing holds.
struct Island {
  std::vector<BlockVoxels> blocks;  ///< ordered by origin; without voxels in blocks that contain only its skin
  std::int64_t voxels = 0;          ///< number in all blocks
  double min_fill = 0;              ///< [1] IslandOptions::min_fill of the search

  [[nodiscard]] bool operator==(const Island&) const = default;
};

/// Finds islands beside a loop. It keeps a copy of which voxels are filled, is told of changed blocks, and searches
/// around the removed voxels.
///
/// The pieces around them grow alternately, the smallest first, until all but one are closed. So the cost of a search
/// is proportional to the blocks of the smaller pieces, and nearly zero if the pieces are joined nearby. Bodies that
/// were separate from the beginning are not islands.
///
/// A finder is for one workpiece: make another one after an exchange of the workpiece. Not thread-safe; needs 128 bytes
/// for every block within the workpiece's bounds.
class IslandFinder {
 public:
  /// @throws Error as `validate`, or when the box IslandOptions::fixed contains no voxel of the workpiece, or the
  /// workpiece
  ///         spans too many blocks
  explicit IslandFinder(const Workpiece& workpiece, const IslandOptions& options = {});

  /// Begins without a workpiece. The first `update` of each block tells what it has at the beginning; `find` finds
  /// nothing until it was called for all blocks.
  /// @param voxels  whose blocks are searched
  /// @throws Error as `validate`, or when the box has too many blocks
  IslandFinder(const IndexBox& voxels, const GridFrame& frame, const IslandOptions& options);

  /// Updates a block to its present content. Material that an undo has restored counts as present again; if it is
  /// loose, `find` finds it again.
  /// @param fill  [512] 0: empty
  void update(const VoxelIndex& origin, const float* fill);

  /// Updates blocks of a workpiece that a step has changed.
  void update(const Workpiece& workpiece, std::span<const VoxelIndex> origins);

  /// Pieces that came loose since the last call, in the order of their first voxels. Each is found once and then
  /// treated as removed; if it stays, call `update` for its blocks.
  [[nodiscard]] std::vector<Island> find();

 private:
  IslandFinder(const Workpiece& workpiece, const IndexBox& voxels, const IslandOptions& options);
  void update(const BlockView& block);
  void add_removed_around(const std::map<std::size_t, BlockMask>& returned);
  [[nodiscard]] float min_fill() const noexcept;
  [[nodiscard]] bool is_fixed(const VoxelIndex& origin, const BlockMask& voxels) const;
  [[nodiscard]] Island extract(const std::vector<std::pair<std::size_t, BlockMask>>& blocks);

  friend class IslandSearch;
  friend class IslandWatch;
  friend std::vector<Island> find_islands(const Workpiece& workpiece, const IslandOptions& options);
  IslandOptions options_;
  BlockGrid blocks_;
  std::size_t unknown_ = 0;  // blocks that were not yet updated
  std::vector<bool> is_known_;
  std::vector<BlockMask> solid_, first_;                 // filled enough: now, and ever
  std::map<std::size_t, BlockMask> removed_, returned_;  // since the last search, by number of the block
  GridFrame frame_;
};

/// All islands of the present workpiece, whether they were cut loose or not: all pieces except the largest, or all that
/// are not joined to IslandOptions::fixed. In the order of their first voxels.
/// @throws Error as the constructor of IslandFinder
[[nodiscard]] std::vector<Island> find_islands(const Workpiece& workpiece, const IslandOptions& options = {});

/// Progress of the removal of an island: see remove_island.
struct IslandRemoval {
  Island island;               ///< the island to remove
  std::size_t checked = 0;     ///< blocks of it that were checked and touch nothing else
  std::size_t removed = 0;     ///< blocks of it that were removed
  bool joined = false;         ///< it stays, because it touches something after an undo, or the workpiece was exchanged
  std::uint64_t exchange = 0;  ///< SimulationTotals::exchanges at the beginning

  [[nodiscard]] bool is_over() const noexcept { return joined || removed == island.blocks.size(); }
};

/// Continues the removal of an island, by up to `max_blocks` blocks (and at least one), 1 us each. First all blocks are
/// checked: is it still an island? Then it is removed block by block (Simulation::remove_voxels). To be called between
/// two steps until it returns true. The tool is not affected, and `Simulation::changed_blocks` lists the blocks.
/// @return true when the island is removed, or stays: IslandRemoval::joined
/// @realtime no allocation, no lock; O(max_blocks)
bool remove_island(Simulation& simulation, IslandRemoval& removal, std::size_t max_blocks) noexcept;

/// Whether one block of an island touches no other voxel that is filled enough, in this block or in a block beside it
/// that is not in Island::blocks.
/// @param block  number of the block in Island::blocks
/// @realtime no allocation, no lock; O(512)
[[nodiscard]] bool is_loose(const Island& island, std::size_t block, const Workpiece& workpiece) noexcept;

/// The voxels to remove with one block of an island: those of the island that are still there, and those with less fill
/// than `min_fill` that touch it.
/// @realtime no allocation, no lock; O(512)
[[nodiscard]] BlockVoxels with_skin(const Island& island, std::size_t block, const Workpiece& workpiece) noexcept;

}  // namespace hapticut
