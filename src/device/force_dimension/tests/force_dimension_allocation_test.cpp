// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "device/force_dimension/tests/force_dimension.hpp"
#include "support/allocation_count.hpp"

namespace hapticut::force_dimension_allocation_test {
namespace {

using namespace test;

class ForceDimensionLoop : public ForceDimensionTest {};

TEST_F(ForceDimensionLoop, AllocatesNothingAlsoWhenTheDeviceSwitchesItsForcesOffAndOn) {
  constexpr long kFrom = 10, kTo = 9000;
  add(kSigma7);
  const auto device = open_force_dimension(options_for());
  CallCounts counts;
  RunOptions options = quick();
  options.guard.arming.ramp = options.guard.arming.short_ramp = 0.05;
  const RunReport report = run(
      *device,
      [&, n = 0L](const DeviceState& state) mutable {
        ++n;
        if (n == kTo) counts = disarm_call_counts();
        DeviceCommand command;
        // In and out of contact, saturated, not finite: every branch of the guard that does not end the run.
        if (n > 50 && n % 400 > 100) command.wrench.force = Vec3(0.02 * double(n % 400), 0, 0);
        if (n % 777 == 0) command.wrench.force.x() = std::numeric_limits<double>::quiet_NaN();
        command.wrench.torque = Vec3(0, 0, 1e-3 * state.X_BS.translation.x());
        command.stop = n >= kTo;
        if (n == kFrom) arm_call_counts();
        return command;
      },
      options,
      [](long tick) {
        if (tick % 1000 == 999) dhdsim_advance(29e-3);  // its watchdog trips
      });
  EXPECT_EQ(report.ticks, std::uint64_t(kTo));
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.deallocations, 0);
  EXPECT_GT(dhdsim_get_counters(0).enables, 5) << "it must be switched on again, or the test says nothing";
}

}  // namespace
}  // namespace hapticut::force_dimension_allocation_test
