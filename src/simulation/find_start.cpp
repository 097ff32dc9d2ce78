// SPDX-License-Identifier: Apache-2.0
// Where the tool starts in a step.
#include <optional>
#include <utility>

#include "simulation/hand_motion.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr double kMaxStepRotation = 1;  // [rad] rotation in a step; a script may rotate the tool faster than a hand

}  // namespace

/// Places the tool where it moves from in this step: where the last step left it, or at a new place.
/// @return ok, or why the step is rejected
StepStatus Simulation::State::find_start(bool coupled) noexcept {
  const StageTimer timer = timed(&StageTimes::find_start);
  const auto& [X_WH, V_WH, dt] = input;
  if (!motion.is_placed() && !start_tool(coupled)) return StepStatus::tool_waits;
  if (hand.was_released && coupled && is_placed_elsewhere(X_WH, V_WH, dt)) place_at(advance(X_WH, V_WH, -dt));
  if (is_jump()) {
    if (const StepStatus jump = follow_jump(); jump != StepStatus::ok) return jump;
  }
  motion.accept_input();
  return StepStatus::ok;
}

/// Places the tool for its first step, where its velocity says that it comes from. A tool that was separated from its
/// hand is placed only where it touches nothing; if the hand holds it without a coupling, it is placed at the hand.
/// @return false when it is not placed yet
bool Simulation::State::start_tool(bool coupled) noexcept {
  const auto& [X_WH, V_WH, dt] = input;
  const Pose from = motion.is_separated() && !coupled ? X_WH : advance(X_WH, V_WH, -dt);
  if (motion.is_separated() && (coupled ? is_in_material(from) : touches(from))) return false;
  place_at(from);
  return true;
}

/// Whether a coupling whose hand was released begins again with the tool elsewhere.
bool Simulation::State::is_placed_elsewhere(const Pose& X_WH, const Twist& V_WH, double dt) const noexcept {
  return sweep_between(motion.X_WH(), advance(X_WH, V_WH, -dt)).sub_steps > 1;
}

/// Whether the input is too far from the tool to be a motion: too far for one step, or for the time of rejected steps.
bool Simulation::State::is_jump() const noexcept {
  const int sub_steps = sweep_between(motion.X_WH(), input.X_WH).sub_steps;
  return sub_steps > config.max_sweep || rotated_beyond(motion.X_WH(), input.X_WH, kMaxStepRotation) ||
         (motion.is_after_rejection() && sub_steps * 0.5 * workpiece.voxel_size() > kNear);
}

/// Whether a jump would place a turning head in material that it has not cut its way into.
bool Simulation::State::jumps_into_material(const Pose& X_WH) noexcept {
  if (spindle.is_off()) return false;
  const Vec3 shift = X_WH * tool.X_HT().translation - motion.X_WH() * tool.X_HT().translation;
  const bool is_elsewhere =
      shift.norm() > tool.head().cutting_radius() || rotated_beyond(motion.X_WH(), X_WH, kMaxStepRotation);
  return is_elsewhere && touches(X_WH);
}

/// Handles a jump, which may be an error of the device. The tool stays where it is, and continues from there when the
/// next pose is near it. When two poses in a row are near each other, the tool is placed at the second one.
/// @return ok when the tool was placed there
StepStatus Simulation::State::follow_jump() noexcept {
  const Pose& X_WH = input.X_WH;
  const bool waits = jumps_into_material(X_WH);
  const std::optional<Pose>& before = motion.rejected_jump();
  const bool is_confirmed = before && sweep_between(*before, X_WH).sub_steps <= config.max_sweep &&
                            !rotated_beyond(*before, X_WH, kMaxStepRotation);
  if (!waits && is_confirmed) {
    place_at(X_WH);
    return StepStatus::ok;
  }
  motion.reject_jump(X_WH);
  return StepStatus::jump_rejected | (waits ? StepStatus::tool_waits : StepStatus::ok);
}

void Simulation::State::place_at(const Pose& X_WH) noexcept {
  result.energy.sliding += std::exchange(result.energy.anchored, 0);
  springs = {};
  crushing_depth = 0;
  hand.output.restart();
  motion.place_at(X_WH);
}

}  // namespace hapticut
