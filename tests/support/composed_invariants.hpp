// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "hapticut/simulation/coupling.hpp"
#include "support/solid_depth.hpp"

/// Invariants of every tick, after any sequence of ticks. The first broken invariant is kept as a sentence.
namespace hapticut::test {

/// The margins of a run to its bounds.
struct Margins {
  double entered = 0;                        // [J] energy entered in a sequence, beyond the error of the step
  double unbooked = 0;                       // [1] part of the turnover, without what entered
  double unexplained = 0;                    // [1] part of the coupling's turnover
  double announced = 0;                      // [1] part of the coupling's turnover, in ticks with not_in_balance
  double volume = 0;                         // [1] difference of two sums of the removed volume, over that volume
  double too_deep = 0;                       // [1] depth of solid material in the head over the allowed depth
  double burst = 0;                          // [J] work of the motor, beyond its power
  double all_entered = 0, all_turnover = 0;  // [J] sums over all sequences
  std::uint64_t ticks = 0, cutting = 0, waiting = 0, refused = 0, stalled = 0, crushing = 0, unbalanced = 0,
                grips = 0;  // numbers of ticks of each kind, and of grips

  void add(const Margins& other) {
    for (auto member : {&Margins::entered, &Margins::unbooked, &Margins::unexplained, &Margins::announced,
                        &Margins::volume, &Margins::too_deep, &Margins::burst})
      this->*member = std::max(this->*member, other.*member);
    all_entered += other.all_entered, all_turnover += other.all_turnover;
    for (auto member : {&Margins::ticks, &Margins::cutting, &Margins::waiting, &Margins::refused, &Margins::stalled,
                        &Margins::crushing, &Margins::unbalanced, &Margins::grips})
      this->*member += other.*member;
  }
  [[nodiscard]] std::string in_words() const {
    std::ostringstream out;
    out << ticks << " ticks, of which " << cutting << " cut, " << waiting << " wait, " << refused << " refused, "
        << stalled << " stalled, " << crushing << " crush, " << unbalanced << " not in balance; " << grips
        << " grips; entered " << all_entered << " of " << all_turnover << " J; maxima: entered " << entered
        << " J, unbooked " << unbooked << ", unexplained " << unexplained << ", announced " << announced << ", volume "
        << volume << ", depth " << too_deep << ", burst " << burst << " J";
    return out.str();
  }
};

inline double volume_of(const Workpiece& workpiece) {
  double volume = 0;
  for (const MaterialAmount& amount : workpiece.amounts()) volume += amount.volume;
  return volume;
}

inline bool is_finite(const Wrench& wrench) { return wrench.force.allFinite() && wrench.torque.allFinite(); }
inline bool same_bits(const Pose& a, const Pose& b) {
  return a.translation == b.translation && a.rotation == b.rotation;
}

/// Checks every step of a simulation, and every tick of the coupling that drives it.
class ComposedInvariants final : public StepObserver {
 public:
  explicit ComposedInvariants(Simulation& simulation) : simulation_(&simulation) {
    simulation.observers().add(*this);
    begin_volume();
  }
  ~ComposedInvariants() override { simulation_->observers().remove(*this); }
  ComposedInvariants(const ComposedInvariants&) = delete;
  ComposedInvariants& operator=(const ComposedInvariants&) = delete;

  /// To be called before something other than a step changes the workpiece. Call `begin_volume` afterwards.
  void end_volume() {
    const double lost = volume_at_begin_ - volume_of(simulation_->workpiece());
    const double off = std::abs(lost - removed_) / std::max(removed_, kVolume);
    margins.volume = std::max(margins.volume, off);
    must(off <= kVolumeShare, "removed_volume is the volume that the workpiece lost", lost, removed_);
  }
  void begin_volume() {
    volume_at_begin_ = volume_of(simulation_->workpiece());
    removed_ = 0;
  }

  /// To be called when the coupling has other gains or another tool: its stored energy jumps.
  void expect_jump_of_stored() { energy_jumps_ = true; }

  /// To be called when the hand grips the tool again. The coupling's ledger then begins again.
  void expect_new_grip() { is_released_ = true; }

