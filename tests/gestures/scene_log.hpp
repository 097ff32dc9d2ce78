// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "gestures/report.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut::gestures {

/// One tick of a scene: hand, tool, device and simulation.
struct Tick {
  double time = 0;      // [s] since the script began; the guard arms at negative times
  Pose X_WD;            // pose of the handle in the hand
  Pose X_WH;            // pose of the handle of the tool
  Wrench felt;          // requested for the hand, about Ho of the hand, in W
  Wrench effects;       // the part of `felt` that does not come from contact, such as weight
  Wrench applied;       // sent to the motors; without a device equal to `felt`
  Wrench model;         // wrench of the contact, about Ho of the tool, in W
  double removed = 0;   // [m^3] volume removed in this tick
  double depth = 0;     // [m] greatest below the cutting surface
  int voxels = 0;       // number in contact
  int contacts = 1;     // evaluated contacts: several behind a coupling
  double speed = 0;     // [rad/s] speed of the spindle
  EnergyLedger energy;  // ledger of the simulation
  StepStatus status = StepStatus::ok;
  ArmingState arming = ArmingState::on;
};

/// Ticks `first` ... `last - 1` of a scene.
struct Span {
  std::size_t first = 0, last = 0;
  [[nodiscard]] std::size_t size() const { return last - first; }
  /// The last part of the span. @param share  [1] fraction of its length
  [[nodiscard]] Span tail(double share) const { return {last - std::size_t(std::ceil(share * double(size()))), last}; }
};

/// Limits of the device by which a scene is judged.
struct Limits {
  double force = 0;        // [N] peak of the device; 0: no device
  double torque = 0;       // [N·m] peak of the device
  double spring = 0;       // [N/m] stiffness that the device renders; 0: the hand holds the tool directly
  bool has_guard = false;  // a guard limits the forces
};

/// Records all ticks of a scene, and checks the invariants that every gesture must keep (docs/validation.md).
class SceneLog final : public StepObserver {
 public:
  SceneLog(const Limits& a_limits, const Report& report)
      : limits(a_limits), probing_(report.probing), turn_(report.turn) {}

  std::vector<Tick> ticks;
  Limits limits;

  /// Starts to judge the invariants. The current energy ledger is the reference.
  void begin(const Simulation& simulation);

  /// Call at the end of each tick. @param coupling  null: no coupling
  void add(const Tick& tick, const Simulation& simulation, const VirtualCoupling* coupling);

  /// Adds a row for each invariant, and a hash of all results, to the report.
  void judge(Report& report, const Simulation& simulation) const;

  void on_step(const ObservedStep& step) noexcept override;

  // --- queries -------------------------------------------------------------------------------------------------------
  template <class Of>
  [[nodiscard]] double max_of(const Span& span, const Of& of) const {
    if (span.size() == 0) return std::numeric_limits<double>::quiet_NaN();  // fails every demand
    double value = -std::numeric_limits<double>::infinity();
    for (std::size_t n = span.first; n < span.last; ++n) value = std::max(value, double(of(ticks[n])));
    return value;
  }
  template <class Of>
  [[nodiscard]] double min_of(const Span& span, const Of& of) const {
    return -max_of(span, [&](const Tick& tick) { return -double(of(tick)); });
  }
  template <class Of>
  [[nodiscard]] double sum(const Span& span, const Of& of) const {
    double value = span.size() > 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
    for (std::size_t n = span.first; n < span.last; ++n) value += double(of(ticks[n]));
    return value;
  }
  template <class Of>
  [[nodiscard]] double mean(const Span& span, const Of& of) const {
    return sum(span, of) / double(span.size());
  }
  /// [1] Standard deviation about a straight line through the span, over the mean; a slow drift does not count.
  template <class Of>
  [[nodiscard]] double unsteadiness(const Span& span, const Of& of) const {
    const double middle = mean(span, of), n = double(span.size());
    double slope = 0, square = 0;
    for (std::size_t k = span.first; k < span.last; ++k) {
      slope += (double(k - span.first) - 0.5 * (n - 1)) * (double(of(ticks[k])) - middle);
      square += std::pow(double(of(ticks[k])) - middle, 2);
    }
    slope /= n * (n * n - 1) / 12;
    return std::sqrt(std::max(0.0, square / n - slope * slope * (n * n - 1) / 12)) / std::abs(middle);
  }
  [[nodiscard]] Span all() const { return {0, ticks.size()}; }
  [[nodiscard]] Span within(double from, double to) const;  ///< [s] limits of Tick::time
  [[nodiscard]] const Tick& at(double time) const;          ///< the last tick at or before this time

 private:
  void judge_energy(Report& report) const;
  void track_energy(const Tick& tick, double voxel);

  EnergyLedger start_;
  double stored_at_start_ = 0;  // [J]
  double turnover_ = 0;         // [J] sum of the absolute work of hand and motor
  double min_given_ = 0;        // [J] minimum of the work given by hand and motor
  double max_entered_ = 0;      // [J]
  double step_error_ = 0;       // [J] error of `entered` that vanishes with the step
  double hand_given_ = 0, min_hand_given_ = 0, hand_turnover_ = 0;  // [J] at the device, with the motor
  double unexplained_ = 0;                                          // [1] residual of the coupling over its turnover
  double allowed_depth_ = 0, deepest_ = 0;                          // [m] depths of solid material in the head
  double unfelt_ = 0;                                               // [m^3] cut while the device got no force
  double max_felt_ = 0, max_applied_ = 0, max_torque_ = 0;          // [N], [N·m]
  double max_power_ = 0, excess_power_ = 0;  // [W] power, and excess over the motor's characteristic
  double rotor_speed_ = 0, motor_work_ = 0;  // [rad/s], [J] after the last step
  double lent_ = 0;                          // [J] from the rotor
  bool has_begun_ = false;
  bool probing_;
  Mat3 turn_;  // rotation of the scene; ticks are recorded without it
};

inline double force_of(const Tick& tick) { return tick.felt.force.norm(); }
inline double thrust_of(const Tick& tick) { return tick.felt.force.z(); }
inline double side_of(const Tick& tick) { return tick.felt.force.head<2>().norm(); }
inline double removed_of(const Tick& tick) { return tick.removed; }

inline void demand_steady(Report& report, const SceneLog& log, const Span& span,
                          const std::string& demand = "sd of the steady force") {
  report.at_most(demand, 100 * log.unsteadiness(span, force_of), 5, "%", "of its mean, about a straight line");
}

}  // namespace hapticut::gestures
