// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// The spindle of a simulation, as a program controls it between two steps: `simulation.spindle().halt()`.
class SpindleDrive {
 public:
  /// A spindle that turns at its speed.
  explicit SpindleDrive(const Spindle& spindle) noexcept : motor_(spindle) {}

  /// Sets the spindle's speed for the following steps. With Spindle::acceleration_limit it is reached on a ramp. A
  /// motor that is slowed by its load, or stalled, starts again even if that speed is the present one.
  /// @throws Error when it is faster than kMaxSpindleSpeed or not finite
  void set_speed(AngularSpeed speed);

  /// Stops the spindle at once, without its ramp.  @realtime no allocation, no lock; O(1)
  void halt() noexcept;

  /// Holds the spindle at standstill whatever its setting, or lets it turn at its setting again. While it is held,
  /// nothing is crushed either. The guard of a loop holds it while the hand feels nothing (SpindleInterlock).
  /// @realtime no allocation, no lock; O(1)
  void hold(bool hold) noexcept;
  [[nodiscard]] bool is_held() const noexcept { return held_; }

  /// [rad/s] The last speed setting. The actual speed is StepResult::spindle, which differs while the spindle ramps, is
  /// loaded or is held.
  [[nodiscard]] AngularSpeed setting() const noexcept {
    return held_ ? AngularSpeed::in_rad_per_s(held_setting_) : motor_.setting();
  }

 protected:
  void stop() noexcept;
  void start(double setting) noexcept;

  SpindleMotor motor_;
  bool held_ = false;        // at standstill
  double held_setting_ = 0;  // [rad/s] speed setting meanwhile
  bool halted_ = false;      // since the last step
  bool set_ = false;         // the speed was set since the last step, after its last halt
};

}  // namespace hapticut
