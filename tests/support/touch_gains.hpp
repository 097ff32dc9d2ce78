// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"

namespace hapticut::test {

/// Gains of a coupling for a Touch.
/// @param mass  [kg] of the tool; empty: the default
[[nodiscard]] inline CouplingGains touch_gains(std::optional<double> mass = {}) {
  return coupling_gains(capabilities(device_model("touch")), mass);
}

}  // namespace hapticut::test
