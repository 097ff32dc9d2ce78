// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/device/arming.hpp"
#include "hapticut/device/state.hpp"
#include "hapticut/simulation/step.hpp"

namespace hapticut {

/// The device's side of a step.
struct DeviceTick {
  DeviceState state;                      ///< the reading that led to the step, as the guard let it through
  DeviceOutput output;                    ///< what the device rendered until then
  ArmingState arming = ArmingState::off;  ///< of the guard until then
};

/// Makes the steps of a simulation in its stead and keeps what went in and what came out: what a loop is given to have
/// itself recorded. hapticut/io/recorder.hpp has the one that writes files.
class StepRecorder {
 public:
  virtual ~StepRecorder() = default;

  /// `Simulation::step` of the simulation that is recorded.
  /// @param device  null: no device is involved
  /// @realtime no allocation, no lock beyond what the recorder says
  virtual const StepResult& step(const StepInput& input, const DeviceTick* device) noexcept = 0;
};

}  // namespace hapticut
