// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/contact_point.hpp"
#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/friction.hpp"
#include "simulation/contact_stages.hpp"
#include "simulation/stage_timer.hpp"

namespace hapticut {
namespace {

constexpr double kRotationTolerance = 1e-3;  // [1] what device matrices are off by is below this
constexpr double kThickLayer = 0.1;          // [1] of the head's radius

void validate_pair(const Workpiece& workpiece, const Tool& tool) {
  if (workpiece.empty())
    throw Error("the workpiece is empty; check the threshold, crop box or labels that it was built from.");
  const HeadBox box = tool.head().bounding_box();
  const double thinnest = (box.max - box.min).minCoeff();
  if (thinnest < workpiece.voxel_size())
    throw Error("the head is " + format_number(thinnest * 1e3) + " mm thin, less than a voxel of " +
                format_number(workpiece.voxel_size() * 1e3) +
                " mm; it would slip between voxels. Choose smaller voxels.");
}

/// One equal part of the tool's motion during a step, seen at its middle.
struct SubStep {
  double duration;     // [s]
  Pose X_WH;           // of the handle
  Pose X_WT;           // of the head
  Twist path_T;        // of To along the path, in T
  HeadPlacement head;  // the same for the stages that see voxels
};

Twist expressed_in(const Pose& X_WT, const Twist& twist_W) {
  return {X_WT.rotation.transpose() * twist_W.linear, X_WT.rotation.transpose() * twist_W.angular};
}

}  // namespace

struct Simulation::State {
  State(Workpiece given_workpiece, Tool given_tool, SimulationConfig given_config);
  void prepare_workpiece();

