// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/workpiece/block.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// Volume and mass of one material of a workpiece.
struct MaterialAmount {
  MaterialId material;
  std::int64_t voxels;  ///< not yet empty
  double volume;        ///< [m^3] partly filled voxels counted by their fraction
  double mass;          ///< [kg]
};

struct SavedBlock;

/// A frozen copy of the state of a workpiece, to return to. Cheap to copy; shares its memory.
class WorkpieceSnapshot {
 private:
  friend class Workpiece;
  std::shared_ptr<const void> state_;
};

/// What is cut: a sparse OpenVDB grid of material ids and, only where a voxel is partly filled, of filled fractions.
///
/// Homogeneous interiors are stored as tiles and cost no memory per voxel. Cutting turns tiles into blocks; the blocks
/// come from a pool that `reserve_blocks` fills beforehand, so that cutting never allocates. Blocks that become empty
/// go back to the pool.
///
/// A workpiece moves but does not copy by accident: use `clone`. Not thread-safe; a simulation owns its workpiece.
class Workpiece {
 public:
  /// Fills one block: return its kind and, when it is mixed, write all of `content`. Called from several threads at
  /// once, once per block, so it must not change shared state.
  using BlockFiller = std::function<BlockKind(const VoxelIndex& block_origin, BlockContent& content)>;

  /// Builds a workpiece block by block.
  /// @param domain  voxels that may be solid; the filler is asked for every block that touches it, and what it writes
  ///                outside the domain is dropped
  /// @throws Error when the voxel size is not positive, the frame is not a pose, the domain has more than 2^40 voxels
  ///         or reaches beyond +-2^30, a material id is not in the table, or a fill is not within 0 ... 1
  [[nodiscard]] static Workpiece from_blocks(const IndexBox& domain, const GridFrame& frame, MaterialTable materials,
                                             const BlockFiller& fill_block);

  Workpiece(Workpiece&&) noexcept;
  Workpiece& operator=(Workpiece&&) noexcept;
  ~Workpiece();

  [[nodiscard]] Workpiece clone() const;  ///< a deep copy with an empty pool

  // --- what it is ---------------------------------------------------------------------------------------------------
  [[nodiscard]] const GridFrame& frame() const;
  [[nodiscard]] double voxel_size() const { return frame().voxel_size; }  ///< [m]
  [[nodiscard]] const MaterialTable& materials() const;
  [[nodiscard]] IndexBox bounds() const;                      ///< smallest box around all voxels that are not empty
  [[nodiscard]] bool empty() const;                           ///< nothing left at all
  [[nodiscard]] std::int64_t solid_voxels() const;            ///< voxels that are not yet empty
  [[nodiscard]] std::size_t memory_bytes() const;             ///< of the trees, without the pool
  [[nodiscard]] std::size_t pool_bytes() const;               ///< of the blocks held ready for cutting
  [[nodiscard]] std::vector<MaterialAmount> amounts() const;  ///< one entry per material of the table
  [[nodiscard]] MaterialId material_at(const VoxelIndex& index) const;  ///< kEmpty outside
  [[nodiscard]] double fill_at(const VoxelIndex& index) const;          ///< [1] 0 outside
  [[nodiscard]] CentroidOffset centroid_at(const VoxelIndex& index) const;

  /// Calls `function(view)` for every block that is not empty, in a fixed order; uniform regions come block by block.
  void for_each_block(const std::function<void(const BlockView&)>& function) const;

  /// A number that depends on every voxel's material and fill, bit by bit: equal states have equal hashes.
  [[nodiscard]] std::uint64_t hash() const;

  /// Changes the constants of the materials, not what is where.
  /// @throws Error when there are not as many materials as before
  void set_materials(MaterialTable materials);

