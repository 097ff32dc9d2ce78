// SPDX-License-Identifier: Apache-2.0
// The step, stage by stage.
#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/hand_motion.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr double kRotationTolerance = 1e-3;  // [1] above the error of matrices from devices
constexpr double kMaxSpeed = 1e6;            // [m/s], [rad/s] above any hand's velocity
constexpr double kMaxStepRotation = 1;       // [rad] of a step; a script may rotate the tool faster than a hand
constexpr double kCancelled = 1e-4;          // [1] of the normal forces: rounding error of single precision
constexpr double kMuchCrushed = 0.1;         // [1] of the energy that removes material
constexpr double kThickLayer = 0.1;          // [1] of the head's radius

Twist expressed_in(const Pose& X_WT, const Twist& twist_W) {
  return {X_WT.rotation.transpose() * twist_W.linear, X_WT.rotation.transpose() * twist_W.angular};
}

}  // namespace

const StepResult& Simulation::step(const Pose& X_WH, const Twist& V_WH, double dt, HandCoupling* coupling) noexcept {
  State& s = *state_;
  s.begin_step({X_WH, V_WH, dt});
  s.take_step(coupling);
  s.tell_of_step(*this);
  return s.result;
}

void Simulation::State::take_step(HandCoupling* coupling) noexcept {
  const auto& [X_WH, V_WH, dt] = input;
  output_path = coupling == nullptr ? OutputPath::direct : OutputPath::kept;
  if (const StepStatus refused = check_step_input(); refused != StepStatus::ok) {
    after_refusal = true;
    return reject(refused);
  }
  if (const StepStatus refused = find_start(coupling != nullptr); refused != StepStatus::ok) return reject(refused);
  const Sweep sweep = plan_sweep(last_X_WH, X_WH);
  const Twist path = twist_between(last_X_WH, X_WH, dt);
  for (int i = 0; i < sweep.count(); ++i) {
    SubStep sub_step = plan_sub_step(last_X_WH, sweep.end(i) * dt, sweep.duration(i) * dt, path, V_WH);
    const std::span<const FoundBlock> blocks = find_blocks(sub_step);
    drive_spindle(blocks, sub_step);
    Encounter encounter = press_and_cut(blocks, sub_step);
    remove_emptied();
    hold_deep_contact(sub_step, encounter);
    add_friction(sub_step, encounter);
    book_energy(sub_step, encounter);
    transport_to_handle(sub_step, encounter, sweep.weight(i, config.contact_time));
    advance_spindle(sub_step, encounter);
  }
  give_output(coupling);
  finish_step(sweep.count(), path);
}

void Simulation::State::begin_step(const StepInput& given) noexcept {
  input = given;
  ++steps;
  free_blocks = workpiece.reserved_blocks();
  after_release = std::exchange(hand_released_since, false);
  after_halt = std::exchange(halted_since, false);
  after_set = std::exchange(set_since, false);
  removal.clear();
  contact_stages.forget_changes();
  first_touched = {};
  times = {};
  result.model = {};
  result.removed_voxels = {};
  result.removed_volume = 0;
  result.contact = {};
  result.spindle = {};
  result.sub_steps = 0;
  result.status = StepStatus::ok;
}

StepStatus check_input(const SimulationConfig& config, const Pose& X_WH, const Twist& V_WH, double dt) noexcept {
  StepStatus status = StepStatus::ok;
  if (!is_finite(X_WH) || !is_rotation(X_WH.rotation, kRotationTolerance)) status |= StepStatus::pose_rejected;
  if (!(V_WH.linear.norm() <= kMaxSpeed && V_WH.angular.norm() <= kMaxSpeed)) status |= StepStatus::velocity_rejected;
  if (!(dt >= config.min_dt && dt <= config.max_dt)) status |= StepStatus::dt_rejected;
  return status;
}