  // The stages of a step, in their order.
  [[nodiscard]] StageTimer timed(double StageTimes::*stage) const noexcept {
    return StageTimer(config.stage_times ? &(times.*stage) : nullptr);
  }
  void begin_step() noexcept;
  [[nodiscard]] StepStatus check_input(const Pose& pose, const Twist& velocity, double dt) const noexcept;
  void place_at(const Pose& pose) noexcept;
  [[nodiscard]] int plan_sweep(const Pose& pose) const noexcept;
  [[nodiscard]] SubStep plan_sub_step(int index, double duration, const Twist& path, const Twist& felt) const noexcept;
  void find_blocks(const SubStep& sub_step) noexcept;
  [[nodiscard]] Encounter evaluate_contact(const SubStep& sub_step) noexcept;
  void remove_material() noexcept;
  void hold_deep_contact(const SubStep& sub_step, Encounter& encounter) noexcept;
  void add_friction(const SubStep& sub_step, Encounter& encounter) noexcept;
  [[nodiscard]] Wrench normal_wrench(const SubStep& sub_step) noexcept;
  [[nodiscard]] const DryFriction& friction_at(const Vec3& p_WQ) noexcept;
  void book_energy(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void transport_to_handle(const SubStep& sub_step, const Encounter& encounter, double share) noexcept;
  void add_effects(const Pose& pose, double dt) noexcept;
  const StepResult& finish_step(const Pose& pose, double dt, int sub_steps) noexcept;
  const StepResult& reject(StepStatus status) noexcept;

  Workpiece workpiece;
  Tool tool;
  SimulationConfig config;

  // Derived from them at set-up.
  ContactStages contact_stages;
  std::array<DryFriction, 256> frictions;  // of the materials, or of the configuration
  Pose X_VW;
  double voxel_volume = 0;  // [m^3]

  // What one step hands to the next.
  bool has_pose = false;
  Pose X_WH;  // at the end of the last accepted step
  SpindleMotor motor;
  double motor_torque = 0;   // [N·m] of the last sub-step, the load of the motor
  DeepContact deep_contact;  // in W
  StickSlip friction;        // in W
  Output output;
  MaterialId touched = 1;  // material at the contact point

  std::uint64_t steps = 0;
  std::uint64_t workpiece_exchanges = 0;

  RemovalRecord removal;
  StepResult result;
  mutable StageTimes times;
};

// --- the step
// -----------------------------------------------------------------------------------------------------------

const StepResult& Simulation::step(const Pose& pose, const Twist& velocity, double dt) noexcept {
  State& s = *state_;
  s.begin_step();
  const StepStatus refused = s.check_input(pose, velocity, dt);
  if (refused != StepStatus::ok) return s.reject(refused);
  if (!std::exchange(s.has_pose, true)) s.place_at(advance(pose, velocity, -dt));

  const int sub_steps = s.plan_sweep(pose);
  if (sub_steps > s.config.longest_sweep) {
    s.place_at(pose);
    return s.reject(StepStatus::jump_rejected);
  }
  const Twist path = twist_between(s.X_WH, pose, dt);
  for (int i = 0; i < sub_steps; ++i) {
    const SubStep sub_step = s.plan_sub_step(i, dt / sub_steps, path, velocity);
    s.find_blocks(sub_step);
    Encounter encounter = s.evaluate_contact(sub_step);
    s.remove_material();
    s.hold_deep_contact(sub_step, encounter);
    s.add_friction(sub_step, encounter);
    s.book_energy(sub_step, encounter);
    s.transport_to_handle(sub_step, encounter, 1.0 / sub_steps);
  }
  s.add_effects(pose, dt);
  return s.finish_step(pose, dt, sub_steps);
}

void Simulation::State::begin_step() noexcept {
  ++steps;
  removal.clear();
  contact_stages.forget_changes();
  times = {};
  result.force = result.torque = Vec3::Zero();
  result.model = {};
  result.removed_voxels = {};
  result.removed_volume = 0;
  result.contact = {};
  result.spindle = {};
  result.sub_steps = 0;
  result.status = StepStatus::ok;
}

StepStatus Simulation::State::check_input(const Pose& pose, const Twist& velocity, double dt) const noexcept {
  const StageTimer timer = timed(&StageTimes::check_input);
  StepStatus status = StepStatus::ok;
  if (!is_finite(pose) || !is_rotation(pose.rotation, kRotationTolerance)) status |= StepStatus::pose_rejected;
  if (!is_finite(velocity.linear) || !is_finite(velocity.angular)) status |= StepStatus::velocity_rejected;
  if (!(dt >= config.shortest_dt && dt <= config.longest_dt)) status |= StepStatus::dt_rejected;
  return status;
}

void Simulation::State::place_at(const Pose& pose) noexcept {
  result.energy.sliding += std::exchange(result.energy.anchored, 0);
  friction.release();
  deep_contact.release();
  output.restart();
  X_WH = pose;
}

/// Number of equal parts in which no point of the head moves farther than half a voxel.
int Simulation::State::plan_sweep(const Pose& pose) const noexcept {
  const StageTimer timer = timed(&StageTimes::plan_sweep);
  const Vec3 head_shift = pose * tool.X_HT().translation - X_WH * tool.X_HT().translation;
  const double turn = vector_from_rotation(pose.rotation * X_WH.rotation.transpose()).norm();
  const double farthest = head_shift.norm() + turn * tool.head().reach();
  const double parts = std::ceil(farthest / (0.5 * workpiece.voxel_size()) - 1e-9);
  return int(std::clamp(parts, 1.0, config.longest_sweep + 1.0));
}

SubStep Simulation::State::plan_sub_step(int index, double duration, const Twist& path,
                                         const Twist& felt) const noexcept {
  const StageTimer timer = timed(&StageTimes::plan_sub_step);
  SubStep sub_step;
  sub_step.duration = duration;
  sub_step.X_WH = advance(X_WH, path, (index + 0.5) * duration);
  sub_step.X_WT = sub_step.X_WH * tool.X_HT();
  const Vec3 p_HoTo_W = sub_step.X_WT.translation - sub_step.X_WH.translation;
  sub_step.path_T = expressed_in(sub_step.X_WT, transport(path, p_HoTo_W));
  const Twist felt_T = expressed_in(sub_step.X_WT, transport(felt, p_HoTo_W));
  sub_step.head.X_VT = X_VW * sub_step.X_WT;
  sub_step.head.motion = {sub_step.path_T.linear.cast<float>(),
                          sub_step.path_T.angular.cast<float>(),
                          felt_T.linear.cast<float>(),
                          felt_T.angular.cast<float>(),
                          float(motor.speed()),
                          float(duration),
                          float(workpiece.voxel_size()),
                          config.removal,
                          float(tool.head().largest_radius())};
  return sub_step;
}

void Simulation::State::find_blocks(const SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::find_blocks);
  contact_stages.find_blocks(workpiece, tool.head(), sub_step.head);
}

Encounter Simulation::State::evaluate_contact(const SubStep& sub_step) noexcept {
  const StageTimer timer = timed(&StageTimes::evaluate_contact);
  return contact_stages.evaluate_contact(workpiece, tool.head(), sub_step.head, removal);
}

void Simulation::State::remove_material() noexcept {
  const StageTimer timer = timed(&StageTimes::remove_material);
  contact_stages.remove_material(workpiece, removal);
}

/// Keeps a ball beyond its radius from popping through.
void Simulation::State::hold_deep_contact(const SubStep& sub_step, Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::hold_deep_contact);
  const auto* ball = std::get_if<SphereHead>(&tool.head().shape());
  if (ball == nullptr || !config.deep_contact) return;
  const double filled = encounter.resultant.volume * voxel_volume / tool.head().volume();
  const Mat3& R_WT = sub_step.X_WT.rotation;
  const Vec3 half_way = 0.5 * sub_step.duration * (R_WT * sub_step.path_T.linear);
  Wrench& wrench_T = encounter.resultant.wrench_T;
  const DeepContact::Outcome outcome =
      deep_contact.move(sub_step.X_WT.translation - half_way, sub_step.X_WT.translation + half_way, filled,
                        R_WT * wrench_T.force, ball->radius);
  wrench_T.force += R_WT.transpose() * outcome.force;
  encounter.energies.elastic_before += outcome.stored_before;
  encounter.energies.elastic += outcome.stored;
  encounter.energies.released += outcome.released;
}

