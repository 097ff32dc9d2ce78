// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/workspace_map.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// How a simulation is driven by a device.
struct SimulationModelOptions {
  WorkspaceMapOptions map;  ///< from the device's base to the world

  /// Between hand and tool; empty: the device is driven directly by the contact, which must then be as soft as the
  /// device (`stiffness_for_device`).
  std::optional<CouplingGains> coupling;

  /// While the guard holds the force back, and from then on until the tool has touched nothing, the spindle stands:
  /// nothing is cut that the hand cannot feel, and a tool that begins inside the material does not eat its way out.
  bool spindle_needs_force = true;

  /// Blocks that may be cut after the undo marks, together; 2.7 kB each, for the way back and forth: see
  /// Workpiece::reserve_undo. 0: reserves nothing.
  std::size_t undo_blocks = 0;
  std::size_t undo_blocks_per_tick = 64;  ///< > 0, put back at most, or forth; 0.5 us each
};

/// A simulation as the model of a loop: the device moves its tool, its force goes to the device, and the blocks that it
/// changes go to the thread that shows them.
///
/// The simulation and the device are the loop's while it runs: set up before `RealtimeLoop::start`, look at results
/// after `wait`, and send commands (loop/commands.hpp) and receive snapshots in between.
class SimulationModel final : public LoopModel {
 public:
  /// @param device  whose guard must know of clutch and scale; the one that the loop runs
  /// @throws Error when the map is not valid, the coupling does not suit the simulation, or the workpiece is too large
  ///         for undo
  SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options = {});

  /// The voxels whose blocks may change: RealtimeLoopOptions::region for pictures of the workpiece.
  [[nodiscard]] IndexBox region() const { return region_; }

  // --- for commands, in any thread, while the loop runs or not ------------------------------------------------------
  /// @return a command for the workpiece that was in place when this model was made, or one of the same voxels
  /// @throws Error as commands::SetTool
  [[nodiscard]] commands::SetTool prepare_tool(Tool tool) const;

  /// @throws Error as commands::SetMaterials
  [[nodiscard]] commands::SetMaterials prepare_materials(MaterialTable materials) const;

  /// @return a command that puts another workpiece in place, with the configuration of this simulation when this model
  ///         was made and its memory for undo
  /// @throws Error as the constructor of Simulation
  [[nodiscard]] commands::ExchangeWorkpiece prepare_workpiece(Workpiece workpiece, Tool tool) const;

  void check(const LoopCommand& command) const override;

  // --- the loop's side ----------------------------------------------------------------------------------------------
  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override;
  bool obey(LoopCommand& command) noexcept override;
  void mark_changes(BlockOutbox& outbox) noexcept override;
  void copy(ChangedBlock& block) noexcept override;

 private:
  enum class Travel { none, back, forth };  // over an undo mark

  [[nodiscard]] Wrench follow_hand(const Pose& pose, const Twist& velocity, double dt) noexcept;
  [[nodiscard]] Wrench move_tool(const DeviceState& state, double dt) noexcept;
  [[nodiscard]] Wrench hold_force(const DeviceState& state) const noexcept;
  void turn_spindle(ArmingState arming) noexcept;
  void travel(const DeviceState& state) noexcept;
  void stay_with_hand(const DeviceState& state) noexcept;
  void show(LoopSnapshot& snapshot) const noexcept;

  bool apply(const commands::SetSpindleSpeed& command) noexcept;
  bool apply(const commands::OpenClutch& command) noexcept;
  bool apply(const commands::CloseClutch& command) noexcept;
  bool apply(const commands::SetScale& command) noexcept;
  bool apply(const commands::SetUndoMark& command) noexcept;
  bool apply(const commands::Undo& command) noexcept;
  bool apply(const commands::Redo& command) noexcept;
  bool apply(commands::SetTool& command) noexcept;
  bool apply(commands::SetMaterials& command) noexcept;
  bool apply(const commands::SetFriction& command) noexcept;
  bool apply(const commands::SetEffects& command) noexcept;
  bool apply(const commands::SetForceMask& command) noexcept;
  bool apply(const commands::SetRemoval& command) noexcept;
  bool apply(const commands::HoldForce& command) noexcept;
  bool apply(commands::ExchangeWorkpiece& command) noexcept;
  bool begin(Travel way, std::size_t marks) noexcept;
  void let_go() noexcept;
  void after_exchange() noexcept;

  // As it was when the model was made; the senders of commands read it while the loop runs.
  const SimulationConfig config_;
  const double voxel_size_;  // [m]
  const std::size_t undo_blocks_;
  const IndexBox region_;
  const bool coupled_;

  Simulation* simulation_;
  Device* device_;
  WorkspaceMap map_;
  std::optional<VirtualCoupling> coupling_;
  IndexBox bounds_;  // of the workpiece in place
  bool spindle_needs_force_;
  std::size_t undo_blocks_per_tick_;

  double spindle_speed_;  // [rad/s] while there is a force
  Pose X_BS_;             // of the last valid reading
  Pose X_WH_;             // of the tool's handle
  ToolSnapshot tool_;
  Travel travel_ = Travel::none;
  bool exchanged_ = false;  // since the last tick: something else may be where the tool is
  bool may_cut_ = false;    // there is a force, and the tool was free since it came back
  ChangedBlocks changed_;   // in this tick
};

/// Content of a block of a workpiece, for pictures and copies.
/// @param block  `origin` is given
/// @realtime no allocation, no lock; O(512)
void copy_block(const Workpiece& workpiece, ChangedBlock& block) noexcept;

}  // namespace hapticut
