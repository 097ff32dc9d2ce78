// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/exchange.hpp"
#include "hapticut/simulation/observer.hpp"
#include "hapticut/simulation/stage_times.hpp"
#include "hapticut/simulation/step.hpp"
#include "hapticut/simulation/worst_case.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// Why `Simulation::step` would reject an input; ok when it would not, unless it is a jump.
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] StepStatus check_input(const SimulationConfig& config, const Pose& X_WH, const Twist& V_WH,
                                     double dt) noexcept;

/// A tool that a hand moves through a workpiece: the 1 kHz call and what it works on.
///
/// Not thread-safe: one thread calls `step`; everything else is called between steps.
class Simulation {
 public:
  /// Takes the workpiece over and reserves all memory that cutting will need.
  /// @throws Error when the configuration is invalid, the workpiece is empty, or the head is thinner than a voxel or
  ///         spans more than 1e9 of them
  Simulation(Workpiece workpiece, Tool tool, SimulationConfig config = {});

  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Moves the tool to a pose, returns the force and torque on the hand, and takes away what the spindle cuts on the
  /// way.
  ///
  /// The head moves from where it was at the end of the last step to `X_WH` with constant velocity; in the first step
  /// it comes from `X_WH - V_WH dt`.
  ///
  /// @param X_WH      pose of the handle in W, at the end of the step
  /// @param V_WH      velocity [m/s] of Ho and angular velocity [rad/s], in W, as the device estimates it; it drives
  /// the damping only;
  ///                  cutting and energies follow the poses
  /// @param dt        [s] since the last call
  /// @return a reference that stays valid; its contents are those of the last call
  /// @param coupling  what stands between the tool and the hand, for a pose that is not the hand's own; null: nothing,
  ///                  the hand holds the tool. VirtualCoupling is one.
  /// @realtime no allocation, no lock, no exception, no printing; same input, same bits. O(voxels inside the head)
  const StepResult& step(const Pose& X_WH, const Twist& V_WH, double dt, HandCoupling* coupling = nullptr) noexcept;

  /// For couplings: the hand has let go. It is given nothing, and the start-up ramp begins again with the next step.
  /// @realtime no allocation, no lock
  void release_hand() noexcept;

  /// What a step to `X_WH` would feel, and how stiff the contact would be there; changes nothing. Where the step would
  /// be cut into sub-steps, each is probed on the material as it is now. For implicit integrators: `VirtualCoupling`
  /// (simulation/coupling.hpp) is one.
  ///
  /// The default law knows its stiffness. That of a custom law is measured by small motions, so a probe evaluates
  /// the contact 7 times, or 4 times for translations. An input that `step` would reject gives no force and no
  /// stiffness.
  /// @param motions  the rest of the stiffness may be zero
  /// @realtime as `step`
  [[nodiscard]] ContactProbe probe(const Pose& X_WH, const Twist& V_WH, double dt,
                                   ProbedMotions motions = ProbedMotions::all) const noexcept;

  /// Whether the head would be in material with the handle at a pose; false where the pose is none.
  /// @realtime no allocation, no lock; evaluates the contact once
  [[nodiscard]] bool touches(const Pose& X_WH) const noexcept;

  /// Whether the next step will be the first of the tool: before the first one, and after `restore`, `undo`, `redo`,
  /// `set_tool`, `set_materials`, `exchange` and `reset`. But for the first and, without a coupling that holds it, for
  /// `reset`, the material that the tool is in now is neither felt nor cut: steps are refused with
  /// StepStatus::tool_waits until the head touches nothing.
  [[nodiscard]] bool starts_afresh() const noexcept;

  [[nodiscard]] const Workpiece& workpiece() const;
  [[nodiscard]] const Tool& tool() const;

  /// As given, with what was left to the simulation (`complete`).
  [[nodiscard]] const SimulationConfig& config() const;
  [[nodiscard]] const StepResult& last_result() const;

  /// What the last step, undo or redo has changed, and removals since; not complete after another workpiece was put in
  /// place, until the next step.  @realtime no allocation, no lock; O(1)
  [[nodiscard]] ChangedBlocks changed_blocks() const noexcept;

  /// [rad/s] that was asked of the spindle last. Its speed is StepResult::spindle: while it ramps, is loaded or is held
  /// another one.
  [[nodiscard]] AngularSpeed spindle_setting() const noexcept;

  /// What `step` was last called with, also by a loop or a coupling: dt = 0 before the first time.
  [[nodiscard]] const StepInput& last_input() const noexcept;

  /// Calls of `step` since construction or `reset`.
  [[nodiscard]] std::uint64_t steps() const noexcept;

  /// How often something else than a step has changed what steps meet: `restore`, `reset`, `undo`, `redo`, `set_tool`,
  /// `set_materials`, `set_friction`, `set_removal` and the exchanges of a loop. The observers are told of each.
  [[nodiscard]] std::uint64_t workpiece_exchanges() const noexcept;

  static constexpr std::size_t kMaxObservers = 8;

  /// Adds an observer, which is told of every step from now on, after those that are there already. It must live until
  /// it is removed. Observers stay with this simulation when its workpiece is exchanged.
  /// @throws Error when it is one already, or there are kMaxObservers
  void add_observer(StepObserver& observer);

  void remove_observer(StepObserver& observer) noexcept;  ///< nothing happens when it is none
  [[nodiscard]] std::span<StepObserver* const> observers() const noexcept;

  /// [m^3] taken away since construction or reset, by MaterialId.
  [[nodiscard]] const ByMaterial<double>& removed_volume_by_material() const;

  /// What a step may have to do at most.
  [[nodiscard]] WorstCase worst_case() const;

