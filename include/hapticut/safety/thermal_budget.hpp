// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// When the motors count as too warm.
struct ThermalOptions {
  double time_constant = 60;
  double warm = 1.0;
  double cool = 0.8;
  double hot = 0.7;
  double cold = 0.5;
  double rate = 1.0;
};

constexpr auto fields_of(Of<ThermalOptions>) {
  using O = ThermalOptions;
  return std::tuple{
      field("time_constant", &O::time_constant, "s", Range::positive(),
            "over which the mean of the squared force is taken"),
      field("warm", &O::warm, "1", Range::positive(), "of the continuous force squared at which the force is reduced"),
      field("cool", &O::cool, "1", Range::not_negative(), "at which it may grow again, not above warm"),
      field("hot", &O::hot, "1", Range::between(0, 1), "of a measured temperature at which the force is reduced"),
      field("cold", &O::cold, "1", Range::between(0, 1), "at which it may grow again, not above hot"),
      field("rate", &O::rate, "1/s", Range::positive(), "at which the limit shrinks and grows: 0.001 a tick at 1 kHz"),
  };
}

/// A limit on the force that keeps the motors from overheating: peak force while they are cool, falling to the
/// continuous force when the temperature that the device measures says so, or, where it measures none, the mean of the
/// squared force.
/// @realtime no allocation, no lock
class ThermalBudget {
 public:
  /// @param peak        [N] the limit of cool motors; 0: no motors
  /// @param continuous  [N] what they bear for ever; 0: unknown, no limit but by a measured temperature
  /// @throws Error when an option is out of range
  ThermalBudget(double peak, double continuous, const ThermalOptions& options);

  /// [N] that may be applied now.
  [[nodiscard]] double limit() const { return limit_; }

  /// Accounts for a tick.
  /// @param force        [N] that was applied
  /// @param temperature  [1] that the device measured; 0: not measured
  void tick(double force, double temperature, double dt) noexcept;

 private:
  ThermalOptions options_;
  double peak_, continuous_;
  double limit_;
  double heat_ = 0;  // [1] mean of (F / continuous)^2
  bool limiting_ = false;
};

}  // namespace hapticut