  /// @param was_refusable  the reading of this tick was not a motion of a hand
  void look(const CoupledResult& result, const CouplingGains& gains, const Effects& effects, bool was_refusable) {
    ++margins.ticks;
    const StepResult& stepped = simulation_->last_result();
    must(is_finite(result.hand) && is_finite(result.coupling) && hapticut::is_finite(result.X_WH) &&
             result.V_WH.linear.allFinite() && result.V_WH.angular.allFinite() &&
             std::isfinite(result.removed_volume) && std::isfinite(result.energy.imbalance()),
         "every number of the coupling is finite");
    must(is_finite(stepped.model) && std::isfinite(stepped.energy.imbalance()) &&
             std::isfinite(stepped.spindle.speed) && std::isfinite(stepped.spindle.torque) &&
             !has_any(result.status, StepStatus::force_not_finite),
         "every number of the step is finite");
    const double force = std::min(gains.max_force, effects.limits.max_force);
    must(result.hand.force.norm() <= kRounding * force, "the force is within its limit", result.hand.force.norm(),
         force);
    const double torque = gains.angular_stiffness > 0 ? gains.max_torque : effects.limits.max_torque;
    must(result.hand.torque.norm() <= kRounding * torque, "the torque is within its limit", result.hand.torque.norm(),
         torque);
    const bool waits = has_any(result.status, kRejected | StepStatus::tool_waits);
    margins.waiting += has_any(result.status, StepStatus::tool_waits) ? 1 : 0;
    margins.refused += has_any(result.status, kRejected) ? 1 : 0;
    margins.cutting += result.removed_volume > 0 ? 1 : 0;
    margins.unbalanced += has_any(result.status, StepStatus::not_in_balance) ? 1 : 0;
    if (was_refusable) must(waits, "a reading that is not a motion of a hand is rejected");
    if (waits) {
      must(result.removed_volume == 0, "nothing is cut while the hand feels no force", result.removed_volume);
      must(result.hand.force.isZero(0) && result.hand.torque.isZero(0), "a tool that waits gives no force");
      if (has_any(result.status, kRejected)) must(same_bits(result.X_WH, X_WH_), "a rejected reading leaves the tool");
    }
    must(result.removed_volume == removed_in_tick_, "the tick removes the volume of its steps", result.removed_volume,
         removed_in_tick_);
    look_at_coupling(result.energy, waits, has_any(result.status, StepStatus::not_in_balance));
    // With removal off, or where a stall or missing memory leaves material, the head may press itself in elastically.
    const bool is_free = waits || solid_may_be_deep_;
    if (margins.ticks % kDepthEvery == 0 && !is_free) look_at_depth(result.X_WH * simulation_->tool().X_HT());
    if (margins.ticks % kVolumeEvery == 0) end_volume();
    X_WH_ = result.X_WH;
    removed_in_tick_ = 0;
    for (const Vec3& v : {result.hand.force, result.hand.torque, result.X_WH.translation, result.V_WH.linear})
      for (const double number : v) mix(number);
    mix(stepped.energy.turnover);
    mix(result.removed_volume);
  }

  /// Checks a tick of a loop that has its own coupling.
  /// @param removed  [m^3] in this tick, from the loop
  /// @param applied  wrench of the motors, after the guard
  void look(double removed, const Wrench& applied, double max_force, const Pose& X_WT) {
    ++margins.ticks;
    must(is_finite(applied), "the wrench of the motors is finite");
    must(hapticut::is_finite(X_WT), "the pose of the tool is finite");
    must(applied.force.norm() <= kRounding * max_force, "the force of the motors is within its limit",
         applied.force.norm(), max_force);
    must(std::abs(removed - removed_in_tick_) <= kVolumeShare * removed_in_tick_ + kVolume * kVolumeShare,
         "the tick removes the volume of its steps", removed, removed_in_tick_);
    if (applied.force.isZero(0) && applied.torque.isZero(0))
      must(removed_in_tick_ == 0, "nothing is cut while the hand feels no force", removed_in_tick_);
    margins.cutting += removed_in_tick_ > 0 ? 1 : 0;
    if (std::exchange(is_exchanged_, false))
      begin_volume();
    else if (margins.ticks % kLoopVolumeEvery == 0)
      end_volume();
    removed_in_tick_ = 0;
    for (const double number : applied.force) mix(number);
    for (const double number : X_WT.translation) mix(number);
    mix(removed);
  }

  void on_exchange() noexcept override { is_exchanged_ = is_released_ = true; }

