// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/coupling.hpp"

#include <algorithm>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/reserve.hpp"
#include "simulation/hand_motion.hpp"
#include "simulation/newton_search.hpp"
#include "simulation/removed_list.hpp"

namespace hapticut {
namespace {

// Brake of a tool that the spindle throws about.
constexpr double kBrake = 60;        // [N s/m] its damping
constexpr double kUnbraked = 0.1;    // [m/s] how much faster than the hand a tool moves without it
constexpr double kMuchBraked = 0.1;  // [1] its force over the one between tool and material, from which it is reported

/// [J] Energy of a spring whose force is limited.
double energy_of(double stretch, double stiffness, double max_force) {
  const double full = max_force / stiffness;
  return stretch > full ? max_force * (stretch - 0.5 * full) : 0.5 * stiffness * stretch * stretch;
}

}  // namespace

void validate(const CouplingGains& gains) { require_fields_within(gains, "CouplingGains::"); }

VirtualCoupling::VirtualCoupling(Simulation& simulation, const CouplingGains& gains)
    : VirtualCoupling(simulation, gains, Lists(simulation.worst_case(), simulation.config())) {}

VirtualCoupling::VirtualCoupling(Simulation& simulation, const CouplingGains& gains, Lists lists)
    : simulation_(&simulation), gains_(gains), lists_(std::move(lists)) {
  validate(gains);
  if (simulation.config().contact_time != ContactTime::end)
    throw Error(
        "the simulation evaluates contact in the middle of a step, where an implicit coupling would oscillate. "
        "Make it with " +
        "SimulationConfig::contact_time"_name + " = " + "ContactTime::end"_name + ".");
  const bool is_placed =
      !simulation.next_step_is_first() && !has_any(simulation.last_result().status, kRejected | StepStatus::tool_waits);
  if (!is_placed) return;
  gripped_ = is_placed_ = true;
  result_.X_WH = X_WD_ = simulation.last_input().X_WH;
}

VirtualCoupling::Lists::Lists(const WorstCase& worst_case, const SimulationConfig& config) {
  reserve_touched(removed, removed_list_size(config, worst_case.voxels * 2));
  reserve_touched(changed, worst_case.blocks * kMaxSubTicks);
}

void VirtualCoupling::exchange_lists(Lists& lists) noexcept {
  begin_tick();  // nothing refers to the old lists any more
  std::swap(lists_, lists);
}

/// The output to the hand for a sub-tick: the coupling's wrench at its end, after the last sub-tick.
class VirtualCoupling::CoupledOutput final : public HandCoupling {
 public:
  CoupledOutput(VirtualCoupling& coupling, const SubTick& sub_tick, const Pose& X_WH, const Twist& tool,
                const Twist& hand)
      : coupling_(coupling), sub_tick_(sub_tick), after_(coupling.forces_at(X_WH, tool, sub_tick.X_WD, hand)) {}

  std::optional<HandOutput> answer(const StepResult& stepped) noexcept override {
    Wrench& wrench = coupling_.result_.coupling;
    wrench = {-after_.wrench.force, coupling_.has_torque() ? Vec3(-after_.wrench.torque) : stepped.model.torque};
    if (sub_tick_.left > 0) return std::nullopt;
    return HandOutput{sub_tick_.X_WD, wrench, sub_tick_.tick};
  }

  [[nodiscard]] const CouplingForces& after() const { return after_; }