/// Sets `last_X_WH` to the pose from which the tool moves in this step: that of the last step, or that of a tool which
/// is placed anew.
/// @return ok, or why the step is refused
StepStatus Simulation::State::find_start(bool coupled) noexcept {
  const StageTimer timer = timed(&StageTimes::find_start);
  const auto& [X_WH, V_WH, dt] = input;
  if (!has_pose && !start_tool(coupled)) return StepStatus::tool_waits;
  if (after_release && coupled && is_placed_elsewhere(X_WH, V_WH, dt)) place_at(advance(X_WH, V_WH, -dt));
  if (is_jump()) {
    if (const StepStatus refused = follow_jump(); refused != StepStatus::ok) return refused;
  }
  jumped_to.reset();
  after_refusal = false;
  return StepStatus::ok;
}

/// Places the tool for its first step, where its velocity says that it comes from. A tool that was parted from its hand
/// is placed only where it touches nothing; if the hand holds it without a coupling, it is placed at the hand.
/// @return false when it is not placed yet
bool Simulation::State::start_tool(bool coupled) noexcept {
  const auto& [X_WH, V_WH, dt] = input;
  const Pose from = parted && !coupled ? X_WH : advance(X_WH, V_WH, -dt);
  if (parted && (coupled ? is_in_material(from) : touches(from))) return false;
  place_at(from);
  has_pose = true;
  parted = false;
  return true;
}

/// Whether a coupling whose hand was released begins again with the tool elsewhere.
bool Simulation::State::is_placed_elsewhere(const Pose& X_WH, const Twist& V_WH, double dt) const noexcept {
  return sub_steps_between(last_X_WH, advance(X_WH, V_WH, -dt)) > 1;
}

/// Whether the input is too far from the tool to be a motion: too far for one step, or for the time of refused steps.
bool Simulation::State::is_jump() const noexcept {
  const int sub_steps = sub_steps_between(last_X_WH, input.X_WH);
  return sub_steps > config.max_sweep || rotated_beyond(last_X_WH, input.X_WH, kMaxStepRotation) ||
         (after_refusal && sub_steps * 0.5 * workpiece.voxel_size() > kNear);
}

/// Whether a jump would place a turning head in material that it has not cut its way into.
bool Simulation::State::jumps_into_material(const Pose& X_WH) noexcept {
  if (motor.setting() == 0 && motor.speed() == 0) return false;
  const Vec3 shift = X_WH * tool.X_HT().translation - last_X_WH * tool.X_HT().translation;
  const bool is_elsewhere =
      shift.norm() > tool.head().cutting_radius() || rotated_beyond(last_X_WH, X_WH, kMaxStepRotation);
  return is_elsewhere && touches(X_WH);
}

/// Handles a jump, which may be an error of the device. The tool stays where it is, and continues from there when the
/// next pose is near it. When two poses in a row are near each other, the tool is placed at the second one.
/// @return ok when the tool was placed there
StepStatus Simulation::State::follow_jump() noexcept {
  const Pose& X_WH = input.X_WH;
  const bool waits = jumps_into_material(X_WH);
  const bool is_confirmed = jumped_to && sub_steps_between(*jumped_to, X_WH) <= config.max_sweep &&
                            !rotated_beyond(*jumped_to, X_WH, kMaxStepRotation);
  if (!waits && is_confirmed) {
    place_at(X_WH);
    return StepStatus::ok;
  }
  jumped_to = X_WH;
  return StepStatus::jump_rejected | (waits ? StepStatus::tool_waits : StepStatus::ok);
}

void Simulation::State::place_at(const Pose& X_WH) noexcept {
  result.energy.sliding += std::exchange(result.energy.anchored, 0);
  anchor.reset();
  deep_contact.reset();
  crushing_depth = 0;
  output.restart();
  last_X_WH = X_WH;
}

namespace {

/// [m/s] The mean of a velocity over about kMemory, `dt` later. kMemory is shorter than a change of direction of a
/// hand, and longer than a tool needs to pass a voxel or to calm down (docs/decisions/0021-hand-to-the-end.md).
Vec3 mean_of(const std::optional<Vec3>& before, const Vec3& velocity, double dt) noexcept {
  constexpr double kMemory = 0.02;  // [s]
  return before ? Vec3(*before + std::min(1.0, dt / kMemory) * (velocity - *before)) : velocity;
}

}  // namespace

