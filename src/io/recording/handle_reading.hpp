// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/io/recording/recording.hpp"

namespace hapticut {

/// The pose of the handle as a reading of a device whose base is the world, where nobody gave the device's own.
inline DeviceState reading_of_handle(const RecordedStep& step) noexcept {
  DeviceState state;
  state.X_BS = step.input.pose;
  state.velocity = step.input.velocity;
  state.time = step.time;
  state.sequence = step.number + 1;
  return state;
}

}  // namespace hapticut
