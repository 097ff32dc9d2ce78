// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
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
  int level_of_detail = 1;  // an n-th of the voxels was evaluated

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
  }
  /// A law of one's own that gave what is no number gives nothing.
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

/// The stages and the memory that they need, all of it taken at set-up.
class ContactStages {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of their use
 public:
  struct EmptiedBlock {
    BlockView block;
    std::array<std::uint64_t, 8> emptied;
  };

  /// Lists as long as a head can make them in voxels of a size.
  struct Room {
    Room(const ToolHead& head, double voxel_size, const SimulationConfig& config);
    [[nodiscard]] WorstCase worst_case(const SimulationConfig& config) const noexcept;
    std::size_t most_voxels, most_blocks;
    std::vector<VoxelIndex> changed;
    std::vector<BlockView> blocks;
    std::vector<EmptiedBlock> emptied;
  };

  /// @throws Error when a stiffness is out of the range that single precision bears
  [[nodiscard]] static ContactMaterials constants_of(const MaterialTable& table, double reference_stiffness);

  /// @throws Error when a level of detail is asked for and the law has none
  ContactStages(const Workpiece& workpiece, const ToolHead& head, const SimulationConfig& config);

  /// Stage `find_blocks`: the blocks that the head may touch.
  void find_blocks(const Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at) noexcept;

  /// Stage `evaluate_contact`: samples every block found, asks the law, and sums. The fills of partly cut voxels are
  /// already those after the sub-step when it returns; voxels that became empty wait for `remove_material`.
  [[nodiscard]] Encounter evaluate_contact(Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at,
                                           RemovalRecord& removal) noexcept;

  /// What `evaluate_contact` would return for the blocks found, without a change to anything.
  /// @param stiffness_T  of the contact about To, in T; zero where the law has none: see `knows_stiffness`
  [[nodiscard]] Encounter probe_contact(const Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at,
                                        Stiffness& stiffness_T) noexcept;

  /// Whether `probe_contact` gives a stiffness: FoundationLaw does.
  [[nodiscard]] bool knows_stiffness() const noexcept { return law_ == nullptr; }

  /// Stage `remove_material`: takes voxels that became empty out of the workpiece and lists them. Ends a turn of the
  /// level of detail.
  void remove_material(Workpiece& workpiece, RemovalRecord& removal) noexcept;

  /// Goes on with the lists of another head; `room` has the old ones then. Nothing is listed.
  /// @realtime no allocation, no lock; O(1)
  void exchange_room(Room& room) noexcept;

  /// Goes on with other constants; `materials` are the old ones then.
  /// @realtime no allocation, no lock; O(1)
  void exchange_materials(ContactMaterials& materials) noexcept;

  [[nodiscard]] WorstCase worst_case(const SimulationConfig& config) const noexcept;

  /// For a workpiece that was put back to what it once was.
  void start_afresh(const Workpiece& workpiece);

  /// Puts up to `most` blocks, and at least one, back to what they were at the last mark, and lists them as changed.
  /// @return how many
  std::size_t undo(Workpiece& workpiece, std::size_t most) noexcept;

  /// The same towards what was undone last.  @return whether it is done
  bool redo(Workpiece& workpiece, std::size_t most) noexcept;

  /// Forgets which blocks have changed, at the beginning of a step.
  void forget_changes() noexcept;
  [[nodiscard]] const ChangedBlocks& changed() const noexcept { return changed_blocks_; }

  /// Scales the cutting ratio of all materials while the spindle is slow: see `standing_share`.
  void set_cutting_share(double share) noexcept;

 private:
  static constexpr std::size_t kPressedAtOnce = 8;  // blocks that share single-precision sums

  [[nodiscard]] kernels::ContactJob job_at(const Workpiece& workpiece, const ToolHead& head,
                                           const HeadPlacement& at) const noexcept;
  void take_sums(const kernels::ContactJob& job, const kernels::ContactSums& sums, Encounter& encounter) const noexcept;
  void press_blocks(Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at, RemovalRecord& removal,
                    Encounter& encounter) noexcept;
  template <class Leave>
  void feel_law(const Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at, Encounter& encounter,
                const Leave& leave) noexcept;
  void ask_law(Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at, RemovalRecord& removal,
               Encounter& encounter) noexcept;
  [[nodiscard]] int level_of_detail() const noexcept;
  [[nodiscard]] static bool can_cut(const BlockView& block, const Workpiece& workpiece) noexcept;
  [[nodiscard]] float* fill_target(const BlockView& block) noexcept;
  void keep_change(const kernels::PressTask& task, Workpiece& workpiece) noexcept;
  void list_change(const VoxelIndex& origin) noexcept;

  std::shared_ptr<const ForceLaw> law_;  // null: FoundationLaw
  Quadrature quadrature_;
  ContactMaterials materials_;
  std::array<float, 256> cutting_ratios_ = {};  // [1] of the materials at full spin
  double cutting_share_ = 1;                    // [1] of them that holds now
  bool damped_ = false;                         // some material has damping
  double voxel_volume_;                         // [m^3]
  std::size_t most_voxels_ = 0, most_blocks_ = 0;
  std::size_t voxel_budget_;  // 0: no limit
  unsigned turn_ = 0;         // of the level of detail
  IndexBox bounds_;           // voxels that were ever solid

  std::vector<VoxelIndex> changed_;    // origins, since forget_changes; some more than once
  ChangedBlocks changed_blocks_;       // the same as the user sees it
  std::vector<BlockView> blocks_;      // found by find_blocks
  std::vector<EmptiedBlock> emptied_;  // by evaluate_contact, for remove_material
  ContactBlock contact_;               // scratch of ask_law
  std::array<kernels::PressTask, kPressedAtOnce> tasks_;
  ContactBlock::Array<float> new_fill_;  // of a block that has no fills of its own yet
};

}  // namespace hapticut
