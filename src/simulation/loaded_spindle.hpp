// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/simulation/spindle_drive.hpp"

namespace hapticut {

/// The spindle in the step: its motor, and the load of the contact on it.
class LoadedSpindle final : public SpindleDrive {
 public:
  using SpindleDrive::SpindleDrive;

  /// Takes the spindle of another tool, which stays held if the old one was.
  void exchange(const Spindle& spindle) noexcept;

  [[nodiscard]] const SpindleMotor& motor() const noexcept { return motor_; }
  [[nodiscard]] bool is_off() const noexcept { return motor_.setting() == 0 && motor_.speed() == 0; }

  void begin_step() noexcept;
  [[nodiscard]] bool was_halted() const noexcept { return was_halted_; }  ///< before this step
  [[nodiscard]] bool was_set() const noexcept { return was_set_; }        ///< before this step, after its last halt

  [[nodiscard]] bool knows_load(double hand_speed) const noexcept;
  void expect_load(double torque, double hand_speed, double dt) noexcept;
  void load(double torque, double dt) noexcept;
  /// Sets the torque [N·m] of the contact, but not the speed under it.
  void keep_torque(double torque) noexcept { load_.torque = torque; }
  [[nodiscard]] double torque() const noexcept { return load_.torque; }  ///< [N·m] about +z
  void advance(double dt, bool in_contact) noexcept;

  [[nodiscard]] double cutting_share(double radius) const noexcept;
  [[nodiscard]] double turning_spin(double radius) const noexcept;
  /// [N·m] Torque that turns the head, for the one that the contact has while a share [1] of the cutting ratio acts.
  [[nodiscard]] double torque_to_spin(double torque, double share) const noexcept {
    return motor_.stalled() ? torque / share : torque;
  }

 private:
  friend struct SimulationMemory;

  /// The load of the contact on the motor.
  struct Load {
    double torque = 0;        // [N·m] about +z; of a stalled head, the torque that would turn it
    double hand_speed = 0;    // [m/s] maximum speed of the head's points without the spin
    double first_torque = 0;  // [N·m] prediction from the sub-step before
    double first_speed = 0;   // [rad/s] speed of the motor under that torque
    bool settled = false;     // the prediction was nearly right
  };

  Load load_;
  bool was_halted_ = false, was_set_ = false;
};

}  // namespace hapticut