  /// Of the last step; see SimulationConfig::stage_times.
  [[nodiscard]] const StageTimes& stage_times() const;

  // --- set-up calls, between steps ----------------------------------------------------------------------------------
  /// Sets the spindle's speed for the following steps; with Spindle::acceleration_limit it is reached on a ramp.
  /// @throws Error when it is faster than kMaxSpindleSpeed or not finite
  void set_spindle_speed(AngularSpeed speed);

  /// The spindle stands from now on, whatever its ramp.  @realtime no allocation, no lock; O(1)
  void halt_spindle() noexcept;

  /// Holds the spindle, so that it stands whatever is asked of it, or lets it turn as it is asked to. While it is held,
  /// nothing is crushed either: the guard of a loop holds it while the hand feels nothing (SpindleInterlock).
  /// @realtime no allocation, no lock; O(1)
  void hold_spindle(bool hold) noexcept;
  [[nodiscard]] bool spindle_is_held() const noexcept;

  /// Sets what is added to the model's force and what limits it, for the following steps.
  /// @throws Error naming the field, its value and the allowed range; then nothing has changed
  void set_effects(const Effects& effects);

  /// Another tool for the same workpiece, as it is: cuts, undo marks, removed volumes and energies stay; the tool
  /// starts afresh, with the speed of its own spindle.
  /// @throws Error when the head does not suit the voxels or the law; then nothing has changed
  void set_tool(Tool tool);

  /// Other constants of the materials; cuts, undo marks, removed volumes and energies stay, and the tool starts afresh.
  /// @throws Error when there are not as many materials as before, or a stiffness is out of range; then nothing has
  ///         changed
  void set_materials(MaterialTable materials);

  /// Sets SimulationConfig::friction for the following steps; empty: each material's own.
  /// @throws Error naming the constant, its value and the allowed range; then nothing has changed
  void set_friction(const std::optional<DryFriction>& friction);

  /// Sets SimulationConfig::removal for the following steps; `none`: nothing is cut, whatever the spindle does.
  void set_removal(RemovalLaw removal) noexcept;

  /// Fills the pool of the workpiece up to `count` blocks.
  void reserve_blocks(std::size_t count);

  [[nodiscard]] WorkpieceSnapshot snapshot() const;  ///< of the workpiece, to undo to
  void restore(const WorkpieceSnapshot& snapshot);   ///< puts the workpiece back; the tool starts afresh, in the air

  /// Memory for `set_undo_mark` and `undo`, also after `reset`: see Workpiece::reserve_undo.
  void reserve_undo(std::size_t blocks);

  // --- exchanges while a loop goes on, between steps
  // ------------------------------------------------------------------
  /// `set_tool` without an allocation. `prepared` holds the old tool then.
  /// @return false, and nothing has changed, when it was made for voxels of another size
  /// @realtime no allocation, no lock; O(materials)
  [[nodiscard]] bool exchange(PreparedTool& prepared) noexcept;

  /// `set_materials` without an allocation. `prepared` holds the old ones then.
  /// @return false, and nothing has changed, when there are not as many
  /// @realtime no allocation, no lock; O(materials)
  [[nodiscard]] bool exchange(PreparedMaterials& prepared) noexcept;

  /// Goes on with workpiece and tool of another simulation, which holds the old ones then. Energies, removed volumes
  /// and undo marks are those of the other one; effects, friction and removal stay as they are set here.
  /// @realtime no allocation, no lock; O(1)
  void exchange(Simulation& prepared) noexcept;

  // --- undo while a loop goes on, between steps ----------------------------------------------------------------------
  /// Marks the present state of the workpiece.
  /// @return false: there is no mark, because `reserve_undo` was not called
  /// @realtime no allocation, no lock; O(1)
  bool set_undo_mark() noexcept;

  [[nodiscard]] std::size_t undo_marks() const noexcept;  ///< that `undo` can return to

  /// Goes back towards the last mark by up to `most` blocks (and at least one), 0.3 us each; `changed_blocks` then
  /// names them. To be called until it says that the workpiece is that of the mark, which is then gone; the tool starts
  /// afresh. What was removed stays counted.
  /// @return true when it is done, or there is no mark
  /// @realtime no allocation, no lock; O(most)
  bool undo(std::size_t most) noexcept;

  [[nodiscard]] std::size_t redo_marks() const noexcept;  ///< undone ones that `redo` can go forth over

  /// Goes forth again to the state from which the last `undo` began, whose mark is there again; as `undo` otherwise.
  /// Needs no memory beyond that of `reserve_undo`. After another cut there is no way forth.
  /// @return true when it is done, or nothing was undone
  /// @realtime no allocation, no lock; O(most)
  bool redo(std::size_t most) noexcept;

  /// Takes voxels of one block away without cutting them, between two steps. Their volume is no removed volume, but
  /// `taken_volume_by_material`; what had been pressed in them is EnergyLedger::entered of the next step. Undo brings
  /// them back.
  /// @return false, and nothing has changed, when no reserved block is left for it
  /// @realtime no allocation, no lock; O(512)
  bool remove_voxels(const BlockVoxels& voxels) noexcept;

  /// [m^3] that `remove_voxels` took away since construction or reset, by MaterialId.
  [[nodiscard]] const ByMaterial<double>& taken_volume_by_material() const noexcept;

  /// Starts again with another workpiece: tool position, energies, removed volumes and undo marks are forgotten. It
  /// gets as much memory for undo as the old one had.
  /// @throws Error when the workpiece is empty, or the head thinner than a voxel; then nothing has changed
  void reset(Workpiece workpiece);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