/// Dry friction of a head that stands, or turns so slowly that the cutting ratio does not describe it alone.
void Simulation::State::add_friction(const SubStep& sub_step, Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::add_friction);
  const double share = standing_share(motor.speed(), tool.head().largest_radius());
  const bool touches = share > 0 && encounter.resultant.voxels > 0;
  Wrench normal_T;
  if (touches) normal_T = motor.speed() == 0 ? encounter.resultant.wrench_T : normal_wrench(sub_step);
  EnergyLedger& energy = result.energy;
  if (normal_T.force.isZero(0)) {
    energy.sliding += std::exchange(energy.anchored, 0);
    friction.release();
    return;
  }
  const Vec3 p_TQ = contact_point(tool.head(), normal_T);
  const Mat3& R_WT = sub_step.X_WT.rotation;
  const Vec3 turning = sub_step.path_T.angular + Vec3(0, 0, motor.speed());
  const Vec3 displacement = (sub_step.path_T.linear + turning.cross(p_TQ)) * sub_step.duration;
  const StickSlip::Outcome outcome =
      friction.move(R_WT * normal_T.force, R_WT * displacement, friction_at(sub_step.X_WT * p_TQ), share);
  const Vec3 force_T = R_WT.transpose() * outcome.force;
  encounter.resultant.wrench_T.force += force_T;
  encounter.resultant.wrench_T.torque += p_TQ.cross(force_T);
  energy.anchored = friction.stored();
  energy.sliding += outcome.dissipated;
}

/// What the head would feel at this place if it stood, without friction.
Wrench Simulation::State::normal_wrench(const SubStep& sub_step) noexcept {
  HeadPlacement standing = sub_step.head;
  standing.motion.spin = 0;
  standing.motion.removal = RemovalLaw::none;
  contact_stages.find_blocks(workpiece, tool.head(), standing);  // again, for some may be gone
  return contact_stages.evaluate_contact(workpiece, tool.head(), standing, removal).resultant.wrench_T;
}

/// The friction of the material nearest to a point; that of the last one touched where there is none nearby.
const DryFriction& Simulation::State::friction_at(const Vec3& p_WQ) noexcept {
  if (config.friction) return frictions[touched];  // the same everywhere
  const Vec3 p_VQ = X_VW * p_WQ / workpiece.voxel_size();
  const VoxelIndex center = {int(std::lround(p_VQ.x())), int(std::lround(p_VQ.y())), int(std::lround(p_VQ.z()))};
  if (const MaterialId id = workpiece.material_at(center); id != kEmpty) {
    touched = id;
    return frictions[touched];
  }
  double nearest = 9;  // [voxels^2]
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k) {
        const VoxelIndex index = {center[0] + i, center[1] + j, center[2] + k};
        const double distance = (Vec3(index[0], index[1], index[2]) - p_VQ).squaredNorm();
        if (distance >= nearest) continue;
        const MaterialId id = workpiece.material_at(index);
        if (id != kEmpty) touched = id, nearest = distance;
      }
  return frictions[touched];
}

