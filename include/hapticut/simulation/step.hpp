// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "hapticut/core/spatial.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/simulation/energy.hpp"
#include "hapticut/workpiece/removal.hpp"

namespace hapticut {

/// What the hand does in one step.
struct StepInput {
  Pose pose;       ///< X_WH at the end of the step
  Twist velocity;  ///< of Ho, in W
  double dt = 0;   ///< [s]
};

/// What a step has to report, as bits; 0 = nothing. Each says what happened to the output, and the cure.
enum class StepStatus : std::uint32_t {
  ok = 0,

  /// The pose held a number that is not finite, or no rotation. No force, workpiece untouched.
  /// Cure: check the device's matrix; re-orthonormalise it (`orthonormalized`) when it is only inexact.
  pose_rejected = 1U << 0,
  /// The velocity held a number that is not finite, or was above 1e6 m/s or rad/s. No force, workpiece untouched.
  /// Cure: check the velocity estimate.
  velocity_rejected = 1U << 1,
  /// dt was not within SimulationConfig::shortest_dt ... longest_dt. No force, workpiece untouched.
  /// Cure: pass the seconds since the last call; after a pause call with a fresh pose and the nominal period.
  dt_rejected = 1U << 2,
  /// The head moved farther than SimulationConfig::longest_sweep half voxels: a jump, not a motion. No force, workpiece
  /// untouched; the next step starts from this pose. Cure: bring the hand back smoothly, or raise longest_sweep.
  jump_rejected = 1U << 3,

  /// A quarter of the reserved blocks or fewer are left. Output unaffected. Cure: Simulation::reserve_blocks soon.
  blocks_low = 1U << 4,
  /// Some material was felt but not cut, because no reserved block was left. Cure: Simulation::reserve_blocks, outside
  /// the step; raise SimulationConfig::reserved_blocks.
  blocks_exhausted = 1U << 5,
  /// More voxels were emptied than the list holds; they are gone and their volume is counted, but not all are listed.
  /// Cure: raise SimulationConfig::removed_voxel_capacity.
  removed_list_full = 1U << 6,

  /// The spindle ran slower than its set speed, because the cut asked for more than its power limit.
  power_limited = 1U << 8,
  /// The spindle cuts with material deeper than a tenth of the head's radius below the cutting surface: the foundation
  /// is too soft for the feed, and forces come out low. Cure: raise SimulationConfig::reference_stiffness (with a
  /// virtual coupling, where a device must not feel it directly), or feed slower.
  engaged_layer_thick = 1U << 9,
  /// The step was too long for the vibration's frequency, which was left out. Cure: call the step at
  /// SimulationConfig::update_rate, or lower Vibration::frequency.
  vibration_left_out = 1U << 10,
  /// The head touched more voxels than SimulationConfig::voxel_budget: only a part of them was evaluated, in turn with
  /// the others. Cure: larger voxels, a smaller head, or a larger budget.
  detail_reduced = 1U << 11,
  /// The force law gave a force or an energy that is not a finite number. No force from it; what it has cut stays cut.
  /// Cure: check the law of your own.
  force_not_finite = 1U << 12,
};

[[nodiscard]] constexpr StepStatus operator|(StepStatus a, StepStatus b) {
  return StepStatus(std::uint32_t(a) | std::uint32_t(b));
}
constexpr StepStatus& operator|=(StepStatus& a, StepStatus b) { return a = a | b; }

/// Whether any of the given bits is set.
[[nodiscard]] constexpr bool has(StepStatus status, StepStatus bits) {
  return (std::uint32_t(status) & std::uint32_t(bits)) != 0;
}

/// The bits of an input that was not accepted.
inline constexpr StepStatus kRejected =
    StepStatus::pose_rejected | StepStatus::velocity_rejected | StepStatus::dt_rejected | StepStatus::jump_rejected;

/// The material that the head touches, where the last sub-step evaluates it.
struct Contact {
  int voxels = 0;     ///< voxels inside the head that are not empty
  double volume = 0;  ///< [m^3] their filled volume
  double depth = 0;   ///< [m] greatest depth below the cutting surface
  int turns = 1;      ///< n: an n-th of the voxels was evaluated; see SimulationConfig::voxel_budget
};

/// Along which motions a probe shall know the stiffness. Only laws of one's own ask for it, as every motion costs them
/// one more evaluation of the contact.
enum class ProbedMotions { all, translations };

/// What a step would feel, without taking it.
struct ContactProbe {
  Wrench wrench;                            ///< about Ho, in W, on the tool; without effects and limits
  Stiffness stiffness = Stiffness::Zero();  ///< about Ho, in W; positive semidefinite
  Contact contact;
  bool sliding = false;  ///< dry friction drags its anchor along: see StickSlip
};

/// The spindle during the step.
struct SpindleState {
  double speed = 0;   ///< [rad/s] signed about +z of T
  double torque = 0;  ///< [N·m] that the motor delivers, positive when it drives the spin
};

/// The blocks that a step has changed, for pictures and copies of the workpiece.
struct ChangedBlocks {
  std::span<const VoxelIndex> origins;  ///< first voxels, some more than once; valid until the next step
  bool complete = true;                 ///< false: more than could be listed, so any block may have changed
};

/// What one step returns.
struct StepResult {
  Vec3 force = Vec3::Zero();                     ///< [N] on the tool, what the hand feels, in W
  Vec3 torque = Vec3::Zero();                    ///< [N·m] on the tool about Ho, in W
  std::span<const RemovedVoxel> removed_voxels;  ///< emptied by this call; valid until the next one
  double removed_volume = 0;                     ///< [m^3] taken away by this call, partly emptied voxels included
  Contact contact;                               ///< what the head touches
  Wrench model;  ///< about Ho, in W: what the contact gives, before coupling, effects and limits; mean over the step
  EnergyLedger energy;                 ///< accumulated since construction
  SpindleState spindle;                ///< speed and torque of this step
  int sub_steps = 0;                   ///< 0 when the input was rejected
  StepStatus status = StepStatus::ok;  ///< bits; ok = nothing to report
};

}  // namespace hapticut
