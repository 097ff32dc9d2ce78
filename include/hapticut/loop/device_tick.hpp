// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/arming.hpp"

namespace hapticut {

/// The device's side of a step.
struct DeviceTick {
  DeviceState state;
  DeviceOutput output;
  ArmingState arming = ArmingState::off;
};

constexpr auto fields_of(Of<DeviceTick>) {
  return std::tuple{
      field("state", &DeviceTick::state, "the reading that led to the step, as the guard let it through"),
      field("output", &DeviceTick::output, "what the device rendered until then"),
      field("arming", &DeviceTick::arming, "of the guard until then"),
  };
}

}  // namespace hapticut
