// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/plant.hpp"

/// @file
/// Runs of makers' devices against a stand-in of their SDK.
namespace hapticut::test {

/// Options with quick arming and no signals; the clock is that of the stand-in.
inline RunOptions quick() {
  RunOptions options;
  options.stop_on_signals = false;
  options.guard.arming.ramp = options.guard.arming.short_ramp = 0.02;
  options.guard.watchdog.fade_after = 9;  // [s] wall-clock time; long, because the machine may be busy
  options.guard.watchdog.fault = 10;
  return options;
}

/// No force until the guard is armed, then 1 N to the right, for `ticks` ticks.
inline DeviceCallback push_for(long ticks, Wrench wrench = {Vec3(1, 0, 0), Vec3::Zero()}) {
  return [=, n = 0L](const DeviceState&) mutable {
    DeviceCommand command;
    if (++n > 50) command.wrench = wrench;
    command.stop = n >= ticks;
    return command;
  };
}

/// 1 N to the right, except in the first 50 ticks and from `free` to `again`.
inline DeviceCallback press_and_release(long free, long again, long ticks) {
  return [=, n = 0L](const DeviceState&) mutable {
    DeviceCommand command;
    ++n;
    if (n > 50 && (n < free || n > again)) command.wrench.force.x() = 1;
    command.stop = n >= ticks;
    return command;
  };
}

/// A force that enters and leaves contact, saturates and is not finite. It reaches every branch of the guard that does
/// not end the run.
/// @param n       tick, from 1
/// @param growth  [N] per tick, in 300 of every 400 ticks
inline DeviceCommand through_the_guard(long n, const DeviceState& state, double growth) {
  DeviceCommand command;
  if (n > 50 && n % 400 > 100) command.wrench.force = Vec3(growth * double(n % 400), 0, 0);
  if (n % 777 == 0) command.wrench.force.x() = std::numeric_limits<double>::quiet_NaN();
  command.wrench.torque = Vec3(0, 0, 1e-3 * state.X_BS.translation.x());
  return command;
}

/// A released device that is pushed against a linear wall, and the amplitude of its oscillation there.
class NudgedPlant {
 public:
  explicit NudgedPlant(const char* device) : plant_(device_model(device), hand_model("released"), {}) {}

  /// To be called before each reading.
  /// @param acted  the force on the device since the last reading
  void before_reading(long tick, const Wrench& acted) {
    if (tick == 200) plant_.set_velocity({0, 0, -1e-3});
    const double z = std::abs(plant_.pose().translation.z());
    if (tick > 200 && tick <= 1200) first_ = std::max(first_, z);
    if (tick > 5200 && tick <= 6200) last_ = std::max(last_, z);
    if (tick > 0) plant_.advance(acted);
  }
  [[nodiscard]] Pose pose() const { return plant_.pose(); }
  [[nodiscard]] Vec3 velocity() const { return plant_.velocity().linear; }

  [[nodiscard]] static DeviceCallback wall(double stiffness) {
    return [=, n = 0](const DeviceState& state) mutable {
      DeviceCommand command;
      command.wrench.force.z() = -stiffness * state.X_BS.translation.z();
      command.stop = ++n >= 6300;
      return command;
    };
  }

  /// Options without filters: the bare loop is measured.
  [[nodiscard]] static RunOptions options() {
    RunOptions options = quick();
    options.guard.passivity.enabled = false;
    options.guard.ramp_damping = 0;
    options.guard.gate.max_speed = 100;
    return options;
  }

  /// [1] Growth of the swing within five seconds.
  [[nodiscard]] double growth() const { return last_ / first_; }

 private:
  Plant plant_;
  double first_ = 0, last_ = 0;
};

}  // namespace hapticut::test
