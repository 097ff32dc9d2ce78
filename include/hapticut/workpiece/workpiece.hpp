// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/workpiece/block.hpp"
#include "hapticut/workpiece/material.hpp"
#include "hapticut/workpiece/ray.hpp"

namespace hapticut {

/// Volume, mass and centre of one material of a workpiece.
struct MaterialAmount {
  MaterialId material;
  std::int64_t voxels;  ///< not yet empty
  double volume;        ///< [m^3] partly filled voxels counted by their fraction
  double mass;          ///< [kg]
  Vec3 center;          ///< [m] centre of the volume, in W; NaN if no voxel has the material
};

struct SavedBlock;

/// An immutable copy of the voxels of a workpiece, for `Workpiece::restore`. Copies share memory and are cheap.
class WorkpieceSnapshot {
 private:
  friend class Workpiece;
  struct Voxels;
  std::shared_ptr<const Voxels> voxels_;
};

/// A workpiece: a sparse OpenVDB grid of material ids and, only where a voxel is partly filled, of filled fractions.
///
/// Homogeneous interiors are stored as tiles and need no memory per voxel. Cutting converts tiles into blocks from a
/// pool. `reserve_blocks` fills the pool in advance, so that cutting never allocates. Blocks that become empty return
/// to the pool.
///
/// A workpiece is movable but not copyable: use `clone`. Not thread-safe; a simulation owns its workpiece.
class Workpiece {
 public:
  /// Fills one block: returns its kind and, if the block is mixed, writes all of `content`. It is called from several
  /// threads at the same time, once per block, and must not change shared state.
  using BlockFiller = std::function<BlockKind(const VoxelIndex& block_origin, BlockContent& content)>;

  /// Builds a workpiece block by block.
  /// @param domain  voxels that may be solid; the filler is called for every block that touches the domain, and content
  ///                outside the domain is dropped
  /// @throws Error when the voxel size is not positive, the frame is not a pose, the domain has more than 2^34 voxels
  ///         or reaches beyond +-2^30, a material id is not in the table, or a fill is not within 0 ... 1
  [[nodiscard]] static Workpiece from_blocks(const IndexBox& domain, const GridFrame& frame, MaterialTable materials,
                                             const BlockFiller& fill_block);

  Workpiece(Workpiece&&) noexcept;
  Workpiece& operator=(Workpiece&&) noexcept;
  ~Workpiece();

  [[nodiscard]] Workpiece clone() const;  ///< a deep copy with an empty pool

  // --- properties ---------------------------------------------------------------------------------------------------
  [[nodiscard]] const GridFrame& frame() const;
  [[nodiscard]] double voxel_size() const { return frame().voxel_size; }  ///< [m]
  [[nodiscard]] const MaterialTable& materials() const;
  [[nodiscard]] IndexBox bounds() const;                      ///< smallest box around all voxels that are not empty
  [[nodiscard]] bool empty() const;                           ///< whether no material is left
  [[nodiscard]] std::int64_t solid_voxels() const;            ///< voxels that are not yet empty
  [[nodiscard]] std::size_t memory_bytes() const;             ///< size of the trees, without the pool
  [[nodiscard]] std::size_t pool_bytes() const;               ///< size of the blocks reserved for cutting
  [[nodiscard]] std::vector<MaterialAmount> amounts() const;  ///< one entry per material of the table
  [[nodiscard]] MaterialId material_at(const VoxelIndex& index) const;  ///< kEmpty outside
  [[nodiscard]] double fill_at(const VoxelIndex& index) const;          ///< [1] 0 outside
  [[nodiscard]] CentroidOffset centroid_at(const VoxelIndex& index) const;

  /// The first place on a ray that is in material. The surface is where the fill, trilinear between the centres of the
  /// voxels, is one half, as of `extract_surface`: exact within 0.15 voxels at a plane, half a voxel at a border
  /// between two materials. A layer thinner than half a voxel is not met.
  /// @param origin_W     [m] in W
  /// @param direction_W  in W, of any length
  /// @param max_length   [m] of the ray
  /// @param material     that is looked for, as if there were no other; kEmpty: any
  /// @return nothing when there is no material within the length, when origin or direction are not finite, and when the
  ///         direction is zero
  /// @realtime no allocation, no lock; O(voxels along the ray), of empty blocks one in eight
  [[nodiscard]] std::optional<RayHit> first_hit(const Vec3& origin_W, const Vec3& direction_W,
                                                double max_length = std::numeric_limits<double>::infinity(),
                                                MaterialId material = kEmpty) const noexcept;

  /// Calls `function(view)` for every block that is not empty, in a fixed order; uniform regions are split into blocks.
  void for_each_block(const std::function<void(const BlockView&)>& function) const;

  /// A hash of every voxel's material and fill, bit by bit: equal states have equal hashes.
  [[nodiscard]] std::uint64_t hash() const;

