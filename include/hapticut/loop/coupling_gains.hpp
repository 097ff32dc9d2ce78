// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/core/abi.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// Gains for a device, from what it says that it renders: its stiffness; critical damping of the tool, but no more than
/// the damping of the device; and limits at its peak force and torque. The tool's inertia is scaled with its mass.
/// @param mass  [kg] of the simulated tool; by default 0.05, or less if the device's damping would be below 0.7 of the
/// critical damping
/// @throws Error when the device states no stiffness; when a tool of this mass would ring, with less than half of the
/// critical damping (the message gives the largest mass that does not ring); or when the default mass would be below a
/// gram
[[nodiscard]] CouplingGains coupling_gains(const DeviceCapabilities& device, std::optional<double> mass = {});

}  // namespace hapticut
