// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/safety/arming.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// Lets a spindle turn only while the hand feels what it cuts: it stands while the guard holds the force back, and from
/// then on until the tool has touched nothing. SimulationModel has one; a loop of one's own asks it before each step:
///
///     SpindleInterlock interlock(simulation.spindle_setting());
///     device->run([&](const DeviceState& state) {
///       interlock.turn(simulation, device->last_arming());
///       return DeviceCommand{coupling.step(state.X_BS, state.velocity, device->period()).hand};
///     });
class SpindleInterlock {
 public:
  /// @param speed  while it may turn
  /// @throws Error when no spindle is so fast
  explicit SpindleInterlock(AngularSpeed speed) { set_speed(speed); }

  [[nodiscard]] AngularSpeed speed() const noexcept { return speed_; }  ///< while it may turn

  /// @param speed  from the next tick on
  /// @throws Error when no spindle is so fast
  void set_speed(AngularSpeed speed) {
    validate(Spindle{speed});
    speed_ = speed;
  }

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

  /// Turns or halts the spindle of a simulation for its coming step.
  void turn(Simulation& simulation, ArmingState arming) noexcept {
    const StepResult& last = simulation.last_result();
    const bool touches =
        simulation.steps() == 0 || last.contact.voxels > 0 || has_any(last.status, kRejected | StepStatus::tool_waits);
    turn(simulation, admits(arming, touches));
  }

  /// The same where it is known already whether it may.
  void turn(Simulation& simulation, bool may) const noexcept {
    if (may && speed_ != simulation.spindle_setting()) simulation.set_spindle_speed(speed_);
    if (!may && simulation.spindle_setting() != 0) simulation.halt_spindle();  // or it would cut while it runs down
  }

 private:
  AngularSpeed speed_ = {};
  bool admits_ = false;
};

}  // namespace hapticut