void Simulation::State::book_energy(const SubStep& sub_step, const Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::book_energy);
  const Wrench& wrench_T = encounter.resultant.wrench_T;
  EnergyLedger& energy = result.energy;
  energy.hand_work -=
      (wrench_T.force.dot(sub_step.path_T.linear) + wrench_T.torque.dot(sub_step.path_T.angular)) * sub_step.duration;
  energy.motor_work -= wrench_T.torque.z() * motor.speed() * sub_step.duration;
  energy.entered += encounter.energies.elastic_before - energy.elastic;
  energy.elastic = encounter.energies.elastic;
  energy.cutting += encounter.energies.cutting;
  energy.released += encounter.energies.released;
  energy.damping += encounter.energies.damping;
  energy.rubbing += encounter.energies.rubbing;
  energy.credited += encounter.energies.credited;
}

void Simulation::State::transport_to_handle(const SubStep& sub_step, const Encounter& encounter,
                                            double share) noexcept {
  const StageTimer timer = timed(&StageTimes::transport_to_handle);
  const Mat3& R_WT = sub_step.X_WT.rotation;
  const Wrench& wrench_T = encounter.resultant.wrench_T;
  const Wrench at_head = {R_WT * wrench_T.force, R_WT * wrench_T.torque};
  const Wrench at_handle = transport(at_head, sub_step.X_WT.translation - sub_step.X_WH.translation);
  result.model.force += share * at_handle.force;
  if (config.handle_torque == HandleTorque::full_wrench) {
    result.model.torque += share * at_handle.torque;
  } else {
    const Mat3& R_WH = sub_step.X_WH.rotation;
    result.model.torque += share * R_WH *
                           thesis_handle_torque(tool.handle(), R_WH.transpose() * at_head.force, wrench_T.torque.z(),
                                                config.handle_torque_scale);
  }

  motor_torque = -wrench_T.torque.z();
  result.spindle.torque += share * motor_torque;
  result.contact = {encounter.resultant.voxels, encounter.resultant.volume * voxel_volume, encounter.resultant.depth};
  if (encounter.blocks_exhausted) result.status |= StepStatus::blocks_exhausted;
  if (encounter.level_of_detail > 1) result.status |= StepStatus::detail_reduced;
}

/// What the hand feels: the force of the model with what is added to it, within its limits.
void Simulation::State::add_effects(const Pose& pose, double dt) noexcept {
  const StageTimer timer = timed(&StageTimes::add_effects);
  const Effects& effects = config.effects;
  const EffectsInput at = {pose, pose * tool.X_HT(), motor.speed() != 0 && result.contact.voxels > 0,
                           result.spindle.torque * motor.speed(), dt};
  const Wrench wanted = output.add_effects(effects, at, result.model);
  const Wrench felt = output.limit(effects.limits, wanted, dt);
  result.force = felt.force;
  result.torque = felt.torque;
  if (effects.vibration && at.touching && effects.vibration->frequency * dt >= kFastestVibration)
    result.status |= StepStatus::vibration_left_out;
}

const StepResult& Simulation::State::finish_step(const Pose& pose, double dt, int sub_steps) noexcept {
  X_WH = pose;
  result.sub_steps = sub_steps;
  result.spindle.speed = motor.speed();
  result.removed_voxels = removal.voxels();
  result.removed_volume = removal.volume();
  if (removal.overflowed()) result.status |= StepStatus::removed_list_full;
  if (4 * workpiece.reserved_blocks() <= config.reserved_blocks) result.status |= StepStatus::blocks_low;
  if (removal.volume() > 0 && result.contact.depth > kThickLayer * tool.head().largest_radius())
    result.status |= StepStatus::engaged_layer_thick;

  if (motor.loaded()) result.status |= StepStatus::power_limited;
  motor.advance(motor_torque, dt);
  contact_stages.set_cutting_share(1 - standing_share(motor.speed(), tool.head().largest_radius()));
  return result;
}