 private:
  VirtualCoupling& coupling_;
  const SubTick& sub_tick_;
  CouplingForces after_;
};

const CoupledResult& VirtualCoupling::step(const Pose& X_WD, const Twist& V_WD, double dt) noexcept {
  return follow({X_WD, V_WD, dt});  // copies, because they may be parts of the last result, which changes
}

const CoupledResult& VirtualCoupling::follow(const StepInput& hand) noexcept {
  const auto& [X_WD, V_WD, dt] = hand;
  begin_tick();
  const StepStatus rejected = check_input(simulation_->config(), X_WD, V_WD, dt);
  if (rejected != StepStatus::ok) return suspend(rejected);
  const bool jumps = given_ && is_jump(*given_, X_WD, dt) && (!gripped_ || is_jump(X_WD_, X_WD, dt));
  if (!velocity_fits(X_WD, V_WD, dt)) return suspend(StepStatus::velocity_rejected);
  separate_after_exchange();
  if (jumps) return suspend(StepStatus::jump_rejected);
  if (gripped_ && !waits_ && is_rotated_away(X_WD)) rejoin_ = Rejoin::free, waits_ = true;
  if (waits_ && !may_continue_from_here(X_WD)) {
    if (simulation_->is_in_material(X_WD) || simulation_->is_in_material(advance(X_WD, V_WD, -dt))) {
      if (!is_placed_) result_.X_WH = X_WD;
      return suspend(StepStatus::tool_waits);
    }
    gripped_ = false;
  }
  if (!std::exchange(gripped_, true)) {
    is_placed_ = true;
    result_.X_WH = advance(X_WD, V_WD, -dt);
    result_.V_WH = V_WD;
    begin_grip(X_WD, V_WD, dt);
  } else if (waits_) {
    begin_grip(X_WD, V_WD, dt);
  }
  waits_ = false;
  rejoin_ = Rejoin::near;
  const Twist hand_path = twist_between(X_WD_, X_WD, dt);
  const Pose X_WD_before = X_WD_;
  result_.sub_ticks = plan_sub_ticks(dt);
  for (int sub_tick = 1; sub_tick <= result_.sub_ticks; ++sub_tick) {
    const Pose at_end =
        sub_tick == result_.sub_ticks ? X_WD : advance(X_WD_before, hand_path, dt * sub_tick / result_.sub_ticks);
    const StepStatus status = move({at_end, dt / result_.sub_ticks, result_.sub_ticks - sub_tick, dt}, hand_path, V_WD);
    if (has_any(status, kRejected | StepStatus::tool_waits)) return suspend(status);
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
  result_.first_touched = {};
  result_.sub_ticks = result_.newton_steps = evaluated_ = 0;
  result_.level_of_detail = 1;
  result_.status = StepStatus::ok;
}

/// Number of equal sub-ticks in which no point of the head moves much farther than half a voxel.
int VirtualCoupling::plan_sub_ticks(double dt) const noexcept {
  constexpr double kMargin = 1.25;  // [1] for what the tool gains in speed
  const Tool& tool = simulation_->tool();
  const Vec3 p_HoTo_W = result_.X_WH.rotation * tool.X_HT().translation;
  const double speed =
      transport(result_.V_WH, p_HoTo_W).linear.norm() + result_.V_WH.angular.norm() * tool.head().reach();
  const double sub_ticks = std::ceil(kMargin * speed * dt / (0.5 * simulation_->workpiece().voxel_size()));
  return int(std::clamp(sub_ticks, 1.0, double(kMaxSubTicks)));
}

WorstCase VirtualCoupling::worst_case() const {
  WorstCase worst = simulation_->worst_case();
  const int for_slope = simulation_->config().law->is_foundation() ? 0 : has_torque() ? 6 : 3;
  worst.contacts = NewtonSearch::most_evaluations(gains_.newton_steps, kMaxSubTicks, for_slope) + kMaxSubTicks;
  return worst;
}

/// Moves the hand and the tool by one sub-tick.
StepStatus VirtualCoupling::move(const SubTick& sub_tick, const Twist& hand_path, const Twist& hand) noexcept {
  const Twist tool_before = accelerated();
  const CouplingForces before = forces_at(result_.X_WH, result_.V_WH, X_WD_, hand);
  const Twist tool = NewtonSearch(*this, sub_tick, hand).find();
  Pose X_WH = advance(result_.X_WH, tool, sub_tick.dt);
  if (!has_torque()) X_WH.rotation = sub_tick.X_WD.rotation;
  const double missed = result_.energy.imbalance();
  CoupledOutput output(*this, sub_tick, X_WH, tool, hand);
  const StepResult& stepped = simulation_->step(X_WH, tool, sub_tick.dt, &output);
  if (has_any(stepped.status, kRejected | StepStatus::tool_waits)) return stepped.status;
  keep_lists(stepped);
  result_.level_of_detail = std::max(result_.level_of_detail, stepped.contact.level_of_detail);

  result_.X_WH = X_WH;
  result_.V_WH = tool;
  const Wrench& pulled = output.after().wrench;
  remainder_ =
      remainder_of({stepped.model.force + pulled.force + output.after().brake, stepped.model.torque + pulled.torque},
                   tool_before, sub_tick.dt);
  // By the wrench of the end, which the search has balanced; along the path it changes, and its lever turns.
  const double tool_work =
      -(stepped.model.force.dot(tool.linear) + stepped.model.torque.dot(tool.angular)) * sub_tick.dt;
  book(before, output.after(), tool_before, hand_path, tool_work, sub_tick.dt);
  // The pose of a tool at rest is found within a small distance.
  const double distance =
      std::max((tool.linear.norm() + (has_torque() ? tool.angular.norm() * reach() : 0)) * sub_tick.dt,
               NewtonSearch::kSolved * simulation_->workpiece().voxel_size());
  const double force = std::max(stepped.model.force.norm(), output.after().wrench.force.norm());
  if (std::abs(result_.energy.imbalance() - missed) > (kFarBalance + kFarFraction * force) * distance)
    result_.status |= StepStatus::not_in_balance;
  if (stepped.contact.voxels > 0 && output.after().brake.norm() > kMuchBraked * stepped.model.force.norm())
    result_.status |= StepStatus::tool_braked;
  X_WD_ = sub_tick.X_WD;
  return stepped.status;
}

/// Adds what a sub-tick has changed to the lists of the tick.
void VirtualCoupling::keep_lists(const StepResult& stepped) noexcept {
  result_.removed_volume += stepped.removed_volume;
  result_.first_touched.insert(simulation_->first_touched());
  const std::size_t room = lists_.removed.capacity() - lists_.removed.size();
  const auto listed = stepped.removed_voxels.first(std::min(room, stepped.removed_voxels.size()));
  lists_.removed.insert(lists_.removed.end(), listed.begin(), listed.end());
  if (lists_.removed.capacity() > 0 && listed.size() < stepped.removed_voxels.size())
    result_.status |= StepStatus::removed_list_full;
  const ChangedBlocks changed = simulation_->changed_blocks();
  const bool all = lists_.changed.size() + changed.origins.size() <= lists_.changed.capacity();
  if (all) lists_.changed.insert(lists_.changed.end(), changed.origins.begin(), changed.origins.end());
  result_.changed_blocks.complete = result_.changed_blocks.complete && changed.complete && all;
  result_.removed_voxels = lists_.removed;
  result_.changed_blocks.origins = lists_.changed;
}

VirtualCoupling::Limited VirtualCoupling::limited(const Vec3& spring, const Vec3& damper, double max_size) noexcept {
  Limited l = {spring + damper, spring, Mat3::Identity()};
  if (const double size = l.force.norm(); size > max_size) {
    const Vec3 along = l.force / size;
    l.slope = max_size / size * (Mat3::Identity() - along * along.transpose());
    l.force = max_size * along;
  }
  if (const double size = spring.norm(); size > max_size) l.spring *= max_size / size;
  return l;
}

VirtualCoupling::CouplingForces VirtualCoupling::forces_at(const Pose& X_WH, const Twist& tool, const Pose& X_WD,
                                                           const Twist& hand) const noexcept {
  CouplingForces p;
  p.stretch = X_WD.translation - X_WH.translation;
  p.rotation = has_torque() ? vector_from_rotation(X_WD.rotation * X_WH.rotation.transpose()) : Vec3(Vec3::Zero());
  p.linear = limited(gains_.stiffness * p.stretch, gains_.damping * (hand.linear - tool.linear), gains_.max_force);
  p.angular = limited(gains_.angular_stiffness * p.rotation, gains_.angular_damping * (hand.angular - tool.angular),
                      gains_.max_torque);
  p.wrench = {p.linear.force, p.angular.force};
  brake(p, tool.linear, hand.linear);
  return p;
}

/// Brakes a tool that its spindle has made faster than the hand.
void VirtualCoupling::brake(CouplingForces& forces, const Vec3& tool, const Vec3& hand) const noexcept {
  forces.brake.setZero();
  forces.brake_slope.setZero();
  const double speed = tool.norm();                           // [m/s]
  const double unbraked = (hand.norm() + kUnbraked) / speed;  // [1] part of the speed that is not braked
  if (simulation_->last_result().spindle.speed == 0 || !(unbraked < 1)) return;
  const Vec3 along = tool / speed;
  forces.brake = -kBrake * (1 - unbraked) * tool;
  forces.brake_slope = kBrake * ((1 - unbraked) * Mat3::Identity() + unbraked * along * along.transpose());
}

void VirtualCoupling::set_gains(const CouplingGains& gains) noexcept {
  gains_ = gains;
  if (!gripped_ || waits_) return;
  CouplingEnergy& energy = result_.energy;
  const double before = energy.kinetic + energy.spring;
  energy.kinetic = kinetic_energy(accelerated());
  energy.spring = spring_energy(forces_at(result_.X_WH, result_.V_WH, X_WD_, {}));
  const double brought = energy.kinetic + energy.spring - before;
  energy.hand_work += brought;
  energy.turnover += std::abs(brought);
}

/// What a sub-tick leaves of the balance of forces, as a change of the tool's twist V. The work of the force that
/// is left is r V dt, and a change d of the twist takes M (d V + d^2/2). The change is the part of r dt/M for which
/// both are equal; where the force acts against the motion, the one for which they differ least.
/// @param on_tool  forces at the end of the sub-tick
/// @param before   twist at its beginning
Twist VirtualCoupling::remainder_of(const Wrench& on_tool, const Twist& before, double dt) const noexcept {
  const Twist& tool = result_.V_WH;
  Twist d = {dt / gains_.mass * on_tool.force - (tool.linear - before.linear), Vec3::Zero()};
  if (has_torque()) d.angular = dt / gains_.inertia * on_tool.torque - (tool.angular - before.angular);
  const double work = gains_.mass * d.linear.dot(tool.linear) + gains_.inertia * d.angular.dot(tool.angular);
  const double own = kinetic_energy(d);
  if (!(own > 0)) return {};
  const double share =
      work > 0 ? 2 * work / (work + std::sqrt(work * (work + 4 * own))) : std::min(1.0, -work / (2 * own));
  return {share * d.linear, share * d.angular};
}

/// The twist from which the forces of the next sub-tick accelerate the tool.
Twist VirtualCoupling::accelerated() const noexcept {
  return {result_.V_WH.linear + remainder_.linear, result_.V_WH.angular + remainder_.angular};
}

double VirtualCoupling::kinetic_energy(const Twist& tool) const noexcept {
  const double turning = has_torque() ? 0.5 * gains_.inertia * tool.angular.squaredNorm() : 0.0;
  return 0.5 * gains_.mass * tool.linear.squaredNorm() + turning;
}

double VirtualCoupling::spring_energy(const CouplingForces& p) const noexcept {
  const double linear = energy_of(p.stretch.norm(), gains_.stiffness, gains_.max_force);
  return has_torque() ? linear + energy_of(p.rotation.norm(), gains_.angular_stiffness, gains_.max_torque) : linear;
}

void VirtualCoupling::book(const CouplingForces& before, const CouplingForces& after, const Twist& tool_before,
                           const Twist& hand_path, double tool_work, double dt) noexcept {
  CouplingEnergy& energy = result_.energy;
  const Twist& tool = result_.V_WH;
  const Vec3 torque = has_torque() ? after.wrench.torque : Vec3(-result_.coupling.torque);
  // Where no torque turns the tool, it turns with the hand, at first also by what this has turned while it was
  // separated.
  const Vec3& turned = has_torque() ? hand_path.angular : tool.angular;
  const double by_hand = (after.wrench.force.dot(hand_path.linear) + torque.dot(turned)) * dt;
  const Vec3 stretching = (hand_path.linear - tool.linear) * dt;
  double damper = (after.linear.force - after.linear.spring).dot(stretching) - after.brake.dot(tool.linear) * dt;
  // Work of the spring's force at the end, less the energy that it stores; and the loss of the mass.
  double implicit = after.linear.spring.dot(stretching) - (spring_energy(after) - spring_energy(before)) +
                    0.5 * gains_.mass * (tool.linear - tool_before.linear).squaredNorm();
  if (has_torque()) {
    const Vec3 turning = (hand_path.angular - tool.angular) * dt;
    damper += (after.angular.force - after.angular.spring).dot(turning);
    implicit +=
        after.angular.spring.dot(turning) + 0.5 * gains_.inertia * (tool.angular - tool_before.angular).squaredNorm();
  }
  energy.hand_work += by_hand;
  energy.tool_work += tool_work;
  energy.damper += damper;
  energy.implicit += implicit;
  energy.kinetic = kinetic_energy(accelerated()), energy.spring = spring_energy(after);
  energy.turnover += std::abs(by_hand) + std::abs(tool_work) + std::abs(damper) + std::abs(implicit);
}

}  // namespace hapticut
