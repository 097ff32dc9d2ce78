// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cmath>
#include <functional>
#include <vector>

#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/device_models.hpp"

/// @file
/// A device that records the forces written to it, and options for its runs.
namespace hapticut::test {

/// Options with a real clock, without privileges, and with quick arming.
inline RunOptions real(double seconds) {
  RunOptions options;
  options.seconds = seconds;
  options.realtime.priority = 0;
  options.realtime.lock_memory = false;
  options.guard.arming.ramp = 0.02;
  return options;
}

/// Records the written forces, and can simulate faults.
class WrittenDevice : public PolledDevice {
 public:
  WrittenDevice() : PolledDevice("written", capabilities_of_a_touch()) {}
  std::vector<Vec3> forces;
  std::function<bool(DeviceState&)> next = [](DeviceState&) { return true; };
  std::function<void(const Vec3&)> on_write = [](const Vec3&) {};
  std::function<void(double)> on_scale = [](double) {};
  std::atomic<double> share{1};

 protected:
  static DeviceCapabilities capabilities_of_a_touch() { return hapticut::capabilities(device_model("touch")); }
  bool read(DeviceState& state) noexcept override {
    ++state.sequence;
    state.time = double(state.sequence) * 1e-3;
    return next(state);
  }
  Wrench write(const Wrench& wrench) noexcept override {
    forces.push_back(wrench.force);
    on_write(wrench.force);
    return wrench;
  }
  void scale_output(double s) noexcept override {
    share.store(s);
    on_scale(s);
  }
  [[nodiscard]] bool is_simulated() const override { return true; }
};

/// No force until the time `from`, when the guard is armed, and then 1 N. The tool is free for 50 ms in every 300 ms:
/// where the machine paused the loop, the guard waits for that.
inline DeviceCallback pushing(double from = 0.1) {
  return [=](const DeviceState& state) {
    DeviceCommand command;
    if (state.time > from && std::fmod(state.time - from, 0.3) < 0.25) command.wrench.force.x() = 1;
    return command;
  };
}

}  // namespace hapticut::test
