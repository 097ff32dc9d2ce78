// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/safety/arming.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// Lets a spindle turn only while the hand feels what it cuts: it stands while the guard holds the force back, and from
/// then on until the tool has touched nothing. SimulationModel has one; a loop of one's own asks it before each step:
///
///     SpindleInterlock interlock;
///     device->run([&](const DeviceState& state) {
///       interlock.update(simulation, device->last_arming());
///       return DeviceCommand{coupling.step(state.X_BS, state.velocity, device->period()).hand};
///     });
///
/// After the loop it may still be held: `simulation.hold_spindle(false)` for steps without a guard.
class SpindleInterlock {
 public:
  /// Whether the spindle may turn in the coming tick.
  /// @param arming   of the guard, Device::last_arming
  /// @param touches  whether the tool touches anything, or it is not known
  bool admits(ArmingState arming, bool touches) noexcept {
    if (arming != ArmingState::ramp && arming != ArmingState::on)
      admits_ = false;
    else if (!touches)
      admits_ = true;
    return admits_;
  }

  /// Until the tool has touched nothing again.
  void interrupt() noexcept { admits_ = false; }

  /// Lets the spindle of a simulation turn in its coming step, as it was asked to, or holds it.
  void update(Simulation& simulation, ArmingState arming) noexcept {
    const StepResult& last = simulation.last_result();
    const bool touches =
        simulation.steps() == 0 || last.contact.voxels > 0 || has_any(last.status, kRejected | StepStatus::tool_waits);
    simulation.hold_spindle(!admits(arming, touches));  // not a ramp, or it would cut while it runs down
  }

 private:
  bool admits_ = false;
};

}  // namespace hapticut
