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

/// How a simulation is driven by a device.
struct SimulationModelOptions {
  WorkspaceMapOptions map;

  /// As the device feels them: at another scale of the map the gains in the world are others. Without a coupling, the
  /// contact must be as soft as what the device renders (`stiffness_for_device`).
  std::optional<CouplingGains> coupling;

  /// Nothing is cut that the hand cannot feel, and a tool that begins inside the material does not eat its way out.
  bool spindle_needs_force = true;

  /// As the foot pedal of a handpiece, or a button of the stylus: without one the spindle turns all the time.
  int pedal = -1;

  /// 2.7 kB each, for the way back and forth: see Workpiece::reserve_undo.
  std::size_t undo_blocks = 0;
  std::size_t undo_blocks_per_tick = 64;
};

constexpr auto fields_of(Of<SimulationModelOptions>) {
  using O = SimulationModelOptions;
  return std::tuple{
      field("map", &O::map, "from the device's base to the world"),
      field("coupling", &O::coupling, "between hand and tool; empty: the device is driven directly by the contact"),
      field("spindle_needs_force", &O::spindle_needs_force,
            "the spindle stands while the guard holds the force back, and from then on until the tool has touched "
            "nothing"),
      field("pedal", &O::pedal, "1", Range{-1, 31},
            "the button of the device while which the spindle turns; -1: none, and it turns all the time"),
      field("undo_blocks", &O::undo_blocks, "blocks", Range::not_negative(),
            "that may be cut after the undo marks, together; 0: reserves nothing"),
      field("undo_blocks_per_tick", &O::undo_blocks_per_tick, "blocks", Range::positive(),
            "put back at most, or forth; 0.5 us each"),
  };
}

/// A simulation as the model of a loop: the device moves its tool, its force goes to the device, and the blocks that it
/// changes go to the thread that shows them.
///
/// The simulation and the device are the loop's while it runs: set up before `RealtimeLoop::start`, look at results
/// after `wait`, and send commands (loop/commands.hpp) and receive snapshots in between.
class SimulationModel final : public LoopModel {
 public:
  /// @param device  whose guard must know of clutch and scale; the one that the loop runs
  /// @throws Error when the map is not valid, the coupling does not suit the simulation, the workpiece is too large for
  ///         undo, or the device would be driven directly by a contact that is stiffer than what it renders
  SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options = {});

  /// Lets the spindle turn again as it was asked to, for steps without a loop.
  ~SimulationModel() override;
  SimulationModel(const SimulationModel&) = delete;
  SimulationModel& operator=(const SimulationModel&) = delete;

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
  [[nodiscard]] ModelContact contact() const noexcept override { return contact_; }
  [[nodiscard]] double spindle_speed() const noexcept {
    return simulation_->spindle_setting();
  }  ///< [rad/s] while there is a force
  bool obey(LoopCommand& command) noexcept override;
  [[nodiscard]] Simulation* simulation() noexcept override { return simulation_; }

 private:
  template <class Model>
  struct Commands;                          // what each asks of its sender, and what it does
  enum class Travel { none, back, forth };  // over an undo mark

  void require_renderable(double contact_stiffness, const SimulationConfig& config, double relative_stiffness,
                          double scale) const;
  void require_gains_within(const WorkspaceMapOptions& map) const;
  [[nodiscard]] Wrench follow_hand(const Pose& pose, const Twist& velocity, double dt) noexcept;
  [[nodiscard]] Wrench move_tool(const DeviceState& state, double dt) noexcept;
  [[nodiscard]] Wrench hold_force(const DeviceState& state) const noexcept;
  void turn_spindle(const DeviceState& state) noexcept;
  void travel(const DeviceState& state) noexcept;
  void rest() noexcept;
  [[nodiscard]] ModelContact describe_contact(const DeviceState& state, const Wrench& felt,
                                              double motor) const noexcept;
  void show(LoopSnapshot& snapshot) const noexcept;

  bool begin(Travel way, std::size_t marks) noexcept;
  void feel_nothing(StepStatus status) noexcept;
  void after_exchange() noexcept;

  // As it was when the model was made; the senders of commands read it while the loop runs.
  const SimulationConfig config_;
  const double voxel_size_;  // [m]
  const std::size_t undo_blocks_;
  const IndexBox region_;
  const WorkspaceMapOptions first_map_;
  const std::optional<CouplingGains> gains_;  // of the coupling, as the device feels them
  const double renders_;                      // [N/m] the device; 0: not known, or a coupling stands between
  const double relative_stiffness_;           // [1] largest of the materials
  const double contact_stiffness_;            // [m^3] of the head, of unit k_v

  Simulation* simulation_;
  Device* device_;
  WorkspaceMap map_;
  std::optional<VirtualCoupling> coupling_;
  bool spindle_needs_force_;
  int pedal_;
  std::size_t undo_blocks_per_tick_;

  SpindleInterlock interlock_;
  Pose X_BS_;                // of the last valid reading
  std::uint32_t epoch_ = 0;  // of it
  Pose X_WH_;                // of the tool's handle
  ToolSnapshot tool_;
  Travel travel_ = Travel::none;
  bool unfelt_ = false;   // the next wrench, because the guard hears of its reason at the next reading only
  bool touches_ = true;   // something, for all that is known
  bool books_energy_;     // the law, so that it is known what is stored
  ModelContact contact_;  // of the last tick
};

}  // namespace hapticut
