// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/arming.hpp"

namespace hapticut {

/// The device's side of a step.
struct DeviceTick {
  DeviceState state;                      ///< the reading that led to the step, as the guard let it through
  DeviceOutput output;                    ///< what the device rendered until then
  ArmingState arming = ArmingState::off;  ///< of the guard until then
};

}  // namespace hapticut
