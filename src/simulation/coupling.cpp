// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/coupling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/reserve.hpp"

namespace hapticut {
namespace {

constexpr double kSolved = 1e-4;  // [voxels] a correction that moves no point of the head farther ends the iteration

}  // namespace

void validate(const CouplingGains& gains) {
  require_positive(gains.mass, "CouplingGains::mass [kg]");
  require_positive(gains.stiffness, "CouplingGains::stiffness [N/m]");
  require_between(gains.damping, 0, 1e6, "CouplingGains::damping [N·s/m]");
  if (!(gains.largest_force > 0))
    throw Error("CouplingGains::largest_force = " + format_number(gains.largest_force) +
                " N; must be positive. Leave it infinite for a device without a limit.");
  require_between(gains.angular_stiffness, 0, 1e6, "CouplingGains::angular_stiffness [N·m/rad]");
  require_between(gains.angular_damping, 0, 1e6, "CouplingGains::angular_damping [N·m·s/rad]");
  require_positive(gains.inertia, "CouplingGains::inertia [kg·m^2]");
  require_between(gains.newton_steps, 1, 10, "CouplingGains::newton_steps");
}

CouplingGains coupling_gains(const DeviceCapabilities& device, double mass) {
  if (!(device.stiffness > 0))
    throw Error("the device " + device.model +
                " promises no stiffness, so no coupling can be chosen for it; set CouplingGains yourself.");
  CouplingGains gains;
  gains.mass = mass;
  gains.stiffness = device.stiffness;
  gains.damping = 2 * std::sqrt(gains.stiffness * mass);
  if (device.damping > 0) gains.damping = std::min(gains.damping, device.damping);
  if (device.peak_force > 0) gains.largest_force = device.peak_force;
  if (device.output_degrees_of_freedom == 6 && device.rotational_stiffness > 0) {
    gains.angular_stiffness = device.rotational_stiffness;
    gains.angular_damping = 2 * std::sqrt(gains.angular_stiffness * gains.inertia);
  }
  validate(gains);
  return gains;
}

VirtualCoupling::VirtualCoupling(Simulation& simulation, const CouplingGains& gains)
    : simulation_(&simulation), gains_(gains), lists_(simulation.worst_case(), simulation.config()) {
  validate(gains);
  if (simulation.config().contact_time != ContactTime::end)
    throw Error(
        "the simulation evaluates contact in the middle of a step, where an implicit coupling would swing. Make it "
        "with "
        "SimulationConfig::contact_time = ContactTime::end.");
}

VirtualCoupling::Lists::Lists(const WorstCase& worst_case, const SimulationConfig& config) {
  const std::size_t capacity = config.removed_voxel_capacity;
  reserve_touched(removed, capacity > 0 ? capacity : worst_case.voxels * 2);
  reserve_touched(changed, worst_case.blocks * kMostParts);
}

void VirtualCoupling::exchange_lists(Lists& lists) noexcept {
  release();
  begin_tick();  // nothing refers to the old lists any more
  std::swap(lists_, lists);
}

/// What the hand is given for a part of a tick: the coupling's wrench at its end, after the last one.
class VirtualCoupling::Answer final : public HandCoupling {
 public:
  Answer(VirtualCoupling& coupling, const Part& part, const Pose& X_WH, const Twist& tool, const Twist& hand)
      : coupling_(coupling), part_(part), after_(coupling.pull(X_WH, tool, part.X_WD, hand)) {}

  std::optional<HandOutput> answer(const StepResult& stepped) noexcept override {
    Wrench& wrench = coupling_.result_.coupling;
    wrench = {-after_.wrench.force, coupling_.turns() ? Vec3(-after_.wrench.torque) : stepped.model.torque};
    if (!part_.last) return std::nullopt;
    return HandOutput{part_.X_WD, wrench, part_.tick};
  }

  [[nodiscard]] const Pull& after() const { return after_; }

