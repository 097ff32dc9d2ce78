// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/safety/arming.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// Lets a spindle run only while the hand feels what it cuts. The spindle stands while the guard holds the force back,
/// and afterwards until the tool has touched nothing. SimulationModel has an interlock. A custom loop calls `update`
/// before each step:
///
///     SpindleInterlock interlock;
///     device->run([&](const DeviceState& state) {
///       interlock.update(simulation, device->last_arming());
///       return DeviceCommand{coupling.step(state.X_BS, state.velocity, device->period()).hand};
///     });
///
/// After the loop the spindle may still be held. Call `simulation.spindle().hold(false)` for steps without a guard.
class SpindleInterlock {
 public:
  /// Whether the spindle may run in the coming tick.
  /// @param arming   state of the guard, Device::last_arming
  /// @param touches  whether the tool touches anything, or may touch something
  bool admits(ArmingState arming, bool touches) noexcept {
    if (arming != ArmingState::ramp && arming != ArmingState::on)
      admits_ = false;
    else if (!touches)
      admits_ = true;
    return admits_;
  }

  /// Holds the spindle until the tool has touched nothing.
  void interrupt() noexcept { admits_ = false; }

  /// Lets the spindle of a simulation run at its set speed in the coming step, or holds it.
  void update(Simulation& simulation, ArmingState arming) noexcept {
    const StepResult& last = simulation.last_result();
    const bool touches =
        simulation.steps() == 0 || last.contact.voxels > 0 || has_any(last.status, kRejected | StepStatus::tool_waits);
    simulation.spindle().hold(!admits(arming, touches));  // without a ramp, or it would cut while it slows down
  }

 private:
  bool admits_ = false;
};

}  // namespace hapticut
