// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// The spindle of a simulation, as a program controls it between two steps: `simulation.spindle().halt()`.
class SpindleDrive {
 public:
  /// A spindle that turns at its speed, and whose load is not known yet.
  explicit SpindleDrive(const Spindle& spindle) noexcept : motor_(spindle) {}

  /// Sets the spindle's speed for the following steps. With Spindle::acceleration_limit it is reached on a ramp. A
  /// motor that is slowed by its load, or stalled, starts anew even if that speed is the present one.
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

 private:
  friend class Simulation;
  friend struct SimulationMemory;

  /// The load of the contact on the motor.
  struct Load {
    double torque = 0;        // [N·m] about +z; of a stalled head, the torque that would turn it
    double hand_speed = 0;    // [m/s] maximum speed of the head's points without the spin
    double first_torque = 0;  // [N·m] prediction from the sub-step before
    double first_speed = 0;   // [rad/s] speed of the motor under that torque
    bool settled = false;     // the prediction was nearly right
  };

  void stop() noexcept;
  void start(double setting) noexcept;
  void exchange(const Spindle& spindle) noexcept;
  void begin_step() noexcept;
  void load(double torque, double dt) noexcept;
  [[nodiscard]] bool knows_load(double hand_speed) const noexcept;
  void expect_load(double torque, double hand_speed, double dt) noexcept;
  void advance(double dt, bool in_contact) noexcept;
  [[nodiscard]] double cutting_share(double radius) const noexcept;
  [[nodiscard]] double turning_spin(double radius) const noexcept;
  [[nodiscard]] bool is_off() const noexcept { return motor_.setting() == 0 && motor_.speed() == 0; }

  SpindleMotor motor_;
  Load load_;
  bool held_ = false;        // at standstill
  double held_setting_ = 0;  // [rad/s] speed setting meanwhile
  bool halted_ = false;      // since the last step
  bool was_halted_ = false;  // before this step
  bool set_ = false;         // the speed was set since the last step, after its last halt
  bool was_set_ = false;     // likewise before this step
};

}  // namespace hapticut
