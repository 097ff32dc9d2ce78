// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/simulation_model.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

enum Code : std::int32_t { kSpindleSpeed, kOpenClutch, kCloseClutch, kScale, kUndoMark, kUndo };

LoopCommand command(Code code, double value = 0) { return {LoopCommand::Kind::model, code, {value}}; }

// Where the numbers of a ToolSnapshot are in LoopSnapshot::values; a vector takes three places.
enum Place : std::size_t {
  kForce = 0,
  kTorque = kForce + 3,
  kRemovedVolume = kTorque + 3,
  kContactDepth,
  kContactVoxels,
  kSpindle,
  kStatus,
  kSeen,
  kSteps,
  kUndoMarks,
  kUndoing,
  kPlaces
};
static_assert(kPlaces <= std::tuple_size_v<decltype(LoopSnapshot::values)>);

Vec3 vector_at(const LoopSnapshot& snapshot, std::size_t place) {
  return {snapshot.values[place], snapshot.values[place + 1], snapshot.values[place + 2]};
}

bool has_force(ArmingState arming) { return arming == ArmingState::ramp || arming == ArmingState::on; }

}  // namespace

namespace model_commands {

LoopCommand set_spindle_speed(double speed) { return command(kSpindleSpeed, speed); }
LoopCommand open_clutch() { return command(kOpenClutch); }
LoopCommand close_clutch() { return command(kCloseClutch); }
LoopCommand set_scale(double scale) { return command(kScale, scale); }
LoopCommand set_undo_mark() { return command(kUndoMark); }
LoopCommand undo() { return command(kUndo); }

}  // namespace model_commands

ToolSnapshot tool_of(const LoopSnapshot& snapshot) {
  const auto& values = snapshot.values;
  ToolSnapshot tool;
  tool.force = vector_at(snapshot, kForce);
  tool.torque = vector_at(snapshot, kTorque);
  tool.removed_volume = values[kRemovedVolume];
  tool.contact_depth = values[kContactDepth];
  tool.contact_voxels = int(values[kContactVoxels]);
  tool.spindle_speed = values[kSpindle];
  tool.status = StepStatus(std::uint32_t(values[kStatus]));
  tool.seen = StepStatus(std::uint32_t(values[kSeen]));
  tool.steps = std::uint64_t(values[kSteps]);
  tool.undo_marks = std::size_t(values[kUndoMarks]);
  tool.undoing = values[kUndoing] != 0;
  return tool;
}

SimulationModel::SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options)
    : simulation_(&simulation),
      device_(&device),
      map_(options.map),
      region_(simulation.workpiece().bounds()),
      spindle_needs_force_(options.spindle_needs_force),
      undo_blocks_per_tick_(options.undo_blocks_per_tick),
      spindle_speed_(simulation.spindle_setting()) {
  require_positive(double(options.undo_blocks_per_tick), "SimulationModelOptions::undo_blocks_per_tick");
  if (options.coupling) coupling_.emplace(simulation, *options.coupling);
  if (options.undo_blocks > 0) simulation.reserve_undo(options.undo_blocks);
}

Wrench SimulationModel::step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept {
  changed_ = {};
  Wrench wrench;
  if (state.valid) X_BS_ = state.X_BS;
  if (tool_.undoing) {
    go_back(state);
  } else if (state.valid) {
    turn_spindle(device_->last_arming());
    wrench = move_tool(state, dt);
  } else if (coupling_) {
    coupling_->release();  // nobody knows where the hand will be
  }
  show(snapshot);
  return wrench;
}

/// A part of the way back to the last mark. The tool is with the hand, as it will be when it can feel again.
void SimulationModel::go_back(const DeviceState& state) noexcept {
  if (state.valid) X_WH_ = map_.to_world(state.X_BS);
  tool_.undoing = !simulation_->undo(undo_blocks_per_tick_);
  changed_ = simulation_->changed_blocks();
  // Whatever the tool is in now, nobody shall feel it at once.
  device_->interrupt(SafetyEvent::model_swapped);
  may_cut_ = false;
}

void SimulationModel::turn_spindle(ArmingState arming) noexcept {
  if (!has_force(arming))
    may_cut_ = false;
  else if (tool_.contact_voxels == 0)
    may_cut_ = true;
  const double wanted = spindle_needs_force_ && !may_cut_ ? 0 : spindle_speed_;
  if (wanted != simulation_->spindle_setting()) simulation_->set_spindle_speed(wanted);
}