  /// The same between two steps of a loop; `materials` are then those of before.
  /// @return false, and nothing has changed, when there are not as many
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] bool exchange_materials(MaterialTable& materials) noexcept;

  // --- undo ---------------------------------------------------------------------------------------------------------
  [[nodiscard]] WorkpieceSnapshot snapshot() const;

  /// @throws Error when the snapshot is empty
  void restore(const WorkpieceSnapshot& snapshot);

  // --- undo without an allocation, for a loop that goes on ----------------------------------------------------------
  /// Set-up only: memory for marks and for `blocks` blocks that are cut after them, 2.7 kB each, and 4 bytes for every
  /// block that the workpiece's bounds span; 0: no undo. Forgets all marks, as `restore` does.
  /// @throws Error when the workpiece spans too many blocks, or there is no such memory; then nothing has changed
  void reserve_undo(std::size_t blocks);

  [[nodiscard]] std::size_t undo_blocks() const noexcept;  ///< that `reserve_undo` asked for

  /// Marks the present state, to return to it. With more than 64 marks, or where the memory is full, the oldest is
  /// forgotten.
  /// @return false: there is no mark, because `reserve_undo` was not called
  /// @realtime no allocation, no lock; O(1)
  bool set_mark() noexcept;

  [[nodiscard]] std::size_t marks() const noexcept;       ///< that can be returned to
  [[nodiscard]] std::size_t redo_marks() const noexcept;  ///< undone ones that `redo_block` can go forth over

  /// Puts one block back to what it was at the last mark, and remembers what it was until now.
  /// @return its origin; nothing when the state is that of the mark, which is then gone
  /// @realtime no allocation, no lock; O(512)
  std::optional<VoxelIndex> undo_block() noexcept;

  /// Goes forth again by one block over the mark that was undone last; needs no other memory than the way back.
  /// @return its origin; nothing when the state is that before the undo, the mark being there again, or when something
  ///         has been cut since
  /// @realtime no allocation, no lock; O(512)
  std::optional<VoxelIndex> redo_block() noexcept;

  // --- cutting: what the step calls ---------------------------------------------------------------------------------
  /// Set-up only: holds memory ready for `count` blocks to become partly cut.
  void reserve_blocks(std::size_t count);
  [[nodiscard]] std::size_t reserved_blocks() const;  ///< blocks still in the pool

  /// The block that starts at `origin` (a multiple of 8 along each axis).  @realtime no allocation, no lock; O(1)
  [[nodiscard]] BlockView block(const VoxelIndex& origin) const noexcept;

  /// The same block, to be cut.  @realtime no allocation, no lock; O(1)
  [[nodiscard]] CuttableBlock cuttable_block(const VoxelIndex& origin) noexcept;

  /// Must be called before fills are written into CuttableBlock::fill: keeps the block for `undo_block`.
  /// @realtime no allocation, no lock; O(512) once a mark, then O(1)
  void remember(const BlockView& block) noexcept;

  /// Must be called when something was cut: there is nothing to go forth to any more.
  /// @realtime no allocation, no lock; O(1)
  void forget_redo() noexcept;

  /// Whether `writable_fill` would return memory for a block.
  /// @realtime no allocation, no lock
  [[nodiscard]] bool has_reserve_for(const VoxelIndex& origin) const noexcept;

  /// Writable fill fractions of one block, [512]; a block that was uniform or full gets memory from the pool.
  /// @return null when the pool is exhausted: the block must stay as it is
  /// @realtime no allocation, no lock; O(512)
  [[nodiscard]] float* writable_fill(const VoxelIndex& origin) noexcept;

  /// Empties voxels of one block and sets their fill to 0. A block with nothing left goes back to the pool: pointers
  /// into it are then void.
  /// @pre `writable_fill` returned memory for this block
  /// @realtime no allocation, no lock; O(512)
  void empty_voxels(const VoxelIndex& origin, const BlockMask& emptied) noexcept;

 private:
  friend struct WorkpieceAccess;  // the door to the trees, for workpiece/openvdb.hpp and the file formats
  struct State;
  void exchange_block(SavedBlock& other) noexcept;
  void put_content(const SavedBlock& content) noexcept;
  explicit Workpiece(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
