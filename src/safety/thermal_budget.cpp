// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/thermal_budget.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

// [1] Part of the peak force, for a device that reports warm motors but no continuous force.
constexpr double kCarefulFraction = 0.25;

}  // namespace

ThermalBudget::ThermalBudget(double peak, double continuous, const ThermalOptions& options)
    : options_(options), peak_(peak), continuous_(continuous > 0 ? std::min(continuous, peak) : 0), limit_(peak) {
  require_not_negative(peak, "DeviceCapabilities::peak_force [N]");
  require_not_negative(continuous, "DeviceCapabilities::continuous_force [N]");
  require_fields_within(options, "ThermalOptions::");
  require_between(options.cool, 0, options.warm, "ThermalOptions::cool");
  require_between(options.cold, 0, options.hot, "ThermalOptions::cold");
}

void ThermalBudget::tick(double force, double temperature, double dt) noexcept {
  const double load = continuous_ > 0 ? force / continuous_ : 0;
  heat_ += (load * load - heat_) * -std::expm1(-dt / options_.time_constant);
  const bool measured = temperature > 0;
  if (measured ? temperature > options_.hot : heat_ > options_.warm) {
    if (!limiting_) limit_ = std::min(limit_, std::max(force, continuous_));
    limiting_ = true;
  } else if (measured ? temperature < options_.cold : heat_ < options_.cool) {
    limiting_ = false;
  }
  const double floor = continuous_ > 0 ? continuous_ : kCarefulFraction * peak_;
  const double change = options_.rate * dt;
  limit_ = limiting_ ? std::max(floor, limit_ * (1 - change)) : std::min(peak_, limit_ * (1 + change));
}

}  // namespace hapticut
