// SPDX-License-Identifier: Apache-2.0
#include "force_dimension/tests/force_dimension.hpp"
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
        DeviceCommand command = through_the_guard(n, state, 0.02);
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
  EXPECT_GT(dhdsim_get_counters(0).enables, 5)
      << "the forces must be switched on again, otherwise the test checks nothing";
}

}  // namespace
}  // namespace hapticut::force_dimension_allocation_test