/// @param end  [s] of the sub-step since the path's beginning
SubStep Simulation::State::plan_sub_step(const Pose& from, double end, double duration, const Twist& path,
                                         const Twist& felt) const noexcept {
  const StageTimer timer = timed(&StageTimes::plan_sub_step);
  const double lead = config.contact_time == ContactTime::end ? 0.5 : 0.0, evaluated = end - (0.5 - lead) * duration;
  SubStep sub_step;
  sub_step.duration = duration;
  sub_step.X_WH = advance(from, path, evaluated);
  sub_step.X_WT = sub_step.X_WH * tool.X_HT();
  const Vec3 p_HoTo_W = sub_step.X_WT.translation - sub_step.X_WH.translation;
  // The path leads from the beginning to the end, so its lever is that of the middle.
  const Mat3 R_WH = lead > 0 ? advance(from, path, end - 0.5 * duration).rotation : sub_step.X_WH.rotation;
  const Twist path_W = transport(path, Vec3(R_WH * tool.X_HT().translation));
  sub_step.path_T = expressed_in(sub_step.X_WT, path_W);
  const Twist felt_T = expressed_in(sub_step.X_WT, transport(felt, p_HoTo_W));
  sub_step.head.X_VT = X_VW * sub_step.X_WT;
  sub_step.head.motion = {.velocity = sub_step.path_T.linear.cast<float>(),
                          .angular_velocity = sub_step.path_T.angular.cast<float>(),
                          .felt_velocity = felt_T.linear.cast<float>(),
                          .felt_angular_velocity = felt_T.angular.cast<float>(),
                          .spin = 0,
                          .duration = float(duration),
                          .voxel_size = float(workpiece.voxel_size()),
                          .removal = config.removal,
                          .head_radius = float(tool.head().cutting_radius()),
                          .lead = float(lead),
                          .elapsed = float(evaluated)};
  const Vec3 ripple = path_W.linear - mean_of(mean_velocity, path_W.linear, end);
  sub_step.head.motion.ripple = (sub_step.X_WT.rotation.transpose() * ripple).cast<float>();
  set_spin(sub_step.head);
  return sub_step;
}

std::span<const FoundBlock> Simulation::State::find_blocks(const SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::find_blocks);
  return contact_stages.find_blocks(sub_step.head);
}

Encounter Simulation::State::press_and_cut(std::span<const FoundBlock> blocks, const SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::press_and_cut);
  note_touches(blocks, sub_step);
  Encounter encounter = contact_stages.press_and_cut(blocks, sub_step.head, removal);
  if (motor.stalled()) book_stalled(sub_step, encounter);
  crushing_depth = crushing_depth_in(sub_step, encounter);
  return encounter;
}

void Simulation::State::remove_emptied() noexcept {
  const StageTimer timer = timed(&StageTimes::remove_emptied);
  contact_stages.remove_emptied(removal);
}

/// Keeps a ball beyond its radius from popping through.
void Simulation::State::hold_deep_contact(const SubStep& sub_step, Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::hold_deep_contact);
  const DeepContact::Outcome outcome = hold(sub_step, encounter, deep_contact);
  encounter.resultant.wrench_T.force += sub_step.X_WT.rotation.transpose() * outcome.force;
  encounter.energies.elastic_before += outcome.stored_before;
  encounter.energies.elastic += outcome.stored;
  encounter.energies.released += outcome.released;
}

