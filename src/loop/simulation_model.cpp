// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/simulation_model.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/stiffness.hpp"

namespace hapticut {
namespace {

/// Checks the gains at the device. A device that states no stiffness may have any.
void require_renderable_gains(const CouplingGains& gains, const DeviceCapabilities& device) {
  constexpr double kBeyond = 2;  // [1] a coupling may be stiffer than the maker guarantees, but not much
  const auto require = [&](double given, double rendered, const Name& name, const std::string& unit) {
    if (!(rendered > 0) || given <= kBeyond * rendered) return;
    throw Error(name + " = " + format_number(given) + " " + unit + ", but the device " + device.model + " renders " +
                format_number(rendered) + " " + unit + ", so it would buzz. Give at most " +
                format_number(kBeyond * rendered) + " " + unit +
                Sentence::clause(", or what " + "coupling_gains"_name + " chooses for the device") + ".");
  };
  require(gains.stiffness, device.stiffness, "SimulationModelOptions::coupling.stiffness"_name, "N/m");
  require(gains.angular_stiffness, device.rotational_stiffness,
          "SimulationModelOptions::coupling.angular_stiffness"_name, "N m/rad");
}

}  // namespace

SimulationModel::SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options)
    : config_(simulation.config()),
      voxel_size_(simulation.workpiece().voxel_size()),
      undo_blocks_(options.undo_blocks),
      region_(simulation.workpiece().bounds()),
      first_map_(options.map),
      gains_(options.coupling),
      device_stiffness_(gains_ ? 0 : device.capabilities().stiffness),
      relative_stiffness_(max_relative_stiffness(simulation.workpiece().materials())),
      contact_stiffness_(max_contact_stiffness(simulation.tool().head())),
      simulation_(&simulation),
      device_(&device),
      map_(options.map),
      spindle_needs_force_(options.spindle_needs_force),
      pedal_(options.pedal),
      undo_blocks_per_tick_(options.undo_blocks_per_tick),
      books_energy_(config_.law->is_foundation()) {
  require_fields_within(options, "SimulationModelOptions::");
  require_gains_within(options.map);
  require_renderable(contact_stiffness_, config_, relative_stiffness_, options.map.scale);
  if (gains_) require_renderable_gains(*gains_, device.capabilities());
  if (gains_)  // without lists, because a snapshot has none
    coupling_.emplace(simulation, gains_in_world(*gains_, options.map), VirtualCoupling::Lists{})
        .park(VirtualCoupling::Rejoin::free);
  if (options.undo_blocks > 0 && options.undo_blocks != simulation.workpiece().undo_blocks())
    simulation.history().reserve(options.undo_blocks);  // a new reserve would drop existing marks
}

/// Other laws report neither stiffness nor stored energy. For them only the guard protects the hand.
void SimulationModel::require_renderable(double contact_stiffness, const SimulationConfig& config,
                                         double relative_stiffness, double scale) const {
  constexpr double kRounding = 1.01;
  if (device_stiffness_ == 0 || !config.law->is_foundation()) return;
  const double renders = device_stiffness_ / (scale * first_map_.force_scale);      // [N/m] stiffness in the world
  const double max_stiffness = renders / (contact_stiffness * relative_stiffness);  // [N/m^4]
  if (config.reference_stiffness <= kRounding * max_stiffness) return;
  throw Error("the device renders " + format_number(renders) + " N/m, but driven directly it would meet up to " +
              format_number(renders * config.reference_stiffness / max_stiffness) +
              " N/m, and buzz. Add a virtual coupling (" + "SimulationModelOptions::coupling"_name +
              Sentence::clause(" with " + "SimulationConfig::contact_time"_name + " = " + "ContactTime::end"_name) +
              "), or lower the reference stiffness to " + format_number(max_stiffness) + " N/m^4.");
}

Wrench SimulationModel::step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept {
  contact_ = {true, {}, {}};  // the tool may touch something
  Wrench wrench;
  if (state.valid) {
    X_BS_ = state.X_BS;
    // Poses before and after a calibration are not comparable.
    if (std::exchange(epoch_, state.epoch) != state.epoch && coupling_) coupling_->reset();
  }
  if (restoring_ != Restoring::none) {
    restore_blocks(state);
  } else if (!state.valid || !map_.engaged()) {
    park_tool();
  } else {
    update_spindle(state);
    const Wrench felt = move_tool(state, dt);
    if (!std::exchange(skip_force_, false)) wrench = tool_.force_held ? hold_force(state) : felt;
  }
  fill_in(snapshot);
  return wrench;
}

/// Restores some blocks of an undo or a redo.
void SimulationModel::restore_blocks(const DeviceState& state) noexcept {
  if (state.valid && !coupling_) X_WH_ = map_.to_world(state.X_BS);
  interlock_.interrupt();
  const bool done = restoring_ == Restoring::undo ? simulation_->history().undo(undo_blocks_per_tick_)
                                                  : simulation_->history().redo(undo_blocks_per_tick_);
  if (done) restoring_ = Restoring::none;
  // The material that the tool is in now must not be felt at once.
  device_->interrupt(SafetyEvent::model_swapped);
}

SimulationModel::~SimulationModel() { simulation_->spindle().hold(false); }

