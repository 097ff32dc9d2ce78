// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/workspace_map.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// What a SimulationModel can be told while the loop runs.
namespace model_commands {

[[nodiscard]] LoopCommand set_spindle_speed(double speed);  ///< [rad/s]; what no spindle does is ignored
[[nodiscard]] LoopCommand open_clutch();                    ///< the hand moves, the tool stays
[[nodiscard]] LoopCommand close_clutch();                   ///< the tool follows again, from where it is
[[nodiscard]] LoopCommand set_scale(double scale);          ///< [1] world over hand; what is not > 0 is ignored

/// Marks the workpiece as it is in this tick: see SimulationModelOptions::undo_blocks.
[[nodiscard]] LoopCommand set_undo_mark();

/// Puts the workpiece back to the last mark, over as many ticks as it takes and without a force; the guard then waits
/// until the tool is free. Without a mark it is ignored. A recording ends there.
[[nodiscard]] LoopCommand undo();

}  // namespace model_commands

/// What a SimulationModel shows of its last tick, in LoopSnapshot::values.
struct ToolSnapshot {
  Vec3 force = Vec3::Zero();   ///< [N] what the hand is meant to feel, in W
  Vec3 torque = Vec3::Zero();  ///< [N·m] about Ho, in W
  double removed_volume = 0;   ///< [m^3] since the loop began
  double contact_depth = 0;    ///< [m]
  int contact_voxels = 0;
  double spindle_speed = 0;            ///< [rad/s]
  StepStatus status = StepStatus::ok;  ///< of the last step
  StepStatus seen = StepStatus::ok;    ///< of all steps since the loop began
  std::uint64_t steps = 0;             ///< since the loop began
  std::size_t undo_marks = 0;          ///< that can be returned to
  bool undoing = false;                ///< on the way back to one: nothing is felt or cut, and what is of a step is 0
};
[[nodiscard]] ToolSnapshot tool_of(const LoopSnapshot& snapshot);

/// How a simulation is driven by a device.
struct SimulationModelOptions {
  WorkspaceMapOptions map;  ///< from the device's base to the world

  /// Between hand and tool; empty: the device is driven directly by the contact, which must then be as soft as the
  /// device (`stiffness_for_device`).
  std::optional<CouplingGains> coupling;

  /// While the guard holds the force back, and from then on until the tool has touched nothing, the spindle stands:
  /// nothing is cut that the hand cannot feel, and a tool that begins inside the material does not eat its way out.
  bool spindle_needs_force = true;

  /// Blocks that may be cut after the undo marks, together; 2.7 kB each: see Workpiece::reserve_undo. 0: none are
  /// reserved here.
  std::size_t undo_blocks = 0;
  std::size_t undo_blocks_per_tick = 64;  ///< > 0, put back at most; 0.3 us each
};

/// A simulation as the model of a loop: the device moves its tool, its force goes to the device, and the blocks that it
/// changes go to whoever shows them.
///
/// The simulation and the device are the loop's while it runs: set up before `RealtimeLoop::start`, look at results
/// after `wait`, and send commands and receive snapshots in between.
class SimulationModel final : public LoopModel {
 public:
  /// @param device  whose guard must know of clutch and scale; the one that the loop runs
  /// @throws Error when the map is none, the coupling does not suit the simulation, or the workpiece is too large for
  ///         undo
  SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options = {});

  /// The voxels whose blocks may change: RealtimeLoopOptions::region for pictures of the workpiece.
  [[nodiscard]] IndexBox region() const { return region_; }

  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override;
  void obey(const LoopCommand& command) noexcept override;
  void mark_changes(BlockOutbox& outbox) noexcept override;
  void copy(ChangedBlock& block) noexcept override;

 private:
  [[nodiscard]] Wrench follow_hand(const Pose& pose, const Twist& velocity, double dt) noexcept;
  [[nodiscard]] Wrench move_tool(const DeviceState& state, double dt) noexcept;
  void turn_spindle(ArmingState arming) noexcept;
  void go_back(const DeviceState& state) noexcept;
  void show(LoopSnapshot& snapshot) const noexcept;

  Simulation* simulation_;
  Device* device_;
  WorkspaceMap map_;
  std::optional<VirtualCoupling> coupling_;
  IndexBox region_;
  bool spindle_needs_force_;
  std::size_t undo_blocks_per_tick_;

  double spindle_speed_;  // [rad/s] while there is a force
  Pose X_BS_;             // of the last valid reading
  Pose X_WH_;             // of the tool's handle
  ToolSnapshot tool_;
  bool may_cut_ = false;   // there is a force, and the tool was free since it came back
  ChangedBlocks changed_;  // in this tick
};

/// Content of a block of a workpiece, for pictures and copies.
/// @param block  `origin` is given
/// @realtime no allocation, no lock; O(512)
void copy_block(const Workpiece& workpiece, ChangedBlock& block) noexcept;

}  // namespace hapticut