  void on_step(const ObservedStep& step) noexcept override {
    const StepResult& result = step.result;
    removed_ += result.removed_volume;
    removed_in_tick_ += result.removed_volume;
    if (has_any(result.status, kRejected | StepStatus::tool_waits)) {
      must(result.removed_volume == 0, "a step that is rejected cuts nothing", result.removed_volume);
      return;
    }
    margins.stalled += has_any(result.status, StepStatus::spindle_stalled) ? 1 : 0;
    margins.crushing += has_any(result.status, StepStatus::material_crushed) ? 1 : 0;
    look_at_ledger(step);
    look_at_motor(step);
    if (step.simulation.config().removal == RemovalLaw::none ||
        has_any(result.status, StepStatus::blocks_exhausted | StepStatus::detail_reduced))
      solid_may_be_deep_ = true;
    else if (result.contact.voxels == 0)
      solid_may_be_deep_ = false;
    ledger_ = result.energy;
  }

  /// To be called when the simulation starts again with another workpiece and an empty ledger.
  void begin_ledger() {
    ledger_ = {};
    step_error_ = 0;
  }

  /// To be called after an exchange that includes the motor.
  void forget_motor() { rotor_speed_ = std::numeric_limits<double>::infinity(); }

  [[nodiscard]] const std::string& broken() const { return broken_; }
  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  Margins margins;

 private:
  static constexpr double kRounding = 1 + 1e-9;
  static constexpr double kVolume = 1e-12;      // [m^3] below which a relative error means nothing
  static constexpr double kVolumeShare = 1e-5;  // [1] rounding error of fills in single precision
  static constexpr double kUnbooked = 5e-6;     // [1] part of the turnover
  static constexpr double kEntered = 1e-3;      // [1] part of the turnover
  static constexpr double kUnfelt = 1e-3;       // [J] work of 1 N over 1 mm, may also enter in a sequence
  static constexpr double kUnexplained = 1e-2;  // [1] part of the coupling's turnover
  static constexpr double kRotated = 1e-8;      // [1] part of the coupling's turnover, as large rotations do not add
  static constexpr double kLittle = 1e-4;       // [J] turnover below which a relative error means nothing
  static constexpr std::uint64_t kDepthEvery = 7, kVolumeEvery = 500, kLoopVolumeEvery = 100;  // [ticks]

  void must(bool holds, const char* what, double seen = 0, double bound = 0) noexcept {
    if (holds || !broken_.empty()) return;
    std::ostringstream out;
    out.precision(9);
    out << "broken: " << what << "; seen " << seen << ", bound " << bound;
    broken_ = out.str();
  }

  void look_at_ledger(const ObservedStep& step) noexcept {
    const EnergyLedger& e = step.result.energy;
    constexpr std::array<double EnergyLedger::*, 8> kGrowing = {
        &EnergyLedger::cutting, &EnergyLedger::crushed, &EnergyLedger::released, &EnergyLedger::damping,
        &EnergyLedger::rubbing, &EnergyLedger::sliding, &EnergyLedger::credited, &EnergyLedger::turnover};
    constexpr std::array<const char*, 8> kNames = {"cutting grows",  "crushed grows", "released grows",
                                                   "damping grows",  "rubbing grows", "sliding grows",
                                                   "credited grows", "turnover grows"};
    for (std::size_t n = 0; n < kGrowing.size(); ++n)
      must(e.*kGrowing[n] >= ledger_.*kGrowing[n], kNames[n], e.*kGrowing[n] - ledger_.*kGrowing[n]);
    margins.all_entered += std::abs(e.entered - ledger_.entered);
    margins.all_turnover += e.turnover - ledger_.turnover;
    must(e.elastic >= 0 && e.anchored >= 0, "nothing stored is negative", std::min(e.elastic, e.anchored));
    // This error vanishes with the step. It is the change of the force along the path of a sub-step, which is at most
    // half a voxel.
    const Twist path = twist_between(pose_, step.input.X_WH, 1);
    const double change = std::abs((step.result.model.force - model_.force).dot(path.linear)) +
                          std::abs((step.result.model.torque - model_.torque).dot(path.angular));
    step_error_ += change / std::max(1, step.result.sub_steps);
    pose_ = step.input.X_WH;
    model_ = step.result.model;
    if (e.turnover < kLittle) return;
    const double unbooked = std::abs(e.imbalance() + e.entered) / e.turnover;
    const double entered = std::max(0.0, std::abs(e.entered) - step_error_);
    margins.unbooked = std::max(margins.unbooked, unbooked);
    margins.entered = std::max(margins.entered, entered);
    must(unbooked <= kUnbooked, "the ledger closes", unbooked, kUnbooked);
    const double may_enter = kEntered * e.turnover + kUnfelt;
    must(entered <= may_enter, "entered energy is small", entered, may_enter);
  }