/// Steps, with the coupling or without.  @return what the hand feels, about Ho of the hand, in W
Wrench SimulationModel::follow_hand(const Pose& pose, const Twist& velocity, double dt) noexcept {
  if (coupling_) {
    const CoupledResult& result = coupling_->step(pose, velocity, dt);
    if (result.parts == 0) return {};  // it refused the input
    X_WH_ = result.X_WH;
    changed_ = result.changed_blocks;
    tool_.removed_volume += result.removed_volume;
    tool_.status = result.status;
    return result.hand;
  }
  const StepResult& result = simulation_->step(pose, velocity, dt);
  X_WH_ = pose;
  changed_ = simulation_->changed_blocks();
  tool_.removed_volume += result.removed_volume;
  tool_.status = result.status;
  return {result.force, result.torque};
}

Wrench SimulationModel::move_tool(const DeviceState& state, double dt) noexcept {
  const std::uint64_t steps = simulation_->steps();
  const Wrench felt = follow_hand(map_.to_world(state.X_BS), map_.to_world(state.X_BS, state.velocity), dt);
  if (simulation_->steps() == steps) return {};  // the coupling refused the input
  const StepResult& result = simulation_->last_result();
  ++tool_.steps;
  tool_.force = felt.force;
  tool_.torque = felt.torque;
  tool_.contact_depth = result.contact.depth;
  tool_.contact_voxels = result.contact.voxels;
  tool_.spindle_speed = result.spindle.speed;
  tool_.seen |= tool_.status;
  return map_.to_device(state.X_BS, felt);
}

void SimulationModel::show(LoopSnapshot& snapshot) const noexcept {
  snapshot.X_WT = X_WH_ * simulation_->tool().X_HT();
  auto& values = snapshot.values;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    values[kForce + axis] = tool_.force[int(axis)];
    values[kTorque + axis] = tool_.torque[int(axis)];
  }
  values[kRemovedVolume] = tool_.removed_volume;
  values[kContactDepth] = tool_.contact_depth;
  values[kContactVoxels] = tool_.contact_voxels;
  values[kSpindle] = tool_.spindle_speed;
  values[kStatus] = double(std::uint32_t(tool_.status));
  values[kSeen] = double(std::uint32_t(tool_.seen));
  values[kSteps] = double(tool_.steps);
  values[kUndoMarks] = double(simulation_->undo_marks());
  values[kUndoing] = tool_.undoing ? 1 : 0;
}

void SimulationModel::obey(const LoopCommand& given) noexcept {
  const double value = given.values[0];
  switch (given.code) {
    case kSpindleSpeed:
      if (std::abs(value) <= kFastestSpindle) spindle_speed_ = value;
      break;
    case kOpenClutch:
      map_.release(X_BS_);
      break;
    case kCloseClutch:
      map_.engage(X_BS_);
      device_->interrupt(SafetyEvent::reclutched);
      break;
    case kScale:
      if (map_.set_scale(value, X_BS_)) device_->interrupt(SafetyEvent::reclutched);
      break;
    case kUndoMark:
      if (!tool_.undoing) simulation_->set_undo_mark();
      break;
    case kUndo:
      if (tool_.undoing || simulation_->undo_marks() == 0) break;
      tool_.undoing = true;
      tool_.force = tool_.torque = Vec3::Zero();
      tool_.contact_depth = tool_.spindle_speed = 0;
      tool_.contact_voxels = 0;
      tool_.status = StepStatus::ok;
      if (coupling_) coupling_->release();
      break;
    default:
      break;
  }
}

void SimulationModel::mark_changes(BlockOutbox& outbox) noexcept {
  for (const VoxelIndex& origin : changed_.origins) outbox.mark(origin);
  if (changed_.complete) return;
  for (int i = block_start(region_.min[0]); i <= region_.max[0]; i += kBlockEdge)
    for (int j = block_start(region_.min[1]); j <= region_.max[1]; j += kBlockEdge)
      for (int k = block_start(region_.min[2]); k <= region_.max[2]; k += kBlockEdge) outbox.mark({i, j, k});
}

void SimulationModel::copy(ChangedBlock& block) noexcept { copy_block(simulation_->workpiece(), block); }

void copy_block(const Workpiece& workpiece, ChangedBlock& block) noexcept {
  const BlockView view = workpiece.block(block.origin);
  if (view.material == nullptr) {
    block.material.fill(view.uniform_material);
    for (int n = 0; n < kBlockVoxels; ++n) block.fill[std::size_t(n)] = view.empty() ? 0.0F : view.fill_of(n);
    return;
  }
  block.material.fill(kEmpty);
  block.fill.fill(0);
  for (int word = 0; word < 8; ++word)
    for (std::uint64_t bits = view.solid[word]; bits != 0; bits &= bits - 1) {
      const int n = 64 * word + std::countr_zero(bits);
      block.material[std::size_t(n)] = view.material[n];
      block.fill[std::size_t(n)] = view.fill_of(n);
    }
}

}  // namespace hapticut
