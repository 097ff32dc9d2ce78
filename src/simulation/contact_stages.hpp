// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hapticut/force/law.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/step.hpp"
#include "hapticut/simulation/worst_case.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/removal.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "kernels/kernels.hpp"

/// @file
/// The stages of a step that see voxels: which blocks the head reaches, what it feels and leaves of each, and what is
/// taken out of the workpiece.
namespace hapticut {

/// What the head meets in one sub-step.
struct Encounter {
  Resultant resultant;
  LawEnergies energies;
  bool blocks_exhausted = false;
  bool force_not_finite = false;
  int level_of_detail = 1;                   // an n-th of the voxels was evaluated
  std::optional<SpreadFriction> friction_T;  // about To, in T; of a head that stands, and of no other

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
  /// [m] How thick the layer is that carries the force: with springs, pressure p = k t^2/2 at depth t has the mean
  /// depth by force 2 (energy/force) = 2 t/3.
  [[nodiscard]] double engaged_layer() const noexcept {
    return resultant.normal_force > 0 ? 3 * energies.elastic_before / resultant.normal_force : 0.0;
  }
  /// A custom law that gave what is not a number gives nothing.
  void drop_what_is_not_finite() noexcept {
    if (is_finite(resultant.wrench_T.force) && is_finite(resultant.wrench_T.torque) && std::isfinite(energies.sum()))
      return;
    resultant.wrench_T = {};
    energies = {};
    force_not_finite = true;
  }
};

/// Where the head is and how it moves, for the stages that see voxels.
struct HeadPlacement {
  Pose X_VT;          ///< of the head in the grid's frame
  HeadMotion motion;  ///< where the contact is evaluated: at the middle of the sub-step, or its end
};

/// The stages and the memory that they need, all of it taken at set-up, for one workpiece and one head. Each hands on
/// what it found: blocks, then what the head met in them, then the voxels that are empty.
class ContactStages {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of their use
 public:
  struct EmptiedBlock {
    BlockView block;
    BlockMask emptied;
  };

  /// Lists as long as a head can make them in voxels of a size.
  struct Room {
    Room(const ToolHead& head, double voxel_size, const SimulationConfig& config);
    [[nodiscard]] WorstCase worst_case(const SimulationConfig& config) const noexcept;
    std::size_t max_voxels, max_blocks;
    double thin_up_to;
    std::vector<VoxelIndex> changed;
    std::vector<CuttableBlock> blocks;
    std::vector<EmptiedBlock> emptied;
  };

  /// Both must outlive it.
  /// @throws Error when a level of detail is asked for and the law has none
  ContactStages(Workpiece& workpiece, const ToolHead& head, const SimulationConfig& config);

  /// Stage `find_blocks`: the blocks that the head may touch; valid until it is called again.
  [[nodiscard]] std::span<const CuttableBlock> find_blocks(const HeadPlacement& at) noexcept;

  /// Stage `press_and_cut`: samples every block, asks the law, sums, and cuts. The fills of partly cut voxels are
  /// already those after the sub-step when it returns; voxels that became empty wait for `remove_emptied`.
  [[nodiscard]] Encounter press_and_cut(std::span<const CuttableBlock> blocks, const HeadPlacement& at,
                                        RemovalRecord& removal) noexcept;

  /// What `press_and_cut` would return, without a change to any block.
  /// @param stiffness_T  of the contact about To, in T; zero where the law has none: see `knows_stiffness`
  [[nodiscard]] Encounter press(std::span<const CuttableBlock> blocks, const HeadPlacement& at,
                                Stiffness* stiffness_T = nullptr) noexcept;

  /// Whether `press` gives a stiffness: FoundationLaw does.
  [[nodiscard]] bool knows_stiffness() const noexcept { return law_->is_foundation(); }

  /// Stage `remove_emptied`: takes voxels that became empty out of the workpiece and lists them. Ends a turn of the
  /// level of detail.
  void remove_emptied(RemovalRecord& removal) noexcept;

  /// Goes on with the lists of another head; `room` has the old ones then. Nothing is listed.
  /// @realtime no allocation, no lock; O(1)
  void exchange_buffers(Room& room) noexcept;

  /// Goes on with other constants.
  void set_materials(const ContactMaterials& materials) noexcept;

  [[nodiscard]] WorstCase worst_case(const SimulationConfig& config) const noexcept;

  /// For a workpiece that was put back to what it once was.
  void start_afresh();

  /// Puts up to `most` blocks, and at least one, back to what they were at the last mark, and lists them as changed.
  /// @return how many
  std::size_t undo(std::size_t most) noexcept;

  /// The same towards what was undone last.  @return whether it is done
  bool redo(std::size_t most) noexcept;