  void look_at_coupling(const CouplingEnergy& e, bool waits, bool says_so) noexcept {
    // A grip begins with an empty ledger. Not every exchange releases the tool.
    const bool is_new_grip = e.turnover < coupling_.turnover ||
                             (is_released_ && !waits && std::abs(e.imbalance()) <= kUnexplained * e.turnover);
    is_released_ = waits;
    margins.grips += is_new_grip ? 1 : 0;
    if (is_new_grip) explained_ = 0;
    // A failed search for the balance sets a status; its error is counted separately.
    const double missed = e.imbalance() - (is_new_grip ? 0 : coupling_.imbalance());
    if (says_so || (energy_jumps_ && !is_new_grip)) explained_ += missed;
    if (says_so && e.turnover > kLittle)
      margins.announced = std::max(margins.announced, std::abs(explained_) / e.turnover);
    if (!is_new_grip && !energy_jumps_) {
      const double implicit = e.implicit - coupling_.implicit, rounding = 1e-15 + kRotated * e.turnover;
      must(implicit >= -rounding, "implicit steps only dissipate", implicit, -rounding);
    }
    energy_jumps_ = false;
    coupling_ = e;
    if (e.turnover < kLittle) return;
    const double unexplained = std::abs(e.imbalance() - explained_) / e.turnover;
    margins.unexplained = std::max(margins.unexplained, unexplained);
    must(unexplained <= kUnexplained, "the coupling's ledger closes", unexplained, kUnexplained);
  }

  void look_at_depth(const Pose& X_WT) {
    const double allowed = allowed_depth(*simulation_) + simulation_->workpiece().voxel_size();
    const double depth = solid_depth(*simulation_, X_WT);
    margins.too_deep = std::max(margins.too_deep, depth / allowed);
    must(depth <= allowed, "no solid material is deep in the head", depth, allowed);
  }

  /// The motor's work without the energy that the slowing rotor gave is at most its power, by its characteristic at the
  /// speeds of the step, and a little more while a blow slows it down.
  void look_at_motor(const ObservedStep& step) noexcept {
    const Spindle& motor = step.simulation.tool().spindle();
    const double w = std::abs(step.result.spindle.speed);
    const double before = std::isinf(rotor_speed_) ? std::abs(double(motor.speed)) : rotor_speed_;
    rotor_speed_ = w;
    const double slowed = 0.5 * motor.rotor_inertia * std::max(0.0, before * before - w * w);
    const double work = step.result.energy.motor_work - ledger_.motor_work - slowed;
    const double free = std::max(before, (1 + kSpeedKnown) * std::abs(step.spindle_setting));
    double max_power = motor.power_limit;
    if (motor.droop > 0) max_power = std::min(max_power, 0.25 * free * free / motor.droop);
    if (std::isfinite(motor.torque_limit)) max_power = std::min(max_power, motor.torque_limit * free);
    if (!std::isfinite(max_power)) return;
    burst_ = std::max(0.0, burst_ + work - kPowerKnown * max_power * step.input.dt - kLoadKnown * slowed);
    margins.burst = std::max(margins.burst, burst_);
    must(burst_ <= kBurst, "the motor has its power", burst_, kBurst);
  }

  void mix(double number) noexcept { hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3ULL; }

  static constexpr double kSpeedKnown = 2e-3;  // [1] accuracy of the motor's speed
  static constexpr double kPowerKnown = 1.01;  // [1]
  static constexpr double kLoadKnown = 0.1;    // [1] accuracy of the load of a rotor that runs down
  static constexpr double kBurst = 1e-3;       // [J] three times what is seen when a head strikes

  Simulation* simulation_;
  std::string broken_;
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
  double volume_at_begin_ = 0, removed_ = 0, removed_in_tick_ = 0;  // [m^3]
  EnergyLedger ledger_;
  Pose pose_;              // the last step's
  Wrench model_;           // the last step's
  double step_error_ = 0;  // [J] error of `entered`
  CouplingEnergy coupling_;
  double explained_ = 0;  // [J] part of the coupling's imbalance, due to changes between ticks
  bool is_exchanged_ = false, is_released_ = true, energy_jumps_ = false, solid_may_be_deep_ = false;
  double rotor_speed_ = std::numeric_limits<double>::infinity();  // [rad/s]
  double burst_ = 0;                                              // [J] work of the motor, beyond its power
  Pose X_WH_;
};

}  // namespace hapticut::test
