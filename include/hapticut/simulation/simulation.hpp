// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/exchange.hpp"
#include "hapticut/simulation/history.hpp"
#include "hapticut/simulation/observer.hpp"
#include "hapticut/simulation/spindle_drive.hpp"
#include "hapticut/simulation/stage_times.hpp"
#include "hapticut/simulation/step.hpp"
#include "hapticut/simulation/totals.hpp"
#include "hapticut/simulation/worst_case.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/material_set.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// The bits with which `Simulation::step` would reject an input; ok when it would not. Jumps are not checked.
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] StepStatus check_input(const SimulationConfig& config, const Pose& X_WH, const Twist& V_WH,
                                     double dt) noexcept;

/// A tool that a hand moves through a workpiece. Its `step` is the 1 kHz call of the haptic loop.
///
/// Not thread-safe: one thread calls `step`, and everything else is called between steps.
class Simulation {
 public:
  /// Takes ownership of the workpiece and reserves all memory that cutting will need.
  /// @throws Error when the configuration is invalid, the workpiece is empty, or the head is thinner than a voxel or
  ///         spans more than 1e9 of them
  Simulation(Workpiece workpiece, Tool tool, SimulationConfig config = {});

  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  // --- the step -----------------------------------------------------------------------------------------------------
  /// Moves the tool to a pose, removes what the spindle cuts on the way, and returns the force and torque on the hand.
  /// For a device in your own loop construct the simulation with SimulationConfig::for_device, or use a
  /// VirtualCoupling: the plain defaults suit scripts, whose path no force deflects.
  ///
  /// The head moves from its pose at the end of the last step to `X_WH` with constant velocity. In the first step it
  /// comes from `X_WH - V_WH dt`.
  ///
  /// @param X_WH      pose of the handle in W, at the end of the step
  /// @param V_WH      velocity [m/s] of Ho and angular velocity [rad/s], in W, as the device estimates it. It drives
  /// the damping only; cutting and energies follow the poses
  /// @param dt        [s] since the last call
  /// @param coupling  maps the tool's wrench to the hand's when a coupling, such as VirtualCoupling, moves the tool;
  /// null when the hand holds it
  /// @return a reference that stays valid; its contents are those of the last call
  /// @realtime no allocation, no lock, no exception, no printing; same input, same bits. O(voxels inside the head)
  const StepResult& step(const Pose& X_WH, const Twist& V_WH, double dt, HandCoupling* coupling = nullptr) noexcept;

  /// For couplings: the hand has released the tool. The output is zero, and the start-up ramp begins again with the
  /// next step.
  /// @realtime no allocation, no lock
  void release_hand() noexcept;

  // --- questions, which change nothing ------------------------------------------------------------------------------
  /// The force that a step to `X_WH` would give, and the stiffness of the contact there; changes nothing. When the step
  /// would be split into sub-steps, each is probed on the material as it is now, and the motor keeps its speed. For
  /// implicit integrators such as `VirtualCoupling` (simulation/coupling.hpp).
  ///
  /// The default law knows its stiffness. The stiffness of a custom law is measured by small motions, so a probe
  /// evaluates the contact 7 times, 4 times for translations, or once for none. An input that `step` would reject gives
  /// no force and no stiffness.
  /// @param motions  for which the stiffness is needed; its other parts may be zero
  /// @realtime as `step`
  [[nodiscard]] ContactProbe probe(const Pose& X_WH, const Twist& V_WH, double dt,
                                   ProbedMotions motions = ProbedMotions::all) const noexcept;

  /// Whether the head would touch material with the handle at a pose; false when the pose is not a rigid transform.
  /// @realtime no allocation, no lock; evaluates the contact once
  [[nodiscard]] bool touches(const Pose& X_WH) const noexcept;

  /// Whether the head would be in material, deeper than a tool that rests on a surface: a fifth of a voxel; false when
  /// the pose is not a rigid transform.
  /// @realtime no allocation, no lock; evaluates the contact once
  [[nodiscard]] bool is_in_material(const Pose& X_WH) const noexcept;

  /// [m] The distance between the head, with the handle at a pose, and what is left of a material: 0 where the head is
  /// in it, infinity when nothing of it is left within `max_distance`, NaN when the pose is not a rigid transform.
  ///
  /// Other materials in between do not matter. The head's surface is exact. The surface of the material is that of the
  /// contact of the default law: within 0.2 voxels at a surface against empty space. At a border between two materials
  /// each voxel has one of them, so there the distance is up to 0.75 voxels too small or 0.4 too large.
  /// @param material      kEmpty: of any material
  /// @param max_distance  [m] >= 0; the smaller, the faster is the search
  /// @realtime no allocation, no lock; O(blocks within the distance), see docs/other-scenes.md
  [[nodiscard]] double distance_to(MaterialId material, const Pose& X_WH,
                                   double max_distance = std::numeric_limits<double>::infinity()) const noexcept;

  /// Whether the next step will be the first of the tool: before the first one, and after a way back in the
  /// `history`, `set` of a tool or of materials, `exchange` and `reset`. After these calls, the material that the tool
  /// is in is neither felt nor cut: steps are rejected with StepStatus::tool_waits until the head touches nothing.
  /// Exceptions are the very first step, and `reset` when no coupling holds the tool.
  [[nodiscard]] bool next_step_is_first() const noexcept;

  /// Whether the simulation is as new: since construction or `reset` it has made no step and received no workpiece that
  /// a tool was in, and no `undo`, `redo` or `remove_voxels` has changed its workpiece. A recording begins with such a
  /// simulation. What was `set` does not matter.
  [[nodiscard]] bool is_fresh() const noexcept;

  /// Upper bound on the work of a step.
  [[nodiscard]] WorstCase worst_case() const;

