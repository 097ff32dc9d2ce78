// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/spindle.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const Spindle& spindle) {
  const auto refuse = [](const char* field, double value, const char* unit, const char* rule) {
    throw Error("Spindle::" + std::string(field) + " = " + format_number(value) + " " + unit + "; must be " + rule);
  };
  if (!(std::abs(spindle.speed) <= kFastestSpindle))
    refuse("speed", spindle.speed, "rad/s", "between -1e+06 and 1e+06. Give 0 for a standing spindle.");
  if (!(spindle.power_limit > 0))
    refuse("power_limit", spindle.power_limit, "W", "> 0. Leave it at infinity for a motor without a limit.");
  if (!(spindle.acceleration_limit > 0))
    refuse("acceleration_limit", spindle.acceleration_limit, "rad/s^2",
           "> 0. Leave it at infinity for a motor that reaches its speed at once.");
  if (!(spindle.droop >= 0) || !std::isfinite(spindle.droop))
    refuse("droop", spindle.droop, "rad/(s N m)", ">= 0 and finite. Leave it at 0 for a motor that keeps its speed.");
}

}  // namespace hapticut
