// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/simulation/step.hpp"

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

/// Keeps what went into the steps of a simulation and what came out: what a loop is given to have itself recorded.
/// hapticut/io/recording/recorder.hpp has the one that writes files.
///
///     recorder.before_step();  simulation.step(pose, velocity, dt);  recorder.after_step(nullptr);
///
/// In between anybody may make the step; none, or more than one, is no step to be recorded. A VirtualCoupling is given
/// the recorder, for it may make more than one step a tick.
class StepRecorder {
 public:
  virtual ~StepRecorder() = default;

  /// @realtime no allocation, no lock beyond what the recorder says
  virtual void before_step() noexcept = 0;

  /// @param device  null: no device is involved
  /// @realtime no allocation, no lock beyond what the recorder says
  virtual void after_step(const DeviceTick* device) noexcept = 0;
};

}  // namespace hapticut
