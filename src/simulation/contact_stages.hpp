// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hapticut/contact/removal.hpp"
#include "hapticut/force/grain.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/limit_surface.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/step.hpp"
#include "hapticut/simulation/worst_case.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/material_set.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "kernels/kernels.hpp"
#include "simulation/near_blocks.hpp"
#include "simulation/step_materials.hpp"

/// The stages of a step that see voxels: finding the blocks that the head reaches, computing force and new fills of
/// each, and removing voxels from the workpiece.
namespace hapticut {

/// The contact of the head in one sub-step.
struct Encounter {
  Resultant resultant;
  LawEnergies energies;
  bool blocks_exhausted = false;
  bool force_not_finite = false;
  int level_of_detail = 1;    // one n-th of the voxels was evaluated
  SpreadFriction friction_T;  // about To, in T; of a standing head, else empty

  /// Of the contact about To, in T, if it was asked for and the law knows it (`ContactStages::knows_stiffness`); else
  /// zero.
  Stiffness stiffness_T = Stiffness::Zero();

  LimitSurface::Reaction dry_friction;  // about To, in W
  double stall_work = 0;                // [J] that the motor of a stalled head takes up

  void add(const LawTotals& block) {
    energies += block.energies;
    resultant.wrench_T.torque.z() += block.spin_couple;
  }
  void add(const LumpedForce& lumped) {
    resultant.wrench_T.force += lumped.wrench_T.force;
    resultant.wrench_T.torque += lumped.wrench_T.torque;
    energies.elastic_before += lumped.elastic_before;
    energies.elastic += lumped.elastic;
    energies.damping += lumped.damped;
    if (const double size = lumped.wrench_T.force.norm(); size > 0) {  // at the nearest point of its line of action
      resultant.normal_force += size;
      resultant.push_T += lumped.wrench_T.force;
      resultant.moment_T += lumped.wrench_T.force.cross(lumped.wrench_T.torque) / size;
    }
  }
  /// [m] Thickness of the layer that carries the force. Springs with the pressure p = k t^2/2 at depth t have the
  /// force-weighted mean depth 2 (energy/force) = 2 t/3.
  [[nodiscard]] double engaged_layer() const noexcept {
    return resultant.normal_force > 0 ? 3 * energies.elastic_before / resultant.normal_force : 0.0;
  }
  /// Drops force and energies of a law that returned NaN or infinity.
  void drop_if_not_finite() noexcept {
    if (is_finite(resultant.wrench_T.force) && is_finite(resultant.wrench_T.torque) && std::isfinite(energies.sum()))
      return;
    resultant.wrench_T = {};
    energies = {};
    force_not_finite = true;
  }
};

/// Where the head is and how it moves, for the stages that see voxels.
struct HeadPlacement {
  Pose X_VT;          ///< pose of the head in the grid's frame
  HeadMotion motion;  ///< where the contact is evaluated: at the middle of the sub-step, or its end

  /// [1] Share of the cutting ratio that acts: less than 1 for slow and stalled heads.
  double cutting_share = 1;

  /// The head at this place if it did not spin.
  [[nodiscard]] HeadPlacement standing() const noexcept {
    HeadPlacement at = *this;
    at.motion.spin = 0;
    at.motion.removal = RemovalLaw::none;
    at.motion.crushes = false;
    return at;
  }
};

/// The stages, for one workpiece and one head, with all their memory, which is allocated at set-up. Each stage hands on
/// its result: the blocks, then the contact in them, then the voxels that became empty.
class ContactStages {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of their use
 public:
  struct EmptiedBlock {
    BlockView block;
    BlockMask emptied;
  };

  /// Lists with memory for a head at its largest contact, for a voxel size.
  struct Buffers {
    Buffers(const ToolHead& head, double voxel_size, const SimulationConfig& config);
    [[nodiscard]] WorstCase worst_case(const SimulationConfig& config) const noexcept;
    std::size_t max_voxels, max_blocks;
    NearBlocks near;
    double thin_up_to;
    std::vector<VoxelIndex> changed;
    std::vector<EmptiedBlock> emptied;
  };