 private:
  VirtualCoupling& coupling_;
  const Part& part_;
  Pull after_;
};

const CoupledResult& VirtualCoupling::step(const Pose& hand_pose, const Twist& hand_velocity, double dt) noexcept {
  // Copies, because they may be parts of the last result, which changes.
  const Pose pose = hand_pose;           // NOLINT(performance-unnecessary-copy-initialization)
  const Twist velocity = hand_velocity;  // NOLINT(performance-unnecessary-copy-initialization)
  begin_tick();
  const StepStatus refused = check_input(simulation_->config(), pose, velocity, dt);
  if (refused != StepStatus::ok) return let_go(refused);
  if (!std::exchange(held_, true)) {
    X_WD_ = result_.X_WH = advance(pose, velocity, -dt);
    result_.velocity = velocity;
    result_.energy = {};  // of this grip; the hand brought the tool to its speed before it
    result_.energy.hand_work = result_.energy.kinetic = kinetic_energy(velocity);
    simulation_->let_go();
  }
  const Twist hand_path = twist_between(X_WD_, pose, dt);
  const Pose X_WD_before = X_WD_;
  result_.parts = plan_parts(dt);
  for (int part = 1; part <= result_.parts; ++part) {
    const Pose X_WD = part == result_.parts ? pose : advance(X_WD_before, hand_path, dt * part / result_.parts);
    const bool last = part == result_.parts;
    const StepStatus status = move({X_WD, dt / result_.parts, last, dt}, hand_path, velocity);
    if (has_any(status, kRejected)) return let_go(status);
    result_.status |= status;
  }
  result_.hand = {simulation_->last_result().force, simulation_->last_result().torque};
  return result_;
}

void VirtualCoupling::begin_tick() noexcept {
  lists_.removed.clear();
  lists_.changed.clear();
  result_.removed_voxels = {};
  result_.removed_volume = 0;
  result_.changed_blocks = {};
  result_.parts = result_.newton_steps = 0;
  result_.status = StepStatus::ok;
}

/// Number of equal parts in which no point of the head moves much farther than half a voxel.
int VirtualCoupling::plan_parts(double dt) const noexcept {
  constexpr double kMargin = 1.25;  // [1] for what the tool gains in speed
  const Tool& tool = simulation_->tool();
  const Vec3 p_HoTo_W = result_.X_WH.rotation * tool.X_HT().translation;
  const double speed =
      transport(result_.velocity, p_HoTo_W).linear.norm() + result_.velocity.angular.norm() * tool.head().reach();
  const double parts = std::ceil(kMargin * speed * dt / (0.5 * simulation_->workpiece().voxel_size()));
  return int(std::clamp(parts, 1.0, double(kMostParts)));
}

/// The hand moves on, the tool after it.
StepStatus VirtualCoupling::move(const Part& part, const Twist& hand_path, const Twist& hand) noexcept {
  const Twist tool_before = result_.velocity;
  const Pull before = pull(result_.X_WH, tool_before, X_WD_, hand);
  const Twist tool = solve(part.X_WD, hand, part.dt);
  Pose X_WH = advance(result_.X_WH, tool, part.dt);
  if (!turns()) X_WH.rotation = part.X_WD.rotation;
  const double work_before = simulation_->last_result().energy.hand_work;
  Answer answer(*this, part, X_WH, tool, hand);
  const StepResult& stepped = simulation_->step(X_WH, tool, part.dt, &answer);
  if (has_any(stepped.status, kRejected)) return stepped.status;
  keep_lists(stepped);

  result_.X_WH = X_WH;
  result_.velocity = tool;
  book(before, answer.after(), tool_before, hand_path, hand, stepped.energy.hand_work - work_before, part.dt);
  X_WD_ = part.X_WD;
  return stepped.status;
}

/// What the parts of a tick have changed, together.
void VirtualCoupling::keep_lists(const StepResult& stepped) noexcept {
  result_.removed_volume += stepped.removed_volume;
  for (const RemovedVoxel& voxel : stepped.removed_voxels) {
    if (lists_.removed.size() == lists_.removed.capacity()) {
      result_.status |= StepStatus::removed_list_full;
      break;
    }
    lists_.removed.push_back(voxel);
  }
  const ChangedBlocks changed = simulation_->changed_blocks();
  const bool all = lists_.changed.size() + changed.origins.size() <= lists_.changed.capacity();
  if (all) lists_.changed.insert(lists_.changed.end(), changed.origins.begin(), changed.origins.end());
  result_.changed_blocks.complete = result_.changed_blocks.complete && changed.complete && all;
  result_.removed_voxels = lists_.removed;
  result_.changed_blocks.origins = lists_.changed;
}

VirtualCoupling::Pull VirtualCoupling::pull(const Pose& X_WH, const Twist& tool, const Pose& X_WD,
                                            const Twist& hand) const noexcept {
  Pull p;
  p.stretch = X_WD.translation - X_WH.translation;
  p.turn = turns() ? vector_from_rotation(X_WD.rotation * X_WH.rotation.transpose()) : Vec3(Vec3::Zero());
  const double length = p.stretch.norm();
  p.stiffness = gains_.stiffness * length > gains_.largest_force ? gains_.largest_force / length : gains_.stiffness;
  p.wrench.force = p.stiffness * p.stretch + gains_.damping * (hand.linear - tool.linear);
  p.wrench.torque = gains_.angular_stiffness * p.turn + gains_.angular_damping * (hand.angular - tool.angular);
  return p;
}

/// The twist of the tool at the end of the tick, with which all forces are in balance.
Twist VirtualCoupling::solve(const Pose& pose, const Twist& hand, double dt) noexcept {
  const Twist before = result_.velocity;
  Twist tool = before;
  const Twist hand_path = twist_between(result_.X_WH, pose, dt);
  if (!turns()) tool.angular = hand_path.angular;
  const double reach = simulation_->tool().head().reach() + simulation_->tool().X_HT().translation.norm();
  const double solved = kSolved * simulation_->workpiece().voxel_size() / dt;  // [m/s]
  Vec3 last = Vec3::Zero();                                                    // correction
  bool slid = false, from_rest = false;

  for (int n = 0; n < gains_.newton_steps; ++n) {
    ++result_.newton_steps;
    Pose X_WH = advance(result_.X_WH, tool, dt);
    if (!turns()) X_WH.rotation = pose.rotation;
    const ContactProbe contact =
        simulation_->probe(X_WH, tool, dt, turns() ? ProbedMotions::all : ProbedMotions::translations);
    const Pull p = pull(X_WH, tool, pose, hand);

    Stiffness a = dt * contact.stiffness;
    a.diagonal().head<3>().array() += gains_.mass / dt + gains_.damping + dt * p.stiffness;
    a.diagonal().tail<3>().array() += gains_.inertia / dt + gains_.angular_damping + dt * gains_.angular_stiffness;
    Vector6 lacking;
    lacking << contact.wrench.force + p.wrench.force - gains_.mass / dt * (tool.linear - before.linear),
        contact.wrench.torque + p.wrench.torque - gains_.inertia / dt * (tool.angular - before.angular);
    Vec3 linear, angular = Vec3::Zero();
    if (turns()) {
      const Vector6 correction = a.ldlt().solve(lacking);
      linear = correction.head<3>();
      angular = correction.tail<3>();
    } else {
      linear = Mat3(a.topLeftCorner<3, 3>()).ldlt().solve(Vec3(lacking.head<3>()));
    }
    if (slid && contact.sliding && !from_rest && linear.dot(last) < -0.5 * last.squaredNorm()) {
      // To and fro between sliding one way and the other: the head sticks, or nearly so, and that is found from rest.
      from_rest = true;
      tool.linear.setZero();
      if (turns()) tool.angular.setZero();
      last.setZero();
      continue;
    }
    tool.linear += linear;
    tool.angular += angular;
    last = linear;
    slid = contact.sliding;
    if (linear.norm() + angular.norm() * reach < solved) break;
  }
  return tool;
}

double VirtualCoupling::kinetic_energy(const Twist& tool) const noexcept {
  const double turning = turns() ? 0.5 * gains_.inertia * tool.angular.squaredNorm() : 0.0;
  return 0.5 * gains_.mass * tool.linear.squaredNorm() + turning;
}

double VirtualCoupling::spring_energy(const Pull& p) const noexcept {
  const double length = p.stretch.norm(), full = gains_.largest_force / gains_.stiffness;
  const double linear =
      length > full ? gains_.largest_force * (length - 0.5 * full) : 0.5 * gains_.stiffness * length * length;
  return linear + 0.5 * gains_.angular_stiffness * p.turn.squaredNorm();
}

void VirtualCoupling::book(const Pull& before, const Pull& after, const Twist& tool_before, const Twist& hand_path,
                           const Twist& hand, double tool_work, double dt) noexcept {
  CouplingEnergy& energy = result_.energy;
  const Twist& tool = result_.velocity;
  const Wrench& w = after.wrench;
  const Vec3 torque = turns() ? w.torque : Vec3(-result_.coupling.torque);
  energy.hand_work += (w.force.dot(hand_path.linear) + torque.dot(hand_path.angular)) * dt;
  energy.tool_work += tool_work;
  energy.damper += gains_.damping * (hand.linear - tool.linear).dot(hand_path.linear - tool.linear) * dt;
  const double mass_loss = 0.5 * gains_.mass * (tool.linear - tool_before.linear).squaredNorm();
  energy.kinetic = kinetic_energy(tool);
  // What the spring's end force does on the way, less what it stores more.
  const Vec3 stretched = after.stretch - before.stretch;
  double spring_loss = after.stiffness * after.stretch.dot(stretched);
  if (turns()) {
    const Vec3 turning = (hand_path.angular - tool.angular) * dt;
    energy.damper += gains_.angular_damping * (hand.angular - tool.angular).dot(turning);
    spring_loss += gains_.angular_stiffness * after.turn.dot(turning);
    energy.implicit += 0.5 * gains_.inertia * (tool.angular - tool_before.angular).squaredNorm();
  }
  const double stored = spring_energy(after);
  energy.implicit += mass_loss + spring_loss - (stored - spring_energy(before));
  energy.spring = stored;
}

const CoupledResult& VirtualCoupling::let_go(StepStatus status) noexcept {
  held_ = false;
  simulation_->let_go();
  result_.hand = result_.coupling = {};
  result_.velocity = {};
  result_.status |= status;
  return result_;
}

}  // namespace hapticut
