// SPDX-License-Identifier: Apache-2.0
#include "hapticut/realtime/realtime.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "hapticut/realtime/histogram.hpp"
#include "hapticut/realtime/triple_buffer.hpp"

namespace hapticut::realtime_test {
namespace {

TEST(LatencyHistogram, KnowsItsQuantilesWithinABucket) {
  LatencyHistogram h;
  for (int n = 1; n <= 1000; ++n) h.add(n * 1e-6 - 0.5e-6);
  EXPECT_EQ(h.count(), 1000U);
  EXPECT_NEAR(h.quantile(0.5), 500e-6, 1e-6);
  EXPECT_NEAR(h.quantile(0.99), 990e-6, 1e-6);
  EXPECT_NEAR(h.min(), 0.5e-6, 1e-12);
  EXPECT_NEAR(h.mean(), 500e-6, 1e-9);
  h.add(0.5);
  EXPECT_EQ(h.longer(), 1U);
  EXPECT_EQ(h.quantile(1), 0.5);
  EXPECT_EQ(h.max(), 0.5);
}

TEST(LatencyHistogram, KnowsLongDurationsWithinAFewPerCent) {
  for (const double scale : {2.1e-3, 3e-3, 40e-3, 7.0, 50.0}) {  // [s]
    LatencyHistogram h;
    for (int n = 0; n < 1000; ++n) h.add(scale * (1 + 0.001 * n));
    h.add(120);
    for (const double fraction : {0.01, 0.5, 0.9, 0.99}) {
      const double exact = scale * (1 + fraction);
      EXPECT_GE(h.quantile(fraction), exact * (1 - 2e-3)) << scale << ' ' << fraction;
      EXPECT_LE(h.quantile(fraction), exact * (1.045 + 2e-3)) << scale << ' ' << fraction;
      EXPECT_LE(h.at_least(exact), 1002 - 1000 * fraction) << scale << ' ' << fraction;
      EXPECT_GE(h.at_least(exact), 1000 * (1 - fraction) - 90) << scale << ' ' << fraction;
    }
    EXPECT_EQ(h.quantile(1), 120);
  }
  LatencyHistogram of_4_ms;
  for (const double seconds : {1e-3, 3e-3, 4.2e-3, 4e-3}) of_4_ms.add(seconds);
  EXPECT_EQ(of_4_ms.at_least(4e-3), 2U);
  EXPECT_EQ(of_4_ms.at_least(1e-3), 4U);
  EXPECT_EQ(of_4_ms.at_least(1e6), 0U);
}

TEST(LatencyHistogram, TakesOddDurationsWithoutHarm) {
  LatencyHistogram h;
  EXPECT_EQ(h.quantile(0.5), 0);
  EXPECT_EQ(h.min(), 0);
  h.add(-1e-6);
  h.add(std::numeric_limits<double>::quiet_NaN());
  h.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(h.count(), 3U);
  EXPECT_EQ(h.longer(), 2U);
}

TEST(TripleBuffer, NeverShowsHalfAValueNorAnOlderOneToAnotherThread) {
  using Value = std::array<long, 64>;
  TripleBuffer<Value> buffer;
  constexpr long kLast = 200000;
  std::thread writer([&] {
    for (long n = 1; n <= kLast; ++n) {
      buffer.writing().fill(n);
      buffer.publish();
    }
  });
  long seen = 0;
  while (seen < kLast) {
    const Value& value = buffer.latest();
    ASSERT_GE(value[0], seen);
    for (const long part : value) ASSERT_EQ(part, value[0]);
    seen = value[0];
  }
  writer.join();
}

TEST(PeriodicClock, SkipsWhatItMissedInsteadOfCatchingUp) {
  PeriodicClock clock(1e-3);
  const double begin = monotonic_time();
  while (monotonic_time() < begin + 20e-3) {
  }
  const PeriodicClock::Tick late = clock.wait();
  EXPECT_GE(late.missed, 18U);
  EXPECT_GE(late.late, 18e-3);
  const double before = clock.now();
  const PeriodicClock::Tick next = clock.wait();
  EXPECT_GT(next.time, before - 1e-3);
  // Ticks are at whole periods after the start: the time minus the lateness is a whole number of periods.
  const double phase = (next.time - next.late) / 1e-3;
  EXPECT_NEAR(phase, std::round(phase), 1e-6);
  EXPECT_THROW(PeriodicClock(0), Error);
}

TEST(RealtimeScope, MakesDenormalsZeroAndPutsTheThreadBack) {
  volatile double tiny = std::numeric_limits<double>::min();
  {
    RealtimeOptions options;
    options.priority = 0;
    options.lock_memory = false;
    const RealtimeScope scope(options);
    EXPECT_TRUE(scope.warnings().empty());
    EXPECT_EQ(tiny / 4, 0);
  }
  EXPECT_GT(tiny / 4, 0);
}

TEST(RealtimeScope, SaysWhatIsNotPermittedAndRefusesNonsense) {
  RealtimeOptions options;
  options.priority = 100;
  EXPECT_THROW(RealtimeScope{options}, Error);
  options.priority = 80;
  options.lock_memory = false;
  options.cpu = 1000;  // does not exist
  const RealtimeScope scope(options);
  ASSERT_FALSE(scope.warnings().empty());
  EXPECT_NE(scope.warnings().front().find("processor 1000"), std::string::npos) << scope.warnings().front();
}

}  // namespace
}  // namespace hapticut::realtime_test
