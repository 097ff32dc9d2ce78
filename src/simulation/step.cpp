// SPDX-License-Identifier: Apache-2.0
// The step, stage by stage.
#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/hand_motion.hpp"
#include "simulation/simulation_state.hpp"
#include "simulation/status_limits.hpp"

namespace hapticut {
namespace {

constexpr double kRotationTolerance = 1e-3;  // [1] above the error of matrices from devices
constexpr double kMaxSpeed = 1e6;            // [m/s], [rad/s] above any hand's velocity
constexpr double kThickLayer = 0.1;          // [1] engaged layer over the head's radius

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
  hand.path = coupling == nullptr ? OutputPath::direct : OutputPath::kept;
  if (const StepStatus rejected = check_step_input(); rejected != StepStatus::ok) {
    motion.reject_input();
    return reject(rejected);
  }
  if (const StepStatus rejected = find_start(coupling != nullptr); rejected != StepStatus::ok) return reject(rejected);
  const Pose& from = motion.X_WH();
  const HandlePath path = {from, twist_between(from, X_WH, dt), V_WH, dt, plan_sweep(from, X_WH)};
  take_sub_steps(path, springs, nullptr);
  give_output(coupling);
  finish_step(path);
}

/// The stages of each sub-step. A probe has the same, except those that change workpiece, motor or ledger, and
/// except `transport_to_handle`, because it adds the wrench itself.
/// @param acting  springs that the head moves: those of the simulation, or a copy for a probe
/// @param probe   to add to; null in a step
void Simulation::State::take_sub_steps(const HandlePath& path, Springs& acting, ContactProbe* probe) noexcept {
  const bool acts = probe == nullptr;
  for (int i = 0; i < path.sweep.count(); ++i) {
    SubStep sub_step = plan_sub_step(path, i);
    const std::span<const FoundBlock> blocks = find_blocks(sub_step);
    if (acts) drive_spindle(blocks, sub_step);
    Encounter encounter = press_and_cut(blocks, sub_step, acts);
    if (acts) remove_emptied();
    tether_deep_ball(sub_step, encounter, acting.deep);
    add_friction(sub_step, encounter, acting.anchor);
    if (!acts) {
      add_to(*probe, sub_step, encounter, acting);
      probe->contact = contact_stages.contact_of(encounter, sub_step.X_WT);
      probe->blocks = int(blocks.size());
      continue;
    }
    book_energy(sub_step, encounter);
    transport_to_handle(sub_step, encounter);
    note_status(encounter);
    advance_spindle(sub_step, encounter);
  }
}

void Simulation::State::begin_step(const StepInput& given) noexcept {
  input = given;
  totals.begin_step();
  free_blocks = workpiece.reserved_blocks();
  hand.was_released = std::exchange(hand.released, false);
  spindle.begin_step();
  removal.clear();
  contact_stages.forget_changes();
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

SubStep Simulation::State::plan_sub_step(const HandlePath& path, int index) const noexcept {
  const StageTimer timer = timed(&StageTimes::plan_sub_step);
  const double end = path.sweep.end(index) * path.dt, duration = path.sweep.duration(index) * path.dt;  // [s]
  const double lead = config.contact_time == ContactTime::end ? 0.5 : 0.0, evaluated = end - (0.5 - lead) * duration;
  SubStep sub_step;
  sub_step.duration = duration;
  sub_step.end = path.sweep.end(index);
  sub_step.weight = path.sweep.weight(index, config.contact_time);
  sub_step.X_WH = advance(path.from, path.twist, evaluated);
  sub_step.X_WT = sub_step.X_WH * tool.X_HT();
  // The path leads from the beginning to the end, so its lever is that of the middle.
  const Mat3 R_WH = lead > 0 ? advance(path.from, path.twist, end - 0.5 * duration).rotation : sub_step.X_WH.rotation;
  const Twist path_W = transport(path.twist, Vec3(R_WH * tool.X_HT().translation));
  sub_step.path_T = expressed_in(sub_step.X_WT, path_W);
  const Twist felt_T = expressed_in(sub_step.X_WT, transport(path.felt, sub_step.p_HoTo_W()));
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
  const Vec3 ripple = path_W.linear - motion.mean_with(path_W.linear, end);
  sub_step.head.motion.ripple = (sub_step.X_WT.rotation.transpose() * ripple).cast<float>();
  set_spin(sub_step.head);
  return sub_step;
}

std::span<const FoundBlock> Simulation::State::find_blocks(const SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::find_blocks);
  return contact_stages.find_blocks(sub_step.head);
}

/// @param cuts  false: no block is changed, and the stiffness is known as well
Encounter Simulation::State::press_and_cut(std::span<const FoundBlock> blocks, const SubStep& sub_step,
                                           bool cuts) noexcept {
  const StageTimer timer = timed(&StageTimes::press_and_cut);
  if (!cuts) return contact_stages.probe(blocks, sub_step.head, ContactStages::Asked::stiffness);
  totals.note_touches(contact_stages.find_touched(blocks, sub_step.head, totals.touched));
  Encounter encounter = contact_stages.press_and_cut(blocks, sub_step.head, removal);
  if (spindle.motor().stalled()) book_stalled(sub_step, encounter);
  crushing_depth = contact_stages.rim_crushing_depth(encounter.resultant, sub_step.head.motion);
  return encounter;
}

void Simulation::State::remove_emptied() noexcept {
  const StageTimer timer = timed(&StageTimes::remove_emptied);
  contact_stages.remove_emptied(removal);
}

/// Tethers a ball that is deeper than its radius, so that it does not pop through.
void Simulation::State::tether_deep_ball(const SubStep& sub_step, Encounter& encounter, DeepContact& deep) noexcept {
  const StageTimer timer = timed(&StageTimes::tether_deep_ball);
  const DeepContact::Pull pull = tether(sub_step, encounter, deep);
  encounter.resultant.wrench_T.force += sub_step.X_WT.rotation.transpose() * pull.force;
  encounter.energies.elastic_before += pull.stored_before;
  encounter.energies.elastic += pull.stored;
  encounter.energies.released += pull.released;
}

DeepContact::Pull Simulation::State::tether(const SubStep& sub_step, const Encounter& encounter,
                                            DeepContact& deep) noexcept {
  const SphereHead* ball = tool.head().ball();
  if (ball == nullptr || !config.deep_contact || !config.law->tethers_deep_ball()) return {};
  const double filled = encounter.resultant.volume * contact_stages.voxel_volume() / tool.head().volume();
  const Mat3& R_WT = sub_step.X_WT.rotation;
  // The force of a spinning ball also has a part along its surface. Its normal part costs a second evaluation.
  const bool needs_normal_force = sub_step.head.motion.spin != 0 && deep.needs_normal_force(filled);
  const Vec3 normal_T = needs_normal_force ? contact_stages.standing_contact(sub_step.head).resultant.wrench_T.force
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
  const double by_motor = wrench_T.torque.z() * spindle.motor().speed() * sub_step.duration;
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
  energy.motor_work += encounter.stall_work;
  energy.turnover += std::abs(encounter.stall_work);
  energy.anchored = springs.anchor.stored();
  energy.sliding += encounter.dry_friction.dissipated;
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

void Simulation::State::transport_to_handle(const SubStep& sub_step, const Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::transport_to_handle);
  const double weight = sub_step.weight;
  const Wrench& wrench_T = encounter.resultant.wrench_T;
  const Wrench at_handle = sub_step.at_handle(wrench_T);
  result.model.force += weight * at_handle.force;
  if (config.handle_torque == HandleTorque::full_wrench) {
    result.model.torque += weight * at_handle.torque;
  } else {
    const Mat3& R_WH = sub_step.X_WH.rotation;
    result.model.torque += weight * R_WH *
                           thesis_handle_torque(tool.handle(), R_WH.transpose() * at_handle.force, wrench_T.torque.z(),
                                                config.handle_torque_scale);
  }

  result.spindle.torque -= weight * wrench_T.torque.z();
  result.spindle.speed = spindle.motor().speed();
  result.contact = contact_stages.contact_of(encounter, sub_step.X_WT);
}

/// [N] Contact::load_to_cut: of several materials the mean, by the force on each.
double Simulation::State::load_to_cut() const noexcept {
  double load = 0, pressed = 0;
  for (int id = 1; id <= workpiece.materials().size(); ++id) {
    const Material& m = *workpiece.materials().find(MaterialId(id));
    const double force = contact_stages.pressed()[std::size_t(id)];
    pressed += force;
    load += force * load_of_edges(m, tool);
  }
  return pressed > 0 ? load / pressed : 0;
}

/// Sets the status bits that a sub-step shows.
void Simulation::State::note_status(const Encounter& encounter) noexcept {
  const bool could_cut = config.removal != RemovalLaw::none && encounter.resultant.voxels > 0;
  if (could_cut && tool.spindle().speed == 0 && spindle.motor().setting() == 0 && !spindle.is_held())
    result.status |= StepStatus::spindle_stands;
  if (could_cut && result.spindle.speed != 0 && other_cutter) result.status |= StepStatus::other_cutter;
  if (const LawEnergies& e = encounter.energies; e.crushed > kMuchCrushed * (e.crushed + std::max(0.0, e.cutting)))
    result.status |= StepStatus::material_crushed;
  if (tool.cutter().kind == CutterKind::twist_drill && could_cut) {
    result.contact.load_to_cut = load_to_cut();
    if (const LawEnergies& e = encounter.energies;
        result.contact.load_to_cut > 0 && e.rubbing > 0 && e.cutting < kHardlyCut * e.rubbing)
      result.status |= StepStatus::edges_carry_load;
  }
  if (encounter.blocks_exhausted) result.status |= StepStatus::blocks_exhausted;
  if (encounter.force_not_finite) result.status |= StepStatus::force_not_finite;
  if (encounter.level_of_detail > 1) result.status |= StepStatus::detail_reduced;
  if (config.removal != RemovalLaw::none && config.law->is_foundation() &&
      encounter.engaged_layer() > kThickLayer * tool.head().cutting_radius())
    result.status |= StepStatus::engaged_layer_thick;
  if (config.removal != RemovalLaw::none && contact_stages.is_point_thin(encounter.resultant))
    result.status |= StepStatus::point_thin;
}

/// Computes the output to the hand: the wrench of the model or of the coupling, with effects, within the limits.
void Simulation::State::give_output(HandCoupling* coupling) noexcept {
  const StageTimer timer = timed(&StageTimes::give_output);
  HandOutput from = {input.X_WH, result.model, input.dt};
  if (coupling != nullptr) {
    const std::optional<HandOutput> answer = coupling->answer(result);
    if (answer) hand.path = OutputPath::coupled, hand.coupled = from = *answer;
  }
  if (hand.path != OutputPath::kept) {
    const Effects& effects = config.effects;
    const EffectsInput at = {from.X_WD,
                             from.X_WD * tool.X_HT(),
                             result.spindle.speed != 0 && result.contact.voxels > 0,
                             result.spindle.torque * result.spindle.speed,
                             from.dt,
                             lever_at_handle(config.handle_torque, tool.handle(), config.handle_torque_scale),
                             result.spindle.speed * from.dt,
                             lips_of(tool.cutter())};
    (void)hand.output.give(effects, at, from.wrench);
    if (effects.vibration && at.touching && effects.vibration->frequency * from.dt >= kMaxVibration)
      result.status |= StepStatus::vibration_left_out;
  }
  result.force = hand.output.given().force;
  result.torque = hand.output.given().torque;
}

void Simulation::release_hand() noexcept {
  state_->hand.output.restart();
  state_->hand.released = true;
  state_->result.force = state_->result.torque = Vec3::Zero();
}

void Simulation::State::finish_step(const HandlePath& path) noexcept {
  const Vec3 velocity = transport(path.twist, input.X_WH.rotation * tool.X_HT().translation).linear;
  motion.arrive_at(input.X_WH, velocity, input.dt);
  result.sub_steps = path.sweep.count();
  result.removed_voxels = removal.voxels();
  result.removed_volume = removal.volume();
  if (removal.overflowed()) result.status |= StepStatus::removed_list_full;
  if (4 * workpiece.reserved_blocks() <= config.reserved_blocks) result.status |= StepStatus::blocks_low;
}

/// Ends a step that is not taken.
void Simulation::State::reject(StepStatus status) noexcept {
  result.status = status;
  hand.output.drop();
  result.force = result.torque = Vec3::Zero();
}

}  // namespace hapticut