  /// The workpiece and the head must outlive it.
  /// @throws Error when the quadrature or a voxel_budget does not suit the law, or a stiffness is out of range
  ContactStages(Workpiece& workpiece, const ToolHead& head, const SimulationConfig& config);

  /// Stage `find_blocks`: the blocks that the head may touch; valid until it is called again.
  [[nodiscard]] std::span<const FoundBlock> find_blocks(const HeadPlacement& at) noexcept;

  /// Stage `press_and_cut`: samples every block, evaluates the law, sums, and cuts. When it returns, the fills of
  /// partly cut voxels are already those after the sub-step; voxels that became empty wait for `remove_emptied`.
  [[nodiscard]] Encounter press_and_cut(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                        RemovalRecord& removal) noexcept;

  /// The materials in contact with the head, except those that are known. Free of cost when all are known; else O(512)
  /// for each block that contains several materials or empty voxels.
  [[nodiscard]] MaterialSet find_touched(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                         const MaterialSet& known) noexcept;

  /// What `probe` is asked for.
  enum class Asked { force, stiffness };

  /// Returns what `press_and_cut` would return, without a change to any block.
  [[nodiscard]] Encounter probe(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                Asked asked = Asked::force) noexcept;

  /// Presses the head as if it did not spin, on what is left at this place.
  [[nodiscard]] Encounter standing_contact(const HeadPlacement& at) noexcept {
    const HeadPlacement standing = at.standing();
    return probe(find_blocks(standing), standing);
  }

  /// Whether `probe` gives a stiffness: FoundationLaw does.
  [[nodiscard]] bool knows_stiffness() const noexcept { return law_->is_foundation(); }

  /// Stage `remove_emptied`: removes voxels that became empty from the workpiece and lists them. Goes on to the
  /// next subset of the level of detail.
  void remove_emptied(RemovalRecord& removal) noexcept;

  /// Swaps in buffers for another head; `buffers` receives the old ones. Clears the lists.
  /// @realtime no allocation, no lock; O(1)
  void exchange_buffers(Buffers& buffers) noexcept;

  /// Sets the constants of the materials.
  void set_materials(const ContactMaterials& materials) noexcept {
    materials_.set(materials, law_->is_foundation());
    if (grain_seed_) grain_.set(materials, workpiece_.frame(), *grain_seed_);
  }
  void set_friction(MaterialId id, const DryFriction& friction) noexcept { materials_.set_friction(id, friction); }
  [[nodiscard]] const StepMaterials& materials() const noexcept { return materials_; }
  [[nodiscard]] const Grain* grain() const noexcept { return grain_.any() ? &grain_ : nullptr; }  ///< null: none

  [[nodiscard]] WorstCase worst_case(const SimulationConfig& config) const noexcept;

  /// To be called when the workpiece was restored to an earlier state.
  void restart();

  /// Restores up to `max_blocks` blocks, and at least one, to the last mark, and lists them as changed.
  /// @return number of restored blocks
  std::size_t undo(std::size_t max_blocks) noexcept;

  /// Redoes up to `max_blocks` blocks, and at least one, of the last undo.  @return whether it is done
  bool redo(std::size_t max_blocks) noexcept;

  /// Clears the list of changed blocks, at the beginning of a step.
  void forget_changes() noexcept;
  void list_change(const VoxelIndex& origin) noexcept;

  /// Marks all blocks as changed, after an exchange of the workpiece.
  void change_all() noexcept;
  [[nodiscard]] const ChangedBlocks& changed() const noexcept { return changed_blocks_; }

  /// The voxels that were ever solid.
  [[nodiscard]] const IndexBox& bounds() const noexcept { return bounds_; }

