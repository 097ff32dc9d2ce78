// SPDX-License-Identifier: Apache-2.0
// Devices that are slower than the loop: they report each reading several times, with the same sequence number.
#include <gtest/gtest.h>

#include <cmath>

#include "support/guarded_loop.hpp"

namespace hapticut::slow_device_test {
namespace {

using test::GuardedLoop;
using test::kPeriod;

/// A loop of 1 kHz whose device makes `rate` readings a second.
class SlowLoop : public GuardedLoop {
 public:
  explicit SlowLoop(double rate) : rate_(rate) {}

  /// The device's clock stands between its readings.
  Wrench slow_tick(const Vec3& force = Vec3::Zero()) {
    const auto latest = std::uint64_t(std::floor(double(++tick_) * kPeriod * rate_ + 1e-9)) + 1;
    if (latest != reading.sequence) {
      reading.sequence = latest;
      reading.time = double(latest - 1) / rate_;
      reading.X_BS.translation.x() = 0.02 * std::sin(5 * reading.time);
    }
    guard.admit(reading);
    return guard.limit({force, Vec3::Zero()}, contact);
  }

 private:
  double rate_;
  std::uint64_t tick_ = 0;
};

TEST(SlowDevice, ArmsAndRendersForcesAtEveryRateThatTheGuardHolds) {
  for (const double rate : {60.0, 100.0, 250.0, 333.0, 500.0, 667.0, 875.0, 999.0}) {
    SlowLoop loop(rate);
    int ticks = 0;
    while (loop.guard.state() != ArmingState::on && ticks < 5000) loop.slow_tick(), ++ticks;
    EXPECT_EQ(loop.guard.state(), ArmingState::on) << rate << " Hz";
    Wrench felt;
    for (int n = 0; n < 1000; ++n) felt = loop.slow_tick({0, 0, 1});
    EXPECT_NEAR(felt.force.z(), 1, 1e-9) << rate << " Hz";
    EXPECT_EQ(loop.guard.state(), ArmingState::on) << rate << " Hz";
  }
}

TEST(SlowDevice, IsNamedOnceInTheLogAndCountedInEveryTick) {
  SlowLoop loop(500);
  for (int n = 0; n < 3000; ++n) loop.slow_tick();
  EXPECT_GT(loop.count(SafetyEvent::reading_stale), 1000U);
  std::vector<SafetyLogEntry> entries = loop.guard.log().drain();
  std::erase_if(entries, [](const SafetyLogEntry& e) { return e.event != SafetyEvent::reading_stale; });
  ASSERT_EQ(entries.size(), 1U);
  const std::string sentence = sentence_of(entries[0]);
  EXPECT_NE(sentence.find("a device slower than the loop"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("cable"), std::string::npos) << sentence;
}

TEST(SlowDevice, ThatStopsIsAFaultAfterTheHoldTime) {
  SlowLoop loop(500);
  for (int n = 0; n < 5000; ++n) loop.slow_tick();
  ASSERT_EQ(loop.guard.state(), ArmingState::on);
  int ticks = 0;
  for (; loop.guard.state() == ArmingState::on && ticks < 100; ++ticks) {
    loop.reading.time += kPeriod;  // its clock goes on, the reading stays
    loop.guard.admit(loop.reading);
    loop.guard.limit({});
  }
  EXPECT_EQ(loop.guard.state(), ArmingState::fault);
  EXPECT_NEAR(ticks, 20, 3);
}

TEST(SlowDevice, ThatNeverReadsAnewStaysArmedWithoutForce) {
  GuardedLoop loop;
  for (int n = 0; n < 100; ++n) {
    loop.guard.admit(loop.reading);
    EXPECT_TRUE(loop.guard.limit({Vec3(0, 0, 1), Vec3::Zero()}, {}).force.isZero(0));
  }
  EXPECT_EQ(loop.guard.state(), ArmingState::armed);
}

// A simulated hand does not tremble, so its position stands exactly.
TEST(SimulatedDevice, MayRotateInPlace) {
  SafetyGuard guard(capabilities(device_model("touch")), {});
  guard.start();
  DeviceState reading;
  for (int n = 0; n < 4000; ++n) {
    reading.time += kPeriod;
    ++reading.sequence;
    reading.X_BS.rotation = rotation_from_vector(Vec3(0, 0, 0.5 * std::sin(0.01 * n)));
    guard.admit(reading);
    guard.limit({});
  }
  EXPECT_EQ(guard.state(), ArmingState::on);
  EXPECT_EQ(guard.log().count(SafetyEvent::pose_frozen), 0U);
}

}  // namespace
}  // namespace hapticut::slow_device_test