DeepContact::Outcome Simulation::State::hold(const SubStep& sub_step, const Encounter& encounter,
                                             DeepContact& deep) noexcept {
  const auto* ball = std::get_if<SphereHead>(&tool.head().shape());
  if (ball == nullptr || !config.deep_contact || !config.law->holds_deep_contact()) return {};
  const double filled = encounter.resultant.volume * voxel_volume / tool.head().volume();
  const Mat3& R_WT = sub_step.X_WT.rotation;
  // The force of a spinning ball also has a part along its surface. Its normal part costs a second evaluation.
  const bool needs_normal_force = sub_step.head.motion.spin != 0 && deep.needs_normal_force(filled);
  const Vec3 normal_T = needs_normal_force ? contact_stages.press_standing(sub_step.head).resultant.wrench_T.force
                                           : encounter.resultant.wrench_T.force;
  const Vec3 path = sub_step.duration * (R_WT * sub_step.path_T.linear);
  const double lead = double(sub_step.head.motion.lead);
  const Vec3 from = sub_step.X_WT.translation - (0.5 + lead) * path;
  return deep.move(from, from + path, filled, R_WT * normal_T, ball->radius);
}

void Simulation::State::book_energy(const SubStep& sub_step, const Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::book_energy);
  const Wrench& wrench_T = encounter.resultant.wrench_T;
  EnergyLedger& energy = result.energy;
  const double by_hand =
      (wrench_T.force.dot(sub_step.path_T.linear) + wrench_T.torque.dot(sub_step.path_T.angular)) * sub_step.duration;
  const double by_motor = wrench_T.torque.z() * motor.speed() * sub_step.duration;
  double entered = encounter.energies.elastic_before - energy.elastic, damped = encounter.energies.damping;
  const bool at_end = config.contact_time == ContactTime::end;
  // Material that the surface reaches without pressing it is crushed without work.
  const double unpaid = std::clamp(entered - (at_end ? damped : 0), 0.0, encounter.energies.crushed);
  entered -= unpaid;
  double released = encounter.energies.released;
  if (!at_end && encounter.energies.crushed > 0) {  // beyond what entered before, it is that of the crushed material
    const double left = std::min(0.0, entered + std::max(0.0, energy.entered));
    released -= left;
    entered -= left;
  }
  if (at_end) {
    // The forces of the end do more work than springs store: the work that no other term accounts for was damped.
    const double lost = damped - entered;
    damped = std::max(0.0, lost), entered = std::max(0.0, -lost);
  }
  energy.hand_work -= by_hand;
  energy.motor_work -= by_motor;
  energy.entered += entered;
  energy.turnover += std::abs(by_hand) + std::abs(by_motor) + std::abs(entered);
  energy.elastic = encounter.energies.elastic;
  energy.cutting += encounter.energies.cutting;
  energy.crushed += encounter.energies.crushed - unpaid;
  energy.released += released;
  energy.damping += damped;
  energy.rubbing += encounter.energies.rubbing;
  energy.credited += encounter.energies.credited;
}

void Simulation::State::transport_to_handle(const SubStep& sub_step, const Encounter& encounter,
                                            double weight) noexcept {
  const StageTimer timer = timed(&StageTimes::transport_to_handle);
  const Mat3& R_WT = sub_step.X_WT.rotation;
  const Wrench& wrench_T = encounter.resultant.wrench_T;
  const Wrench at_head = {R_WT * wrench_T.force, R_WT * wrench_T.torque};
  const Wrench at_handle = transport(at_head, sub_step.X_WT.translation - sub_step.X_WH.translation);
  result.model.force += weight * at_handle.force;
  if (config.handle_torque == HandleTorque::full_wrench) {
    result.model.torque += weight * at_handle.torque;
  } else {
    const Mat3& R_WH = sub_step.X_WH.rotation;
    result.model.torque += weight * R_WH *
                           thesis_handle_torque(tool.handle(), R_WH.transpose() * at_head.force, wrench_T.torque.z(),
                                                config.handle_torque_scale);
  }

  result.spindle.torque -= weight * wrench_T.torque.z();
  result.spindle.speed = motor.speed();
  result.contact = contact_of(sub_step, encounter);
  const bool could_cut = config.removal != RemovalLaw::none && encounter.resultant.voxels > 0;
  if (could_cut && tool.spindle().speed == 0 && motor.setting() == 0 && !held)
    result.status |= StepStatus::spindle_stands;
  if (could_cut && result.spindle.speed != 0 && other_cutter) result.status |= StepStatus::other_cutter;
  if (const LawEnergies& e = encounter.energies; e.crushed > kMuchCrushed * (e.crushed + std::max(0.0, e.cutting)))
    result.status |= StepStatus::material_crushed;
  if (encounter.blocks_exhausted) result.status |= StepStatus::blocks_exhausted;
  if (encounter.force_not_finite) result.status |= StepStatus::force_not_finite;
  if (encounter.level_of_detail > 1) result.status |= StepStatus::detail_reduced;
  if (config.removal != RemovalLaw::none && config.law->is_foundation() &&
      encounter.engaged_layer() > kThickLayer * tool.head().cutting_radius())
    result.status |= StepStatus::engaged_layer_thick;
  if (config.removal != RemovalLaw::none && contact_stages.is_point_thin(encounter.resultant))
    result.status |= StepStatus::point_thin;
}