const StepResult& Simulation::State::reject(StepStatus status) noexcept {
  result.status = status;
  output.drop();
  return result;
}

// --- set-up
// -------------------------------------------------------------------------------------------------------------

Simulation::State::State(Workpiece given_workpiece, Tool given_tool, SimulationConfig given_config)
    : workpiece(std::move(given_workpiece)),
      tool(std::move(given_tool)),
      config(std::move(given_config)),
      contact_stages(workpiece, tool.head(), config),
      motor(tool.spindle()),
      removal(config.removed_voxel_capacity > 0 ? config.removed_voxel_capacity
                                                : most_voxels(tool.head(), workpiece.voxel_size())) {
  prepare_workpiece();
}

void Simulation::State::prepare_workpiece() {
  workpiece.reserve_blocks(config.reserved_blocks);
  X_VW = workpiece.frame().X_WV.inverse();
  voxel_volume = std::pow(workpiece.voxel_size(), 3);
  for (std::size_t id = 0; id < frictions.size(); ++id) {
    if (!workpiece.materials().contains(MaterialId(id))) continue;
    const Material& m = workpiece.materials()[MaterialId(id)];
    frictions[id] =
        config.friction.value_or(DryFriction{m.static_friction, m.dynamic_friction, m.tangential_stiffness});
  }
  contact_stages.set_cutting_share(1 - standing_share(motor.speed(), tool.head().largest_radius()));
}

Simulation::Simulation(Workpiece workpiece, Tool tool, SimulationConfig config) {
  validate(config);
  validate_pair(workpiece, tool);
  if (config.law) config.law->require_head(tool.head());
  state_ = std::make_unique<State>(std::move(workpiece), std::move(tool), std::move(config));
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

const Workpiece& Simulation::workpiece() const { return state_->workpiece; }
const Tool& Simulation::tool() const { return state_->tool; }
const SimulationConfig& Simulation::config() const { return state_->config; }
const StepResult& Simulation::last_result() const { return state_->result; }

ChangedBlocks Simulation::changed_blocks() const noexcept { return state_->contact_stages.changed(); }
double Simulation::spindle_setting() const noexcept { return state_->motor.setting(); }
std::uint64_t Simulation::steps() const noexcept { return state_->steps; }
std::uint64_t Simulation::workpiece_exchanges() const noexcept { return state_->workpiece_exchanges; }

const std::array<double, 256>& Simulation::removed_volume_by_material() const {
  return state_->removal.total_by_material();
}

WorstCase Simulation::worst_case() const { return state_->contact_stages.worst_case(state_->config); }

const StageTimes& Simulation::stage_times() const { return state_->times; }

void Simulation::set_spindle_speed(double speed) {
  if (!std::isfinite(speed)) throw Error("spindle speed = " + format_number(speed) + " rad/s; must be finite.");
  state_->motor.set(speed);
  state_->contact_stages.set_cutting_share(1 -
                                           standing_share(state_->motor.speed(), state_->tool.head().largest_radius()));
}

void Simulation::set_effects(const Effects& effects) {
  validate(effects, state_->config.update_rate);
  state_->config.effects = effects;
}

void Simulation::reserve_blocks(std::size_t count) {
  state_->config.reserved_blocks = count;
  state_->workpiece.reserve_blocks(count);
}

WorkpieceSnapshot Simulation::snapshot() const { return state_->workpiece.snapshot(); }

void Simulation::restore(const WorkpieceSnapshot& snapshot) {
  state_->workpiece.restore(snapshot);
  state_->contact_stages.start_afresh(state_->workpiece);
  state_->has_pose = false;
  ++state_->workpiece_exchanges;
}

void Simulation::reset(Workpiece workpiece) {
  validate_pair(workpiece, state_->tool);
  const std::uint64_t exchanges = state_->workpiece_exchanges;
  state_ = std::make_unique<State>(std::move(workpiece), state_->tool, state_->config);
  state_->workpiece_exchanges = exchanges + 1;
}

}  // namespace hapticut
