// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/device_state.hpp"

namespace hapticut {

/// The device data of a step.
struct DeviceTick {
  DeviceState state;                      ///< the reading that led to the step, as admitted by the guard
  DeviceOutput output;                    ///< output of the device until the step
  ArmingState arming = ArmingState::off;  ///< state of the guard until the step
};

constexpr auto fields_of(Of<DeviceTick>) {
  return std::tuple{
      field("state", &DeviceTick::state, "the reading that led to the step, as admitted by the guard"),
      field("output", &DeviceTick::output, "output of the device until the step"),
      field("arming", &DeviceTick::arming, "state of the guard until the step"),
  };
}

}  // namespace hapticut