/// The contact: its size, and its point, normal and pressure by the normal forces alone.
Contact Simulation::State::contact_of(const SubStep& sub_step, const Encounter& encounter) const noexcept {
  const Resultant& resultant = encounter.resultant;
  Contact contact;
  contact.voxels = resultant.voxels;
  contact.volume = resultant.volume * voxel_volume;
  contact.depth = resultant.depth;
  contact.level_of_detail = encounter.level_of_detail;
  if (!(resultant.normal_force > 0)) return contact;
  contact.point_W = sub_step.X_WT * Vec3(resultant.moment_T / resultant.normal_force);
  if (const double push = resultant.push_T.norm(); push > kCancelled * resultant.normal_force)
    contact.normal_W = sub_step.X_WT.rotation * resultant.push_T / push;
  contact.area = resultant.area * std::pow(workpiece.voxel_size(), 2);
  if (contact.area > 0) contact.pressure = resultant.normal_force / contact.area;
  return contact;
}

/// Computes the output to the hand: the wrench of the model or of the coupling, with effects, within the limits.
void Simulation::State::give_output(HandCoupling* coupling) noexcept {
  const StageTimer timer = timed(&StageTimes::give_output);
  HandOutput from = {input.X_WH, result.model, input.dt};
  if (coupling != nullptr) {
    const std::optional<HandOutput> answer = coupling->answer(result);
    if (answer) output_path = OutputPath::coupled, hand = from = *answer;
  }
  if (output_path != OutputPath::kept) {
    const Effects& effects = config.effects;
    const EffectsInput at = {from.X_WD,
                             from.X_WD * tool.X_HT(),
                             result.spindle.speed != 0 && result.contact.voxels > 0,
                             result.spindle.torque * result.spindle.speed,
                             from.dt,
                             lever_at_handle(config.handle_torque, tool.handle(), config.handle_torque_scale)};
    (void)output.give(effects, at, from.wrench);
    if (effects.vibration && at.touching && effects.vibration->frequency * from.dt >= kMaxVibration)
      result.status |= StepStatus::vibration_left_out;
  }
  result.force = output.given().force;
  result.torque = output.given().torque;
}

void Simulation::release_hand() noexcept {
  state_->output.restart();
  state_->hand_released_since = true;
  state_->result.force = state_->result.torque = Vec3::Zero();
}

void Simulation::State::finish_step(int sub_steps, const Twist& path) noexcept {
  last_X_WH = input.X_WH;
  const Vec3 velocity = transport(path, last_X_WH.rotation * tool.X_HT().translation).linear;
  mean_velocity = mean_of(mean_velocity, velocity, input.dt);
  result.sub_steps = sub_steps;
  result.removed_voxels = removal.voxels();
  result.removed_volume = removal.volume();
  if (removal.overflowed()) result.status |= StepStatus::removed_list_full;
  if (4 * workpiece.reserved_blocks() <= config.reserved_blocks) result.status |= StepStatus::blocks_low;
}

/// Ends a step that is not taken.
void Simulation::State::reject(StepStatus status) noexcept {
  result.status = status;
  output.drop();
  result.force = result.torque = Vec3::Zero();
}

}  // namespace hapticut
