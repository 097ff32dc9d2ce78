// SPDX-License-Identifier: Apache-2.0
#include "gestures/scene_log.hpp"

#include <bit>
#include <limits>

#include "gestures/pieces.hpp"
#include "support/solid_depth.hpp"

namespace hapticut::gestures {
namespace {

constexpr double kShare = 1e-3;        // [1] allowed gain or `entered`, over the turnover
constexpr double kUnexplained = 1e-2;  // [1] allowed residual over the coupling's turnover
constexpr double kNothing = 1e-9;      // [J] negligible work
constexpr double kLittle = 1e-5;       // [J] below this turnover the coupling's tolerance of 10 mN dominates
constexpr double kNoVolume = 1e-15;    // [m^3] negligible volume
constexpr double kRounding = 1.001;    // [1]
constexpr double kNoPower = 1e-6;      // [W] power of a stalled motor: rounding in single precision
constexpr double kLent = 1e-3;         // [1] share of the rotor's kinetic energy that may feed the load
constexpr double kSpeedKnown = 2e-3;   // [1] accuracy of the motor's speed, over the setting

/// [m] Engaged layer (C34) half a voxel beside the axis, for the material with the thickest layer.
double thickest_layer(const Simulation& simulation, double feed) {
  const Tool& tool = simulation.tool();
  const double spin = std::abs(simulation.last_result().spindle.speed);
  double layer = 0;
  if (spin == 0) return layer;
  for (const Material& m : simulation.workpiece().materials().all()) {
    closed_forms::SteadyCut cut = steady_cut(m, tool.cutter(), spin, feed);
    cut.feed_speed += cut.size_speed() + cut.edge_speed();
    const double k = simulation.config().reference_stiffness * m.relative_stiffness;
    layer = std::max(layer, 1.1 * closed_forms::engaged_layer(cut, k, 0.5 * simulation.workpiece().voxel_size()));
  }
  return layer;
}

}  // namespace

void SceneLog::begin(const Simulation& simulation) {
  has_begun_ = true;
  start_ = simulation.last_result().energy;
  stored_at_start_ = start_.stored();
  turnover_ = min_given_ = max_entered_ = step_error_ = 0;
  hand_given_ = min_hand_given_ = hand_turnover_ = unexplained_ = deepest_ = unfelt_ = 0;
  max_felt_ = max_applied_ = max_torque_ = max_power_ = excess_power_ = lent_ = 0;
  allowed_depth_ = test::allowed_depth(simulation);
  rotor_speed_ = std::abs(simulation.last_result().spindle.speed);
  motor_work_ = simulation.last_result().energy.motor_work;
}

void SceneLog::track_energy(const Tick& tick, double voxel) {
  const Tick& last = ticks.back();
  const double hand = tick.energy.hand_work - last.energy.hand_work;
  const double motor = tick.energy.motor_work - last.energy.motor_work;
  turnover_ += std::abs(hand) + std::abs(motor);
  min_given_ =
      std::min(min_given_, tick.energy.hand_work - start_.hand_work + tick.energy.motor_work - start_.motor_work);
  max_entered_ = std::max(max_entered_, std::abs(tick.energy.entered - start_.entered));
  // The error of a step is the change of the force along the motion of a sub-step, which is at most half a voxel.
  const Twist motion = twist_between(last.X_WH, tick.X_WH, 1);
  const double error = std::abs((tick.model.force - last.model.force).dot(motion.linear) +
                                (tick.model.torque - last.model.torque).dot(motion.angular));
  const double way = motion.linear.norm();
  if (std::isfinite(error)) step_error_ += error * (way > 0.5 * voxel ? 0.5 * voxel / way : 1);
  // The device holds the last force while the hand moves. A spring that is held in this way returns half its stiffness
  // times the square of the motion.
  const Twist path = twist_between(last.X_WD, tick.X_WD, 1);
  const double asked = last.felt.force.norm(), given = last.applied.force.norm();
  const double share = given < asked ? given / asked : 1;  // [1] fraction of force and effects that the guard passed
  const double work = -(last.applied.force - share * last.effects.force).dot(path.linear) -
                      (last.applied.torque - share * last.effects.torque).dot(path.angular);
  if (!std::isfinite(work)) return;
  hand_given_ += work + std::max(0.0, motor) + 0.5 * limits.spring * path.linear.squaredNorm();
  hand_turnover_ += std::abs(work) + std::abs(motor);
  min_hand_given_ = std::min(min_hand_given_, hand_given_);
}

void SceneLog::add(const Tick& tick, const Simulation& simulation, const VirtualCoupling* coupling) {
  if (!ticks.empty() && has_begun_) track_energy(tick, simulation.workpiece().voxel_size());
  const double last_depth = ticks.empty() ? 0 : ticks.back().depth;
  // A tool with a prescribed feed has an engaged layer, which is thickest at the axis.
  if (limits.force == 0 && tick.removed > 0 && !ticks.empty() && tick.time > ticks.back().time)
    allowed_depth_ = std::max(
        allowed_depth_, thickest_layer(simulation, (tick.X_WH.translation - ticks.back().X_WH.translation).norm() /
                                                       (tick.time - ticks.back().time)));
  ticks.push_back(tick);
  // Inspecting every voxel is slow: do it when the contact suddenly deepens, and otherwise every few ticks of a
  // contact.
  constexpr std::size_t kEvery = 5;  // [ticks]
  const bool is_known = !has_any(tick.status, kRejected);
  if (is_known && tick.depth <= allowed_depth_)
    deepest_ = std::max(deepest_, tick.depth);
  else if (ticks.size() % kEvery == 0 || tick.depth > 1.5 * last_depth)
    deepest_ = std::max(
        deepest_, test::solid_depth(simulation, Pose{turn_, Vec3::Zero()} * tick.X_WH * simulation.tool().X_HT()));
  if (limits.has_guard && tick.applied.force.isZero(0) && tick.applied.torque.isZero(0)) unfelt_ += tick.removed;
  if (limits.force > 0) {  // otherwise the tool is still driven directly
    max_felt_ = std::max(max_felt_, tick.felt.force.norm());
    max_applied_ = std::max(max_applied_, tick.applied.force.norm());
  }
  max_torque_ = std::max({max_torque_, tick.felt.torque.norm(), tick.applied.torque.norm()});
  if (coupling == nullptr) return;
  const CouplingEnergy& e = coupling->last_result().energy;
  if (e.turnover > kLittle) unexplained_ = std::max(unexplained_, std::abs(e.closure()));
}

void SceneLog::on_step(const ObservedStep& step) noexcept {
  const SpindleState& spindle = step.result.spindle;
  const Spindle& motor = step.simulation.tool().spindle();
  const double w = std::abs(spindle.speed);
  const double worked = std::max(0.0, step.result.energy.motor_work - motor_work_);
  motor_work_ = step.result.energy.motor_work;
  // A rotor that slows down releases energy that does not come from the motor. Within the step the motor passed all
  // speeds between the old and the new one, and may have overshot by the same difference.
  const double slowed = std::max(0.0, rotor_speed_ * rotor_speed_ - w * w);
  const double max_speed = std::max(rotor_speed_, w);
  const double min_speed = std::max(0.0, max_speed - 2 * std::abs(w - rotor_speed_));
  const double free = (1 + kSpeedKnown) * std::abs(step.simulation.spindle().setting());
  const double strongest = std::clamp(0.5 * free, min_speed, max_speed);
  rotor_speed_ = w;
  const double power = (worked - motor.rotor_inertia * slowed / 2) / step.input.dt;
  max_power_ = std::max(max_power_, power);
  double limit = motor.power_limit;  // [W]
  if (motor.droop > 0) limit = std::min(limit, strongest * std::max(0.0, free - strongest) / motor.droop);
  if (std::isfinite(limit)) {  // the rotor supplies the load until the motor has slowed down
    const double beyond = power - kRounding * limit, holds = 0.5 * motor.rotor_inertia * free * free;
    lent_ = std::max(0.0, lent_ + beyond * step.input.dt);
    if (lent_ > kLent * holds + kNothing) excess_power_ = std::max(excess_power_, beyond);
  }
  if (!probing_ || has_any(step.result.status, kRejected)) return;
  for (const double aside : {1e-4, -1e-4}) {
    Pose elsewhere = step.input.X_WH;
    elsewhere.translation += Vec3(aside, -0.5 * aside, aside);
    (void)step.simulation.probe(elsewhere, step.input.V_WH, step.input.dt);
  }
}

Span SceneLog::within(double from, double to) const {
  Span span{ticks.size(), ticks.size()};
  for (std::size_t n = 0; n < ticks.size(); ++n) {
    if (ticks[n].time >= from - 1e-9 && span.first == ticks.size()) span.first = n;
    if (ticks[n].time >= to - 1e-9) {
      span.last = n;
      break;
    }
  }
  span.first = std::min(span.first, span.last);
  return span;
}

const Tick& SceneLog::at(double time) const {
  std::size_t n = 0;
  while (n + 1 < ticks.size() && ticks[n + 1].time <= time + 1e-9) ++n;
  return ticks[n];
}

void SceneLog::judge_energy(Report& report) const {
  const double given = min_given_ + stored_at_start_;
  const double gain = std::max(0.0, -given), allowed = kShare * turnover_ + kNothing;
  const double hand_gain = std::max(0.0, -min_hand_given_ - stored_at_start_);
  const double hand_allowed = kShare * hand_turnover_ + kNothing;
  const auto share = [&](double energy, double of) { return shown(of > 0 ? 100 * energy / of : 0, "%"); };
  std::string seen = "gained " + share(gain, turnover_) + ", entered " + share(max_entered_, turnover_);
  const bool vanishes = max_entered_ <= allowed + step_error_;
  if (max_entered_ > allowed) seen += " (steps explain " + share(step_error_, turnover_) + ")";
  if (hand_gain > hand_allowed)
    seen += ", at the device gained " + shown(1e3 * hand_gain, "mJ") + " of " + shown(1e3 * hand_turnover_, "mJ");
  if (unexplained_ > kUnexplained) seen += ", unexplained by the coupling " + shown(100 * unexplained_, "%");
  report.that("invariant 1", "gained, entered at most 0.1 % of the turnover; unexplained at most 1 %", seen,
              gain <= allowed && vanishes && hand_gain <= hand_allowed && unexplained_ <= kUnexplained,
              std::max({gain / allowed, max_entered_ / (allowed + step_error_), hand_gain / hand_allowed,
                        unexplained_ / kUnexplained}));
}

void SceneLog::judge(Report& report, const Simulation& simulation) const {
  judge_energy(report);
  if (limits.has_guard)
    report.at_most("invariant 2", 1e9 * unfelt_, 1e9 * kNoVolume, "mm^3", "cut while the device gets no force");
  report.at_most("invariant 3", 1e3 * deepest_, 1e3 * allowed_depth_, "mm",
                 "solid material in the head: crushing depth, or engaged layer");
  if (limits.force > 0) {
    std::string seen = shown(max_felt_, "N") + " asked, " + shown(max_applied_, "N") + " given";
    std::string expected = "at most " + shown(limits.force, "N") + " of spring and damper together";
    if (limits.torque > 0) {
      seen += ", " + shown(1e3 * max_torque_, "N mm") + " asked";
      expected += ", " + shown(1e3 * limits.torque, "N mm");
    }
    report.that("invariant 4", expected, seen,
                max_felt_ <= kRounding * limits.force && max_applied_ <= kRounding * limits.force &&
                    (limits.torque == 0 || max_torque_ <= kRounding * limits.torque));
  }
  const Spindle& motor = simulation.tool().spindle();
  if (motor.droop > 0 || std::isfinite(motor.power_limit))
    report.that("invariant 5", "within the motor's characteristic",
                shown(max_power_, "W") + ", beyond it " + shown(excess_power_, "W"), excess_power_ <= kNoPower);
  for (const Tick& tick : ticks)
    for (const double value : {tick.felt.force.x(), tick.felt.force.y(), tick.felt.force.z(), tick.X_WH.translation.x(),
                               tick.X_WH.translation.z(), tick.energy.hand_work})
      report.add_bits(std::bit_cast<std::uint64_t>(value));
  report.add_bits(simulation.workpiece().hash());
}

}  // namespace hapticut::gestures
