// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <hdsim.h>

#include <array>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>

#include "hapticut/device/open_haptics.hpp"
#include "support/device_runs.hpp"

/// @file
/// Runs of OpenHaptics devices against the stand-in. The test drives the clock.
namespace hapticut::test {

inline OpenHapticsOptions options_for(const char* name = "") {
  OpenHapticsOptions options;
  options.device_name = name;
  options.clock = hdsim_time;
  options.start_timeout = options.silence = 60;  // this machine may be busy
  return options;
}

inline void place(int device, const Pose& X, const Vec3& velocity = Vec3::Zero()) {
  std::array<double, 16> m{};
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) m[std::size_t(4 * column + row)] = X.rotation(row, column);
  for (int axis = 0; axis < 3; ++axis) m[std::size_t(12 + axis)] = 1000 * X.translation[axis];
  m[15] = 1;
  hdsim_set_transform(device, m.data());
  const Vec3 v = 1000 * velocity;
  hdsim_set_velocity(device, v.data());
}

inline Wrench committed(int device) {
  Wrench w;
  hdsim_get_committed_force(device, w.force.data(), w.torque.data());
  return w;
}

/// The n-th command of a run.
inline Wrench committed(int device, long n) {
  Wrench w;
  hdsim_get_committed(device, n, w.force.data(), w.torque.data());
  return w;
}

inline Vec3 rendered(int device) {
  Vec3 force;
  hdsim_get_rendered_force(device, force.data());
  return force;
}

/// The outcome of `run_in_ticks`.
struct OpenHapticsOutcome {
  RunReport report;
  std::exception_ptr exception;
};

/// Runs a device in a separate thread until the run has ended. The calling thread drives the clock.
inline OpenHapticsOutcome run_in_ticks(Device& device, const DeviceCallback& callback, const RunOptions& options,
                                       const std::function<void(long tick)>& before_tick) {
  OpenHapticsOutcome outcome;
  std::atomic<bool> ended{false};
  std::thread runner([&] {
    try {
      outcome.report = device.run(callback, options);
    } catch (...) {
      outcome.exception = std::current_exception();
    }
    ended = true;
  });
  for (long tick = 0; !ended;) {
    if (hdsim_is_running() == 0) {
      std::this_thread::yield();
      continue;
    }
    if (before_tick) before_tick(tick);
    if (hdsim_run_ticks(1) > 0)
      ++tick;
    else
      std::this_thread::yield();
  }
  runner.join();
  return outcome;
}

class OpenHapticsTest : public testing::Test {
 protected:
  void SetUp() override { hdsim_reset(); }
  void TearDown() override { hdsim_reset(); }

  static int add_touch(const char* name = "Default Device") {
    const hdsim_device touch = hdsim_touch(name);
    return hdsim_add_device(&touch);
  }
  static int add_premium(const char* name = "Default Device") {
    const hdsim_device premium = hdsim_premium6dof(name);
    return hdsim_add_device(&premium);
  }

  using Outcome = OpenHapticsOutcome;
  static Outcome run(Device& device, const DeviceCallback& callback, const RunOptions& options = quick(),
                     const std::function<void(long tick)>& before_tick = nullptr) {
    return run_in_ticks(device, callback, options, before_tick);
  }
};

}  // namespace hapticut::test
