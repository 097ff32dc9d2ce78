// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/force/effects/output_limits.hpp"
#include "hapticut/safety/device_state.hpp"

namespace hapticut {

/// The limits of a device's output, for SimulationConfig::effects in a custom loop: the peak force and torque of the
/// device, and the minimum growth at which the stiffest wall that it promises stays passive (min_force_growth). A
/// RealtimeLoop does not need them, because SafetyGuard enforces the same limits and more. If the device has no motors
/// for torque, the torque is not limited.
/// @param max_contact_speed  [m/s] > 0 at which the tool meets a surface
/// @throws Error when the device renders no force
[[nodiscard]] OutputLimits output_limits(const DeviceCapabilities& device, double max_contact_speed = 0.5);

}  // namespace hapticut