  // --- state and results --------------------------------------------------------------------------------------------
  [[nodiscard]] const Workpiece& workpiece() const;
  [[nodiscard]] const Tool& tool() const;

  /// The configuration as given, with the values that were left to the simulation filled in (`complete`).
  [[nodiscard]] const SimulationConfig& config() const;
  [[nodiscard]] const StepResult& last_result() const;

  /// Blocks that the last step, undo or redo has changed, and removals since. Not complete after an exchange of the
  /// workpiece, until the next step.  @realtime no allocation, no lock; O(1)
  [[nodiscard]] ChangedBlocks changed_blocks() const noexcept;

  /// The last input of `step`, also when a loop or a coupling called it; dt = 0 before the first step.
  [[nodiscard]] const StepInput& last_input() const noexcept;

  /// Number of calls of `step` since construction or `reset`.
  [[nodiscard]] std::uint64_t steps() const noexcept;

  /// Box around all voxels that were not empty when the present workpiece was put in place. Unlike
  /// `Workpiece::bounds`, it does not shrink as material is cut.  @realtime no allocation, no lock; O(1)
  [[nodiscard]] IndexBox first_bounds() const noexcept;

  /// The materials that the last step touched for the first time since construction or `reset`: an event, for example
  /// of the pulp of a tooth.  @realtime no allocation, no lock; O(1)
  [[nodiscard]] const MaterialSet& first_touched() const noexcept;

  /// By MaterialId [N], the sum of the magnitudes of a material's normal forces on the head, in the last sub-step of
  /// the last step: their shares tell which layers are being cut. Zero while the head cuts nothing.
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] const ByMaterial<double>& normal_forces() const noexcept;

  /// Sums since construction or `reset`; valid until the next `reset` or `exchange` of a simulation.
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] SimulationTotals totals() const noexcept;

  /// Times of the stages of the last step; see SimulationConfig::stage_times.
  [[nodiscard]] const StageTimes& stage_times() const;

  /// The observers. They stay with this simulation when its workpiece is exchanged.
  [[nodiscard]] StepObservers& observers() noexcept;
  [[nodiscard]] const StepObservers& observers() const noexcept;

  // --- changes, between steps ---------------------------------------------------------------------------------------
  /// The spindle of the tool: its speed setting, a halt and a hold. Valid until `reset` or `exchange` of a simulation.
  [[nodiscard]] SpindleDrive& spindle() noexcept;
  [[nodiscard]] const SpindleDrive& spindle() const noexcept;

  /// The earlier states of the workpiece: restore, undo and redo.
  [[nodiscard]] WorkpieceHistory history() noexcept { return WorkpieceHistory(*this); }

  /// Exchanges the tool. The workpiece with its cuts, undo marks, removed volumes and energies stay. The next
  /// step is the first of the new tool (`next_step_is_first`), with the speed of its own spindle.
  /// @throws Error when the head does not suit the voxels or the law; then nothing has changed
  void set(Tool tool);

  /// Exchanges the constants of the materials. Cuts, undo marks, removed volumes and energies stay. The next step
  /// is the first of the tool (`next_step_is_first`).
  /// @throws Error when the number of materials differs, or a stiffness is out of range; then nothing has changed
  void set(MaterialTable materials);

  /// Sets SimulationConfig::friction for the following steps; empty: each material's own friction.
  /// @throws Error naming the constant, its value and the allowed range; then nothing has changed
  void set(const std::optional<DryFriction>& friction);

  /// Sets SimulationConfig::removal for the following steps. With `none` nothing is cut, whatever the spindle does.
  void set(RemovalLaw removal) noexcept;

  /// Sets the effects and limits of the output for the following steps.
  /// @throws Error naming the field, its value and the allowed range; then nothing has changed
  void set(const Effects& effects);

  /// Fills the pool of the workpiece up to `count` blocks.
  void reserve_blocks(std::size_t count);

  /// Removes voxels of one block without cutting them, between two steps. Their volume is counted in
  /// SimulationTotals::detached_volume, not as removed volume. Elastic energy that was stored in them is
  /// EnergyLedger::entered of the next step. Undo restores them.
  /// @return false, with nothing changed, when no reserved block is left for it
  /// @realtime no allocation, no lock; O(512)
  bool remove_voxels(const BlockVoxels& voxels) noexcept;

  /// Starts again with another workpiece. Tool pose, energies, removed volumes and undo marks are reset. As much memory
  /// for undo is reserved as before.
  /// @throws Error when the workpiece is empty, or the head thinner than a voxel; then nothing has changed
  void reset(Workpiece workpiece);

  // --- exchanges while a loop runs ----------------------------------------------------------------------------------
  /// `set` of a tool without an allocation. `prepared` receives the old tool.
  /// @return false, with nothing changed, when it was made for another voxel size
  /// @realtime no allocation, no lock; O(materials)
  [[nodiscard]] bool exchange(PreparedTool& prepared) noexcept;

  /// `set` of materials without an allocation. `prepared` receives the old materials.
  /// @return false, with nothing changed, when the number of materials differs
  /// @realtime no allocation, no lock; O(materials)
  [[nodiscard]] bool exchange(PreparedMaterials& prepared) noexcept;

  /// Swaps in workpiece and tool of another simulation, which receives the old ones. Energies, removed volumes and undo
  /// marks are those of the other simulation. Effects, friction and removal stay as they are set here. The observers of
  /// both simulations stay with theirs, and are told of the exchange.
  /// @realtime no allocation, no lock; O(1)
  void exchange(Simulation& prepared) noexcept;

 private:
  friend class WorkpieceHistory;
  friend struct SimulationMemory;
  struct State;
  explicit Simulation(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
