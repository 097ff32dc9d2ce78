// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// Limits at which the motors count as too warm.
struct ThermalOptions {
  double time_constant = 60;  ///< [s] time constant of the mean of the squared force
  /// [1] mean squared force over the continuous force squared, at which the force is reduced
  double warm = 1.0;
  double cool = 0.8;  ///< [1] that ratio at which the force may grow again, at most warm
  double hot = 0.7;   ///< [1] measured temperature at which the force is reduced
  double cold = 0.5;  ///< [1] measured temperature at which the force may grow again, at most hot
  double rate = 1.0;  ///< [1/s] rate at which the force limit changes: 0.001 per tick at 1 kHz
};

constexpr auto fields_of(Of<ThermalOptions>) {
  using O = ThermalOptions;
  return std::tuple{
      field("time_constant", &O::time_constant, "s", Range::positive(),
            "time constant of the mean of the squared force"),
      field("warm", &O::warm, "1", Range::positive(),
            "mean squared force over the continuous force squared, at which the force is reduced"),
      field("cool", &O::cool, "1", Range::not_negative(), "that ratio at which the force may grow again, at most warm"),
      field("hot", &O::hot, "1", Range::between(0, 1), "measured temperature at which the force is reduced"),
      field("cold", &O::cold, "1", Range::between(0, 1),
            "measured temperature at which the force may grow again, at most hot"),
      field("rate", &O::rate, "1/s", Range::positive(),
            "rate at which the force limit changes: 0.001 per tick at 1 kHz"),
  };
}

/// Limits the force so that the motors do not overheat. The limit is the peak force while the motors are cool, and
/// falls to the continuous force when they are warm. The measured temperature decides; if the device measures none, the
/// mean of the squared force decides.
/// @realtime no allocation, no lock
class ThermalBudget {
 public:
  /// @param peak        [N] limit while the motors are cool; 0: no motors
  /// @param continuous  [N] force that the motors give permanently; 0: unknown, so only a measured temperature limits
  /// @throws Error when an option is out of range
  ThermalBudget(double peak, double continuous, const ThermalOptions& options);

  /// [N] The force that may be applied now.
  [[nodiscard]] double limit() const { return limit_; }

  /// Accounts for one tick.
  /// @param force        [N] applied
  /// @param temperature  [1] measured by the device; 0: not measured
  /// @param dt           [s]
  void tick(double force, double temperature, double dt) noexcept;

 private:
  ThermalOptions options_;
  double peak_, continuous_;
  double limit_;
  double heat_ = 0;  // [1] mean of (F / continuous)^2
  bool limiting_ = false;
};

}  // namespace hapticut