  /// Forgets which blocks have changed, at the beginning of a step.
  void forget_changes() noexcept;
  void list_change(const VoxelIndex& origin) noexcept;

  /// Any block may have changed, for the workpiece is another one.
  void change_all() noexcept;
  [[nodiscard]] const ChangedBlocks& changed() const noexcept { return changed_blocks_; }

  /// Whether some material can be crushed, as the default law does it.
  [[nodiscard]] bool any_crushing() const noexcept { return min_crushing_depth_ < ContactMaterial::kNeverCrushed; }

  /// [m] Height along the spindle's axis, in T, up to which a point of the head is thinner than the voxels.
  [[nodiscard]] double thin_up_to() const noexcept { return thin_up_to_; }

  /// Whether some material's energy depends on the chip: then motions have a tooth_rate.
  [[nodiscard]] bool any_chips() const noexcept { return any_chips_; }

  /// Dry friction of a material.
  void set_friction(MaterialId id, const DryFriction& friction) noexcept;

  /// Scales the cutting ratio of all materials while the spindle is slow: see `standing_share`.
  void set_cutting_share(double share) noexcept;

 private:
  static constexpr std::size_t kPressedAtOnce = 8;  // blocks that share single-precision sums

  [[nodiscard]] Encounter meet(std::span<const CuttableBlock> blocks, const HeadPlacement& at, RemovalRecord* removal,
                               Stiffness* stiffness_T) noexcept;
  [[nodiscard]] kernels::ContactJob job_at(std::span<const CuttableBlock> blocks,
                                           const HeadPlacement& at) const noexcept;
  [[nodiscard]] Encounter encounter_of(const kernels::ContactJob& job, const kernels::ContactSums& sums) const noexcept;
  [[nodiscard]] bool crushes(const Encounter& pressed, const HeadMotion& motion) const noexcept;
  [[nodiscard]] Encounter run_kernels(std::span<const CuttableBlock> blocks, const HeadPlacement& at,
                                      RemovalRecord* removal, Stiffness* stiffness_T) noexcept;
  [[nodiscard]] Encounter ask_law(std::span<const CuttableBlock> blocks, const HeadPlacement& at,
                                  RemovalRecord* removal) noexcept;
  void record(const ByMaterial<double>& removed, RemovalRecord& removal) const noexcept;
  [[nodiscard]] int level_of_detail(std::span<const CuttableBlock> blocks,
                                    const kernels::ContactJob& job) const noexcept;
  [[nodiscard]] bool can_cut(const CuttableBlock& block) const noexcept;
  [[nodiscard]] float* fill_target(const CuttableBlock& block) noexcept;
  [[nodiscard]] bool is_cut(const BlockChange& change) const noexcept;
  void keep_change(const CuttableBlock& block, const BlockChange& change) noexcept;

  Workpiece& workpiece_;
  const ToolHead& head_;
  std::shared_ptr<const ForceLaw> law_;
  Quadrature quadrature_;
  ContactMaterials materials_;
  struct SpinningRatios {
    float cutting, sliding;  // [1] of a material at full spin
  };
  ByMaterial<SpinningRatios> spinning_ratios_ = {};
  void scale_ratios(std::size_t id) noexcept {
    materials_[id].cutting_ratio = float(cutting_share_) * spinning_ratios_[id].cutting;
    materials_[id].sliding_ratio = float(cutting_share_) * spinning_ratios_[id].sliding;
  }
  double cutting_share_ = 1;                                   // [1] of them that holds now
  float damping_ = 0;                                          // [s/m] the most that a material has
  int frictional_ = 0;                                         // how many materials have friction
  bool any_chips_ = false;                                     // the energy of some material depends on the chip
  float min_crushing_depth_ = ContactMaterial::kNeverCrushed;  // [m] of the materials
  double voxel_volume_;                                        // [m^3]
  std::size_t max_voxels_ = 0, max_blocks_ = 0;
  double thin_up_to_ = 0;
  std::size_t voxel_budget_;  // 0: no limit
  unsigned turn_ = 0;         // of the level of detail
  IndexBox bounds_;           // voxels that were ever solid

  std::vector<VoxelIndex> changed_;    // origins, since forget_changes; some more than once
  ChangedBlocks changed_blocks_;       // the same as the user sees it
  std::vector<CuttableBlock> blocks_;  // found by find_blocks
  std::vector<EmptiedBlock> emptied_;  // by press_and_cut, for remove_emptied
  ContactBlock contact_;               // scratch of ask_law
  std::array<kernels::PressTask, kPressedAtOnce> tasks_;
  ContactBlock::Array<float> new_fill_;  // of a block that has no fills of its own yet
};

}  // namespace hapticut
