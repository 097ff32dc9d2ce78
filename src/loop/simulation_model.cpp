// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/simulation_model.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

bool has_force(ArmingState arming) { return arming == ArmingState::ramp || arming == ArmingState::on; }

}  // namespace

SimulationModel::SimulationModel(Simulation& simulation, Device& device, const SimulationModelOptions& options)
    : config_(simulation.config()),
      voxel_size_(simulation.workpiece().voxel_size()),
      undo_blocks_(options.undo_blocks),
      region_(simulation.workpiece().bounds()),
      coupled_(options.coupling.has_value()),
      simulation_(&simulation),
      device_(&device),
      map_(options.map),
      bounds_(region_),
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
  if (travel_ != Travel::none) {
    travel(state);
  } else if (std::exchange(exchanged_, false)) {
    stay_with_hand(state);  // the guard hears of it at the next reading
  } else if (state.valid) {
    turn_spindle(device_->last_arming());
    const Wrench felt = move_tool(state, dt);
    wrench = tool_.force_held ? hold_force(state) : felt;
  } else if (coupling_) {
    coupling_->release();  // the hand may be anywhere by the next reading
  }
  show(snapshot);
  return wrench;
}

/// A part of the way to the last mark, or from it. The tool is with the hand, as it will be when it can feel again.
void SimulationModel::travel(const DeviceState& state) noexcept {
  stay_with_hand(state);
  const bool done =
      travel_ == Travel::back ? simulation_->undo(undo_blocks_per_tick_) : simulation_->redo(undo_blocks_per_tick_);
  if (done) travel_ = Travel::none;
  changed_ = simulation_->changed_blocks();
  // The material that the tool is in now must not be felt at once.
  device_->interrupt(SafetyEvent::model_swapped);
}

void SimulationModel::stay_with_hand(const DeviceState& state) noexcept {
  if (state.valid) X_WH_ = map_.to_world(state.X_BS);
  may_cut_ = false;
}

/// What was felt when it was to be held, in W, at the hand as it is now.
Wrench SimulationModel::hold_force(const DeviceState& state) const noexcept {
  return map_.to_device(state.X_BS, {tool_.force, tool_.torque});
}

void SimulationModel::turn_spindle(ArmingState arming) noexcept {
  if (!has_force(arming) || tool_.force_held)
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
  if (!tool_.force_held) {
    tool_.force = felt.force;
    tool_.torque = felt.torque;
  }
  tool_.contact_depth = result.contact.depth;
  tool_.contact_voxels = result.contact.voxels;
  tool_.spindle_speed = result.spindle.speed;
  tool_.seen |= tool_.status;
  return map_.to_device(state.X_BS, felt);
}

void SimulationModel::show(LoopSnapshot& snapshot) const noexcept {
  snapshot.X_WT = X_WH_ * simulation_->tool().X_HT();
  snapshot.tool = tool_;
  snapshot.tool.undo_marks = simulation_->undo_marks();
  snapshot.tool.redo_marks = simulation_->redo_marks();
  snapshot.tool.undoing = travel_ == Travel::back;
  snapshot.tool.redoing = travel_ == Travel::forth;
}

void SimulationModel::mark_changes(BlockOutbox& outbox) noexcept {
  for (const VoxelIndex& origin : changed_.origins) outbox.mark(origin);
  if (changed_.complete) return;
  for (int i = block_start(bounds_.min[0]); i <= bounds_.max[0]; i += kBlockEdge)
    for (int j = block_start(bounds_.min[1]); j <= bounds_.max[1]; j += kBlockEdge)
      for (int k = block_start(bounds_.min[2]); k <= bounds_.max[2]; k += kBlockEdge) outbox.mark({i, j, k});
}

void SimulationModel::copy(ChangedBlock& block) noexcept {
  block.workpiece = tool_.workpiece;
  copy_block(simulation_->workpiece(), block);
}

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
