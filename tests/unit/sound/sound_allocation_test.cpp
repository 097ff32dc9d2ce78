// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "hapticut/sound/drill_sound.hpp"
#include "support/allocation_count.hpp"

namespace hapticut::sound_allocation_test {
namespace {

TEST(DrillSound, AllocatesAndLocksNothing) {
  DrillSound sound;
  std::array<float, 480> samples;
  test::arm_call_counts();
  for (int n = 0; n < 200; ++n)
    sound.render(samples, n == 7 ? -1.0 : 48'000.0, {n < 100 ? 4000.0 : 0.0, 0.01 * n, 1e-9, n % 20 > 10});
  const test::CallCounts counts = test::disarm_call_counts();
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.deallocations, 0);
  EXPECT_EQ(counts.locks, 0);
}

}  // namespace
}  // namespace hapticut::sound_allocation_test