/// The pose of the hand is unknown, or the clutch is open: the tool keeps its pose and cuts nothing.
void SimulationModel::park_tool() noexcept {
  feel_nothing(StepStatus::ok);
  interlock_.interrupt();
  if (coupling_) coupling_->park(VirtualCoupling::Rejoin::near);
  if (spindle_needs_force_) simulation_->spindle().hold(true);
}

/// The held force, rendered at the present pose of the hand.
Wrench SimulationModel::hold_force(const DeviceState& state) const noexcept {
  return map_.to_device(state.X_BS, {tool_.force, tool_.torque});
}

void SimulationModel::update_spindle(const DeviceState& state) noexcept {
  const bool no_force = tool_.force_held || device_->requests().emergency();  // the guard acts on it after this tick
  const bool admitted = interlock_.admits(no_force ? ArmingState::off : device_->last_arming(), touches_);
  const bool pressed = pedal_ < 0 || simulation_->tool().spindle().speed == 0 || state.pressed(pedal_);
  simulation_->spindle().hold(!pressed || (!admitted && spindle_needs_force_));
}

/// Makes a step, with or without the coupling.  @return the wrench for the hand, about Ho of the hand, in W
Wrench SimulationModel::follow_hand(const Pose& X_WD, const Twist& V_WD, double dt) noexcept {
  if (coupling_) {
    const CoupledResult& result = coupling_->step(X_WD, V_WD, dt);
    X_WH_ = result.X_WH;
    tool_.removed_volume += result.removed_volume;
    tool_.status = result.status;
    tool_.effort = {result.sub_ticks, result.newton_steps, result.level_of_detail};
    return result.hand;
  }
  const StepResult& result = simulation_->step(X_WD, V_WD, dt);
  X_WH_ = X_WD;
  tool_.removed_volume += result.removed_volume;
  tool_.status = result.status;
  tool_.effort = {1, 0, result.contact.level_of_detail};
  return {result.force, result.torque};
}

Wrench SimulationModel::move_tool(const DeviceState& state, double dt) noexcept {
  const std::uint64_t steps = simulation_->steps();
  const double before = simulation_->last_result().energy.losses();
  const double motor_before = simulation_->last_result().energy.motor_work;
  const Wrench felt = follow_hand(map_.to_world(state.X_BS), map_.to_world(state.X_BS, state.velocity), dt);
  tool_.status_seen |= tool_.status;
  tool_.max_effort = {std::max(tool_.max_effort.sub_ticks, tool_.effort.sub_ticks),
                      std::max(tool_.max_effort.newton_steps, tool_.effort.newton_steps),
                      std::max(tool_.max_effort.level_of_detail, tool_.effort.level_of_detail)};
  if (simulation_->steps() == steps) {  // no step: the parked tool waits for the hand
    feel_nothing(tool_.status);
    return {};
  }
  const StepResult& result = simulation_->last_result();
  touches_ = has_any(tool_.status, kRejected | StepStatus::tool_waits) || (result.contact.voxels > 0 && !rests(state));
  ++tool_.steps;
  tool_.dissipated += result.energy.losses() - before;
  if (!tool_.force_held) {
    tool_.force = felt.force;
    tool_.torque = felt.torque;
  }
  tool_.contact_depth = result.contact.depth;
  tool_.contact_voxels = result.contact.voxels;
  tool_.contact_point_W = result.contact.point_W;
  tool_.spindle_speed = result.spindle.speed;
  contact_ = describe_contact(state, felt, result.energy.motor_work - motor_before);
  return map_.to_device(state.X_BS, felt);
}

/// Whether a guard may begin although the tool touches: the hand holds it on a surface.
bool SimulationModel::rests(const DeviceState& state) const noexcept {
  const ArmingState arming = device_->last_arming();
  return coupling_ && (arming == ArmingState::wait_free || arming == ArmingState::ramp) &&
         !simulation_->is_in_material(map_.to_world(state.X_BS));
}

/// What the guard must know about a step.
/// @param motor  [J] work of the spindle's motor in the step
ModelContact SimulationModel::describe_contact(const DeviceState& state, const Wrench& felt,
                                               double motor) const noexcept {
  const StepResult& result = simulation_->last_result();
  ModelContact contact;
  contact.touching = touches_;
  const Wrench& pure = coupling_ ? coupling_->last_result().coupling : result.model;
  contact.effects = map_.to_device(state.X_BS, {felt.force - pure.force, felt.torque - pure.torque});
  if (!books_energy_) return contact;
  double stored = result.energy.elastic + result.energy.anchored;
  if (coupling_) stored += coupling_->last_result().energy.spring + coupling_->last_result().energy.kinetic;
  const WorkspaceMapOptions& map = map_.options();
  const double at_hand = std::max(map.force_scale / map.scale, map.torque_scale);
  contact.stored = at_hand * std::max(stored, 0.0);
  if (coupling_ && !tool_.force_held) contact.motor = at_hand * motor;
  return contact;
}

void SimulationModel::fill_in(LoopSnapshot& snapshot) const noexcept {
  snapshot.X_WT = X_WH_ * simulation_->tool().X_HT();
  snapshot.tool = tool_;
  snapshot.tool.undo_marks = simulation_->workpiece().marks();
  snapshot.tool.redo_marks = simulation_->workpiece().redo_marks();
  snapshot.tool.touched = simulation_->totals().touched;
  snapshot.tool.undoing = restoring_ == Restoring::undo;
  snapshot.tool.redoing = restoring_ == Restoring::redo;
}

}  // namespace hapticut
