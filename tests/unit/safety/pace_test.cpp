// SPDX-License-Identifier: Apache-2.0
// Loops that are faster or slower than their period, devices with few good readings, and pauses on other clocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "hapticut/device/simulated/mock.hpp"
#include "support/guarded_loop.hpp"

namespace hapticut::pace_test {
namespace {

using test::GuardedLoop;
using test::kPeriod;

/// [s] Time of the readings until the full force is allowed, at most 5 s.
double time_to_engage(GuardedLoop& loop, double period) {
  const double begin = loop.reading.time;
  while (loop.guard.state() != ArmingState::on && loop.reading.time - begin < 5) loop.tick(Vec3::Zero(), period);
  return loop.reading.time - begin;
}

/// The only sentence of an event in the log; empty if there are none or several.
std::string only_sentence(GuardedLoop& loop, SafetyEvent event) {
  std::vector<SafetyLogEntry> entries = loop.guard.log().drain();
  std::erase_if(entries, [&](const SafetyLogEntry& e) { return e.event != event; });
  return entries.size() == 1 ? sentence_of(entries[0]) : std::string();
}

TEST(Pace, AFasterLoopDoesNotShortenTheFadeIn) {
  for (const double period : {1e-6, 20e-6, 100e-6, 300e-6, 1e-3}) {
    GuardedLoop loop;
    EXPECT_NEAR(time_to_engage(loop, period), 1.5, 0.02) << period;
  }
}

TEST(Pace, AFasterLoopDoesNotShortenTheFadeInWhereTheDeviceRepeatsItsReadings) {
  for (const int times : {1, 5, 15}) {  // ticks for each reading of a device of 1 kHz
    GuardedLoop loop;
    int readings = 0;
    for (; loop.guard.state() != ArmingState::on && readings < 5000; ++readings) {
      loop.tick();
      for (int n = 1; n < times; ++n) {
        loop.guard.admit(loop.reading);
        loop.guard.limit({}, loop.contact);
      }
    }
    EXPECT_GE(readings * kPeriod, 1.5 - 0.03) << times;
    EXPECT_LE(readings * kPeriod, 1.55) << times;
  }
}

// A driver that counts its readings, in a loop that does not wait for them.
TEST(Pace, AFadeInTakesItsTimeByTheClockOfTheLoop) {
  for (const double waited : {20e-6, 0.2e-3}) {
    GuardedLoop loop;
    int ticks = 0;
    for (; loop.guard.state() != ArmingState::on && ticks < 200000; ++ticks) {
      loop.guard.report_wait(waited);
      loop.tick();
    }
    EXPECT_NEAR(ticks * waited, 1.5, 0.03) << waited;
    EXPECT_EQ(loop.count(SafetyEvent::other_period), 1U) << waited;
  }
}

TEST(Pace, AFastLoopMayRepeatTheReadingsOfItsDevice) {
  for (const int times : {1, 5, 10, 22, 50, 200}) {  // ticks for each reading of a device of 1 kHz
    GuardedLoop loop;
    int readings = 0;
    for (; loop.guard.state() != ArmingState::on && readings < 3000; ++readings) {
      loop.guard.report_wait(kPeriod / times);
      loop.tick();
      for (int n = 1; n < times; ++n) {
        loop.guard.report_wait(kPeriod / times);
        loop.guard.admit(loop.reading);
        loop.guard.limit({}, loop.contact);
      }
    }
    EXPECT_NEAR(readings * kPeriod, 1.5, 0.05) << times;
    EXPECT_EQ(loop.count(SafetyEvent::fault), 0U) << times;
  }
}

TEST(Pace, ALoopOfAnotherPeriodIsReportedOnceWithTheCure) {
  for (const double period : {20e-6, 400e-6, 3e-3}) {
    GuardedLoop loop;
    for (int n = 0; n < 20000; ++n) loop.tick(Vec3::Zero(), period);
    const std::string sentence = only_sentence(loop, SafetyEvent::other_period);
    EXPECT_NE(sentence.find("set guard.period"), std::string::npos) << period << ": " << sentence;
    EXPECT_EQ(loop.count(SafetyEvent::other_period), 1U) << period;
  }
  for (const double period : {0.7e-3, 1e-3, 1.6e-3}) {
    GuardedLoop loop;
    for (int n = 0; n < 20000; ++n) loop.tick(Vec3::Zero(), n % 100 == 0 ? 20e-3 : period);
    EXPECT_EQ(loop.count(SafetyEvent::other_period), 0U) << period;
  }
}

TEST(Pace, ADeviceWithFewerGoodReadingsThanTicksArmsAndItsRateIsNamed) {
  for (const double rate : {400.0, 500.0, 667.0, 875.0}) {
    GuardedLoop loop;
    const auto tick = [&](int n) {
      loop.reading.valid = std::floor(n * kPeriod * rate) > std::floor((n - 1) * kPeriod * rate);
      return loop.tick(Vec3(0, 0, loop.guard.state() == ArmingState::on ? 1 : 0));
    };
    Wrench felt;
    for (int n = 0; n < 4000; ++n) felt = tick(n);
    EXPECT_EQ(loop.guard.state(), ArmingState::on) << rate;
    EXPECT_NEAR(felt.force.z(), 1, 1e-9) << rate;
    const std::string sentence = only_sentence(loop, SafetyEvent::slow_readings);
    const std::size_t now = sentence.find("Now: ");
    ASSERT_NE(now, std::string::npos) << rate << ": " << sentence;
    EXPECT_NEAR(std::stod(sentence.substr(now + 5)), rate, 0.02 * rate) << sentence;
  }
}

TEST(Pace, ADeviceWithAQuarterOfGoodReadingsIsNotReady) {
  GuardedLoop loop;
  for (int n = 0; n < 5000; ++n) {
    loop.reading.valid = n % 4 == 0;
    EXPECT_TRUE(loop.tick({0, 0, 1}).force.isZero(0));
  }
  EXPECT_EQ(loop.guard.state(), ArmingState::armed);
}

TEST(Pace, AWaitOfTheLoopInterruptsTheForceThoughTheReadingsDoNotShowIt) {
  struct Case {
    double waited;  // [s]
    SafetyEvent event;
    double ramp;  // [s]
  };
  for (const Case& c : {Case{0.3, SafetyEvent::paused, 1.5}, Case{12e-3, SafetyEvent::late_wake_up, 0.25}}) {
    for (const bool by_watchdog : {false, true}) {
      GuardedLoop loop;
      loop.engage();
      loop.push();
      const Watchdog watchdog{WatchdogOptions{}, kPeriod};
      if (by_watchdog)
        loop.guard.report_silence(watchdog.verdict(c.waited), watchdog.scale(c.waited));
      else
        loop.guard.report_wait(c.waited);
      for (int n = 0; n < 100; ++n) {
        EXPECT_TRUE(loop.tick({0, 0, 1}).force.isZero(0));
        EXPECT_EQ(loop.guard.state(), ArmingState::wait_free);
      }
      EXPECT_EQ(loop.count(c.event), 1U);
      EXPECT_NEAR(time_to_engage(loop, kPeriod), c.ramp, 0.02);
    }
  }
  GuardedLoop loop;
  loop.engage();
  loop.push();
  loop.guard.report_wait(5e-3);
  EXPECT_NEAR(loop.tick({0, 0, 1}).force.z(), 1, 1e-9);
}

/// Runs a device that counts its ticks, in real time, with a force that never ends.
RunReport run_in_contact(const std::function<void(const DeviceState&)>& at_tick, double seconds) {
  MockDevice device({});
  RunOptions options;
  options.stop_on_signals = false;
  options.seconds = seconds;
  options.guard.arming.ramp = 0.05;
  return device.run(
      [&](const DeviceState& state) {
        at_tick(state);
        const bool begins = state.time < 0.1;
        DeviceCommand command;
        command.wrench.force.z() = begins ? 0 : 0.36;
        command.contact.touching = !begins;
        return command;
      },
      options);
}

TEST(Pace, AHangOfARunInterruptsTheForceOfADeviceThatCountsItsTicks) {
  const RunReport report = run_in_contact(
      [](const DeviceState& state) {
        if (std::abs(state.time - 0.2) < 0.5e-3) std::this_thread::sleep_for(std::chrono::milliseconds(300));
      },
      0.4);
  EXPECT_GE(report.events[std::size_t(SafetyEvent::paused)], 1U);
  EXPECT_EQ(report.arming, ArmingState::wait_free);
}

TEST(Pace, ARunThatEndsInContactFadesItsForceWithoutAnAlarm) {
  const RunReport report = run_in_contact([](const DeviceState&) {}, 0.3);
  if (report.wake_up.max() > WatchdogOptions{}.fade_after) GTEST_SKIP() << "the machine is busy";
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::watchdog_fading)], 0U);  // the fade-out takes 20 ms
}

}  // namespace
}  // namespace hapticut::pace_test
