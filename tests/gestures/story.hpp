// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "gestures/report.hpp"
#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut::gestures {

/// One tick as an observer of everything sees it.
struct Tick {
  double time = 0;      // [s] since the script began; the guard arms before 0
  Pose X_WD;            // of the hand's handle
  Pose X_WH;            // of the tool's handle
  Wrench felt;          // what the hand is meant to feel, about Ho of the hand, in W
  Wrench effects;       // of that what is not of contact, such as weight
  Wrench applied;       // what the motors got; without a device: felt
  Wrench model;         // of the contact, about Ho of the tool, in W
  double removed = 0;   // [m^3] in this tick
  double depth = 0;     // [m] greatest below the cutting surface
  int voxels = 0;       // that the head touches
  int contacts = 1;     // that were evaluated: more behind a coupling
  double speed = 0;     // [rad/s] of the spindle
  EnergyLedger energy;  // of the simulation
  StepStatus status = StepStatus::ok;
  ArmingState arming = ArmingState::on;
};

/// Ticks `first` ... `last - 1` of a story.
struct Span {
  std::size_t first = 0, last = 0;
  [[nodiscard]] std::size_t size() const { return last - first; }
  /// The last `share` of it.
  [[nodiscard]] Span tail(double share) const { return {last - std::size_t(std::ceil(share * double(size()))), last}; }
};

/// What a story is judged by, beyond what its ticks say.
struct Limits {
  double force = 0;        // [N] that the device can give; 0: there is none
  double torque = 0;       // [N·m] the same
  double spring = 0;       // [N/m] that the device feels, held between its ticks; 0: the hand holds the tool
  bool has_guard = false;  // a device stands between, and holds forces back
};

/// All ticks of a scene, and the invariants that every gesture must keep.
class Story final : public StepObserver {
 public:
  Story(const Limits& a_limits, const Report& report)
      : limits(a_limits), probing_(report.probing), turn_(report.turn) {}

  std::vector<Tick> ticks;
  Limits limits;

  /// From here on the invariants are judged; what the ledger holds now is what it began with.
  void begin(const Simulation& simulation);

  /// To be called at the end of each tick. @param coupling  of it; null: none
  void add(const Tick& tick, const Simulation& simulation, const VirtualCoupling* coupling);

  /// Adds a row for each invariant, and the bits of everything.
  void judge(Report& report, const Simulation& simulation) const;

  void on_step(const ObservedStep& step) noexcept override;

  // --- looking at it ------------------------------------------------------------------------------------------------
  template <class Of>
  [[nodiscard]] double most(const Span& span, const Of& of) const {
    if (span.size() == 0) return std::numeric_limits<double>::quiet_NaN();  // which meets no demand
    double value = -std::numeric_limits<double>::infinity();
    for (std::size_t n = span.first; n < span.last; ++n) value = std::max(value, double(of(ticks[n])));
    return value;
  }
  template <class Of>
  [[nodiscard]] double least(const Span& span, const Of& of) const {
    return -most(span, [&](const Tick& tick) { return -double(of(tick)); });
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
  /// [1] standard deviation about a straight line through the span, over the mean: of a force that may drift slowly.
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
  [[nodiscard]] Span within(double from, double to) const;  ///< [s] of Tick::time
  [[nodiscard]] const Tick& at(double time) const;          ///< the last tick that is not later

 private:
  void judge_energy(Report& report) const;
  void look_at_energy(const Tick& tick, double voxel);

  EnergyLedger start_;
  double stored_at_start_ = 0;                                      // [J]
  double turnover_ = 0;                                             // [J] of hand and motor, to and fro
  double min_given_ = 0;                                            // [J] lowest that hand and motor had given, of all
  double max_entered_ = 0;                                          // [J]
  double step_error_ = 0;                                           // [J] of `entered`, that vanishes with the step
  double hand_given_ = 0, min_hand_given_ = 0, hand_turnover_ = 0;  // [J] at the device, motor included
  double unexplained_ = 0;                                          // [1] of the coupling's turnover
  double allowed_depth_ = 0, deepest_ = 0;                          // [m] of solid material in the head
  double unfelt_ = 0;                                               // [m^3] cut while nothing was felt
  double max_felt_ = 0, max_applied_ = 0, max_torque_ = 0;          // [N], [N·m]
  double max_power_ = 0, excess_power_ = 0;                         // [W] and beyond the motor's characteristic
  double rotor_speed_ = 0, motor_work_ = 0;                         // [rad/s], [J] after the last step
  double lent_ = 0;                                                 // [J] by the rotor
  bool has_begun_ = false;
  bool probing_;
  Mat3 turn_;  // of the scene: ticks are told as if it were not turned
};

inline double force_of(const Tick& tick) { return tick.felt.force.norm(); }
inline double thrust_of(const Tick& tick) { return tick.felt.force.z(); }
inline double side_of(const Tick& tick) { return tick.felt.force.head<2>().norm(); }
inline double removed_of(const Tick& tick) { return tick.removed; }

inline void demand_steady(Report& report, const Story& story, const Span& span,
                          const std::string& demand = "sd of the steady force") {
  report.at_most(demand, 100 * story.unsteadiness(span, force_of), 5, "%", "of its mean, about a straight line");
}

}  // namespace hapticut::gestures
