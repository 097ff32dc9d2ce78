// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/spindle_interlock.hpp"
#include "hapticut/loop/workspace_map.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// How a device drives a simulation.
struct SimulationModelOptions {
  WorkspaceMapOptions map;  ///< map from the device's base to the world

  /// Gains of the coupling between hand and tool; empty: the contact drives the device directly.
  /// The gains are those at the device; `gains_in_world` converts them. Without a coupling, the contact must not be
  /// stiffer than the device can render (`stiffness_for_device`).
  std::optional<CouplingGains> coupling;

  /// Whether the spindle stands while the guard holds the force back, and afterwards until the tool has touched
  /// nothing.
  /// Then nothing is cut that the hand cannot feel, and a tool that is inside the material at the start does not cut
  /// its way out.
  bool spindle_needs_force = true;

  /// [1] button of the device that must be pressed for the spindle to run; -1: the spindle runs without a button.
  /// For example the foot pedal of a handpiece, or a button of the stylus.
  int pedal = -1;

  /// [blocks] that may be cut after all undo marks together; 0: no undo.
  /// 2.7 kB each, for undo and redo: see Workpiece::reserve_undo.
  std::size_t undo_blocks = 0;
  std::size_t undo_blocks_per_tick = 64;  ///< [blocks] restored per tick of an undo or redo at most; 0.5 us each
};

constexpr auto fields_of(Of<SimulationModelOptions>) {
  using O = SimulationModelOptions;
  return std::tuple{
      field("map", &O::map, "map from the device's base to the world"),
      field("coupling", &O::coupling,
            "gains of the coupling between hand and tool; empty: the contact drives the device directly"),
      field(
          "spindle_needs_force", &O::spindle_needs_force,
          "whether the spindle stands while the guard holds the force back, and afterwards until the tool has touched "
          "nothing"),
      field("pedal", &O::pedal, "1", Range{-1, 31},
            "button of the device that must be pressed for the spindle to run; -1: the spindle runs without a button"),
      field("undo_blocks", &O::undo_blocks, "blocks", Range::not_negative(),
            "that may be cut after all undo marks together; 0: no undo"),
      field("undo_blocks_per_tick", &O::undo_blocks_per_tick, "blocks", Range::positive(),
            "restored per tick of an undo or redo at most; 0.5 us each"),
  };
}

/// A simulation as the model of a loop. The device moves the tool, the force goes to the device, and changed blocks go
/// to the thread that draws them.
///
/// Simulation and device belong to the loop while it runs. Set them up before `RealtimeLoop::start`, and read results
/// after `wait`. In between, send commands (loop/commands.hpp) and receive snapshots.
class SimulationModel final : public LoopModel {
 public:
  /// @param device  the device of the loop; the model reports changes of clutch and scale to its guard
  /// @throws Error when the map is not valid, the coupling does not suit the simulation or is more than twice as stiff
  ///         as the device renders, the workpiece is too large for undo, or a contact that is stiffer than the device
  ///         renders would drive the device directly
  SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options = {});

  /// Lets the spindle run again at its set speed, for steps without a loop.
  ~SimulationModel() override;
  SimulationModel(const SimulationModel&) = delete;
  SimulationModel& operator=(const SimulationModel&) = delete;

  /// The voxels whose blocks may change: RealtimeLoopOptions::region for pictures of the workpiece.
  [[nodiscard]] IndexBox region() const { return region_; }

  // --- commands: any thread, also while the loop runs ---------------------------------------------------------------
  /// @return a command for the workpiece of when this model was made, or for one with the same voxel size
  /// @throws Error as commands::SetTool
  [[nodiscard]] commands::SetTool prepare_tool(Tool tool) const;

  /// @throws Error as commands::SetMaterials
  [[nodiscard]] commands::SetMaterials prepare_materials(MaterialTable materials) const;

  /// @return a command that exchanges the workpiece. It has the configuration that the simulation had when this model
  /// was
  ///         made, and the same memory for undo
  /// @throws Error as the constructor of Simulation
  [[nodiscard]] commands::ExchangeWorkpiece prepare_workpiece(Workpiece workpiece, Tool tool) const;

  void check(const LoopCommand& command) const override;

  // --- for the loop -------------------------------------------------------------------------------------------------
  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override;
  [[nodiscard]] ModelContact contact() const noexcept override { return contact_; }
  /// [rad/s] The set speed of the spindle, in use while there is a force.
  [[nodiscard]] double spindle_speed() const noexcept { return simulation_->spindle().setting(); }
  bool apply(LoopCommand& command) noexcept override;
  [[nodiscard]] Simulation* simulation() noexcept override { return simulation_; }

 private:
  template <class Model>
  struct Commands;                            // checks and applies each command
  enum class Restoring { none, undo, redo };  // which way a marked state is being restored

  void require_renderable(double contact_stiffness, const SimulationConfig& config, double relative_stiffness,
                          double scale) const;
  void require_gains_within(const WorkspaceMapOptions& map) const;
  [[nodiscard]] Wrench follow_hand(const Pose& X_WD, const Twist& V_WD, double dt) noexcept;
  [[nodiscard]] Wrench move_tool(const DeviceState& state, double dt) noexcept;
  [[nodiscard]] Wrench hold_force(const DeviceState& state) const noexcept;
  void update_spindle(const DeviceState& state) noexcept;
  void restore_blocks(const DeviceState& state) noexcept;
  void park_tool() noexcept;
  [[nodiscard]] bool rests(const DeviceState& state) const noexcept;
  [[nodiscard]] ModelContact describe_contact(const DeviceState& state, const Wrench& felt,
                                              double motor) const noexcept;
  void fill_in(LoopSnapshot& snapshot) const noexcept;

  bool begin_restoring(Restoring what, std::size_t marks) noexcept;
  void feel_nothing(StepStatus status) noexcept;
  void after_exchange() noexcept;

  // The state of when the model was made. The senders of commands read it while the loop runs.
  const SimulationConfig config_;
  const double voxel_size_;  // [m]
  const std::size_t undo_blocks_;
  const IndexBox region_;
  const WorkspaceMapOptions first_map_;
  const std::optional<CouplingGains> gains_;  // gains of the coupling, at the device
  const double device_stiffness_;             // [N/m] that it renders; 0: not known, or there is a coupling
  const double relative_stiffness_;           // [1] maximum of the materials
  const double contact_stiffness_;            // [m^3] contact stiffness of the head, per unit of k_v

  Simulation* simulation_;
  Device* device_;
  WorkspaceMap map_;
  std::optional<VirtualCoupling> coupling_;
  bool spindle_needs_force_;
  int pedal_;
  std::size_t undo_blocks_per_tick_;

  SpindleInterlock interlock_;
  Pose X_BS_;                // pose of the last valid reading
  std::uint32_t epoch_ = 0;  // epoch of that reading
  Pose X_WH_;                // pose of the tool's handle
  ToolSnapshot tool_;
  Restoring restoring_ = Restoring::none;
  bool skip_force_ = false;  // drop the next wrench, because the guard reads the interruption at the next reading only
  bool touches_ = true;      // the tool touches something, or may touch something
  bool books_energy_;        // the law reports the stored energy
  ModelContact contact_;     // contact in the last tick
};

}  // namespace hapticut
