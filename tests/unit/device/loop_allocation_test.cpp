// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <hdsim.h>

#include <atomic>
#include <limits>
#include <thread>

#include "hapticut/device/mock.hpp"
#include "hapticut/device/open_haptics.hpp"
#include "support/allocation_count.hpp"

namespace hapticut {
namespace {

/// A callback that counts what happens in its thread between two of its calls: the whole loop around it.
struct CountingCallback {
  long from, to, n = 0;
  test::CallCounts* counts;
  DeviceCommand operator()(const DeviceState& state) {
    ++n;
    if (n == to) *counts = test::disarm_call_counts();
    DeviceCommand command;
    // In and out of contact, saturated, not finite: every branch of the guard that does not end the run.
    if (n > 50 && n % 400 > 100) command.wrench.force = Vec3(0.02 * double(n % 400), 0, 0);
    if (n % 777 == 0) command.wrench.force.x() = std::numeric_limits<double>::quiet_NaN();
    command.wrench.torque = Vec3(0, 0, 1e-3 * state.X_BS.translation.x());
    command.stop = n >= to;
    if (n == from) test::arm_call_counts();
    return command;
  }
};

RunOptions quick() {
  RunOptions options;
  options.stop_on_signals = false;
  options.guard.arming.ramp = options.guard.arming.short_ramp = 0.05;
  return options;
}

TEST(LoopOfAMock, AllocatesNothingAndTakesNoLock) {
  test::CallCounts counts;
  RunOptions options = quick();
  options.simulated_time = true;
  const RunReport report = open_device("mock:spiral,hand=nominal-pad,device=premium6dof")
                               ->run(CountingCallback{10, 9000, 0, &counts}, options);
  EXPECT_EQ(report.ticks, 9000U);
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.deallocations, 0);
  EXPECT_EQ(counts.locks, 0);
  EXPECT_GT(report.events[std::size_t(SafetyEvent::saturated)], 0U);
}

TEST(LoopOfOpenHaptics, AllocatesNothing) {
  hdsim_reset();
  const hdsim_device premium = hdsim_premium6dof("Default Device");
  hdsim_add_device(&premium);
  OpenHapticsOptions options;
  options.clock = hdsim_time;
  const auto device = open_open_haptics(options);
  test::CallCounts counts;
  std::atomic<bool> ended{false};
  std::thread runner([&] {
    device->run(CountingCallback{10, 9000, 0, &counts}, quick());
    ended = true;
  });
  while (!ended) {
    if (hdsim_run_ticks(1) == 0) std::this_thread::yield();
  }
  runner.join();
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.deallocations, 0);
}

}  // namespace
}  // namespace hapticut
