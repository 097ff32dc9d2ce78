// SPDX-License-Identifier: Apache-2.0
// Contract of every device with the loop: the exchange of reading and force does not allocate.
#include <gtest/gtest.h>

#include "support/allocation_count.hpp"
#include "support/devices_under_test.hpp"

namespace hapticut::device_allocation_test {
namespace {

using namespace test;

class DeviceAllocation : public DeviceContractTest {};

TEST_P(DeviceAllocation, AllocatesNothingInTheLoopAndTakesNoLock) {
  constexpr long kFrom = 10, kTo = 9000;
  tested.script = [](long tick) { return ScriptedTick{Pose::from_translation(Vec3(1e-6 * double(tick), 0, 0))}; };
  const auto device = tested.open();
  CallCounts counts;
  RunOptions options = quick();
  options.guard.arming.ramp = options.guard.arming.short_ramp = 0.05;
  const RunReport report = tested.run(
      *device,
      [&, n = 0L](const DeviceState& state) mutable {
        ++n;
        if (n == kTo) counts = disarm_call_counts();
        DeviceCommand command = through_the_guard(n, state, 0.04);
        command.stop = n >= kTo;
        if (n == kFrom) arm_call_counts();
        return command;
      },
      options);
  EXPECT_EQ(report.ticks, std::uint64_t(kTo));
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.deallocations, 0);
  EXPECT_TRUE(counts.locks == 0 || traits().is_makers) << "the replacements of makers' libraries lock";
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::saturated)] > 0, traits().has_motors);
  EXPECT_GT(report.events[std::size_t(SafetyEvent::force_not_finite)], 0U);
}

INSTANTIATE_TEST_SUITE_P(Devices, DeviceAllocation, testing::ValuesIn(devices_under_test()), kNameOfDevice);

}  // namespace
}  // namespace hapticut::device_allocation_test