  /// [m] Smallest depth at which a standing rim crushes in a sub-step; 0 where nothing is that deep, the head turns or
  /// is a ball, or a point bears the force that is thinner than the voxels, which do not resolve what it crushes.
  [[nodiscard]] double rim_crushing_depth(const Resultant& resultant, const HeadMotion& motion) const noexcept;

  /// The contact: its size, and its point, normal and pressure by the normal forces alone.
  [[nodiscard]] Contact contact_of(const Encounter& encounter, const Pose& X_WT) const noexcept;
  /// [N] Sum of the normal forces of each material on a head that cuts, in the last `press_and_cut`.
  [[nodiscard]] const ByMaterial<double>& pressed() const noexcept { return pressed_; }
  [[nodiscard]] double voxel_volume() const noexcept { return voxel_volume_; }  ///< [m^3]

  /// Whether a point of the head that is thinner than the voxels bears the normal forces.
  [[nodiscard]] bool is_point_thin(const Resultant& resultant) const noexcept {
    return resultant.normal_force > 0 && resultant.moment_T.z() < thin_up_to_ * resultant.normal_force;
  }

 private:
  friend struct SimulationMemory;
  static constexpr std::size_t kBlocksAtOnce = 32;  // blocks that share columns

  void sample_reached(const kernels::ContactJob& job, const BlockView& block) noexcept;
  [[nodiscard]] Encounter evaluate(std::span<const FoundBlock> blocks, const HeadPlacement& at, RemovalRecord* removal,
                                   Asked asked) noexcept;
  [[nodiscard]] kernels::ContactJob job_at(const HeadPlacement& at) noexcept;
  [[nodiscard]] Encounter encounter_of(const kernels::ContactJob& job, const kernels::ContactSums& sums) const noexcept;
  [[nodiscard]] bool crushes(const Encounter& encounter, const HeadMotion& motion) const noexcept;
  [[nodiscard]] double crushing_depth(const HeadMotion& motion, double scale = 1) const noexcept;
  [[nodiscard]] Encounter run_kernels(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                      RemovalRecord* removal, Asked asked) noexcept;
  [[nodiscard]] Encounter ask_law(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                  RemovalRecord* removal) noexcept;
  void record(const ByMaterial<double>& removed, RemovalRecord& removal) const noexcept;
  [[nodiscard]] int level_of_detail(std::span<const FoundBlock> blocks, const kernels::ContactJob& job) const noexcept;
  [[nodiscard]] bool can_cut(const CuttableBlock& block) const noexcept;
  [[nodiscard]] float* fill_target(const CuttableBlock& block, std::size_t place) noexcept;
  void keep_change(const CuttableBlock& block, const BlockChange& change, const float* after) noexcept;

  Workpiece& workpiece_;
  const ToolHead& head_;
  std::shared_ptr<const ForceLaw> law_;
  Quadrature quadrature_;
  StepMaterials materials_;
  std::optional<std::uint32_t> grain_seed_;  // none: no grain
  Grain grain_;
  double voxel_volume_;  // [m^3]
  std::size_t max_voxels_ = 0, max_blocks_ = 0;
  double thin_up_to_ = 0;     // [m] height along the spindle's axis, in T
  std::size_t voxel_budget_;  // 0: no limit
  ByMaterial<double> pressed_ = {};
  unsigned subset_ = 0;  // of strips, the one that this step evaluates with a level of detail
  IndexBox bounds_;      // voxels that were ever solid

  std::vector<VoxelIndex> changed_;    // origins, since forget_changes; some more than once
  ChangedBlocks changed_blocks_;       // as the user sees it
  NearBlocks near_;                    // for find_blocks
  std::vector<EmptiedBlock> emptied_;  // by press_and_cut, for remove_emptied
  ContactBlock contact_;               // scratch of ask_law and find_touched
  std::array<kernels::BlockTask, kBlocksAtOnce> tasks_;
  std::array<ContactBlock::Array<float>, kBlocksAtOnce> new_fills_;  // fills of blocks that are not written in place
};

}  // namespace hapticut