  /// Changes the constants of the materials, but not the material of any voxel.
  /// @throws Error if the number of materials changes
  void set_materials(MaterialTable materials);

  /// Exchanges the constants of the materials between two steps of a loop; `materials` receives the old table.
  /// @return false, without any change, if the number of materials differs
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] bool exchange_materials(MaterialTable& materials) noexcept;

  // --- undo ---------------------------------------------------------------------------------------------------------
  /// The present state, to be restored later.
  [[nodiscard]] WorkpieceSnapshot snapshot() const;

  /// @throws Error when the snapshot is empty, or of a workpiece with another frame or number of materials
  void restore(const WorkpieceSnapshot& snapshot);

  // --- undo without an allocation, for a running loop ----------------------------------------------------------------
  /// Reserves memory for undo, at set-up only: 2.7 kB for each of `blocks` blocks that are cut after a mark, and 4
  /// bytes for every block within the workpiece's bounds. 0: no undo. Deletes all marks, as `restore` does.
  /// @throws Error if the workpiece spans too many blocks or the memory is not available; then nothing has changed
  void reserve_undo(std::size_t blocks);

  [[nodiscard]] std::size_t undo_blocks() const noexcept;  ///< as given to `reserve_undo`

  /// Marks the present state for undo. Beyond 64 marks, or when the memory is full, the oldest mark is deleted.
  /// @return false if no mark was set, because `reserve_undo` was not called
  /// @realtime no allocation, no lock; O(1)
  bool set_mark() noexcept;

  [[nodiscard]] std::size_t marks() const noexcept;       ///< marks that can be undone
  [[nodiscard]] std::size_t redo_marks() const noexcept;  ///< undone marks that `redo_block` can restore

  /// Restores one block to its state at the last mark, and saves its present state for `redo_block`.
  /// @return origin of the block; nothing when all blocks are restored; the mark is then removed
  /// @realtime no allocation, no lock; O(512)
  std::optional<VoxelIndex> undo_block() noexcept;

  /// Redoes one block of the mark that was undone last. Needs no additional memory.
  /// @return origin of the block; nothing when the state before the undo is complete and the mark is set again, or when
  ///         something was cut since the undo
  /// @realtime no allocation, no lock; O(512)
  std::optional<VoxelIndex> redo_block() noexcept;

  // --- cutting: called by the step -----------------------------------------------------------------------------------
  /// Reserves memory for `count` blocks that become partly cut. Set-up only.
  void reserve_blocks(std::size_t count);
  [[nodiscard]] std::size_t reserved_blocks() const;  ///< blocks still in the pool

  /// The block that starts at `origin` (a multiple of 8 along each axis).  @realtime no allocation, no lock; O(1)
  [[nodiscard]] BlockView block(const VoxelIndex& origin) const noexcept;

  /// The block that starts at `origin`, with write access to its fills.  @realtime no allocation, no lock; O(1)
  [[nodiscard]] CuttableBlock cuttable_block(const VoxelIndex& origin) noexcept;

  /// A number that no workpiece has had before whenever blocks get memory or lose it, or material comes back; emptied
  /// voxels and smaller fills leave it as it is. As long as it is the same, pointers of a BlockView stay valid, and a
  /// voxel that was empty is empty.
  [[nodiscard]] std::uint64_t layout() const noexcept;

  /// Saves a block for `undo_block`. Must be called before fills are written into CuttableBlock::fill.
  /// @realtime no allocation, no lock; O(512) once a mark, then O(1)
  void remember(const BlockView& block) noexcept;

  /// Deletes the undone marks. Must be called when something was cut.
  /// @realtime no allocation, no lock; O(1)
  void forget_redo() noexcept;

  /// Whether `writable_fill` would return memory for a block.
  /// @realtime no allocation, no lock
  [[nodiscard]] bool has_reserve_for(const VoxelIndex& origin) const noexcept;

  /// Writable filled fractions of one block, [512]. A block that was uniform or full gets memory from the pool.
  /// @return null when the pool is exhausted; the block must then stay unchanged
  /// @realtime no allocation, no lock; O(512)
  [[nodiscard]] float* writable_fill(const VoxelIndex& origin) noexcept;

  /// Empties voxels of one block and sets their fill to 0. If nothing is left, the block returns to the pool, and
  /// pointers into it become invalid.
  /// @pre `writable_fill` returned memory for this block
  /// @realtime no allocation, no lock; O(512)
  void empty_voxels(const VoxelIndex& origin, const BlockMask& emptied) noexcept;

 private:
  friend struct WorkpieceAccess;  // access to the trees for workpiece/openvdb.hpp and the file formats
  struct State;
  void exchange_block(SavedBlock& other) noexcept;
  void restore_content(const SavedBlock& content) noexcept;
  explicit Workpiece(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
