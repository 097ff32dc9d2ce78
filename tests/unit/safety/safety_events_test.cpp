// SPDX-License-Identifier: Apache-2.0
// Every safety event, brought about on purpose: each is counted and entered once in the log that is read outside the
// loop. And the state machine, case by case.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <thread>

#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut::safety_events_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPeriod = 1e-3;

class Events : public testing::Test {
 protected:
  explicit Events(const GuardOptions& options = {}) : guard(capabilities(device_model("touch")), options) {
    guard.start();
  }
  Wrench tick(const Vec3& force = Vec3::Zero(), double period = kPeriod) {
    reading.time += period;
    ++reading.sequence;
    guard.admit(reading);
    return guard.release({force, Vec3::Zero()});
  }
  void engage() {
    for (int n = 0; n < 5000 && guard.state() != ArmingState::on; ++n) tick();
    ASSERT_EQ(guard.state(), ArmingState::on);
  }
  SafetyGuard guard;
  DeviceState reading;
};

/// What the watchdog's thread does while the loop is silent, in simulated time.
void stay_silent(SafetyGuard& guard, int ticks, const WatchdogOptions& options = {}) {
  const Watchdog watchdog(options);
  for (int n = 1; n <= ticks; ++n) guard.report_silence(watchdog.verdict(n * kPeriod), watchdog.scale(n * kPeriod));
  guard.report_silence(Watchdog::Verdict::alive, 1);
}

/// Brings an event about, from a guard that is engaged.
struct Cause {
  SafetyEvent event;
  std::function<void(SafetyGuard&, DeviceState&, const std::function<void(Vec3, double)>&)> bring_about;
};

std::vector<Cause> causes() {
  using Tick = const std::function<void(Vec3, double)>&;
  const auto once = [](SafetyEvent event, const std::function<void(DeviceState&)>& spoil) {
    return Cause{event, [spoil](SafetyGuard&, DeviceState& reading, Tick tick) {
                   spoil(reading);
                   tick(Vec3::Zero(), kPeriod);
                 }};
  };
  const auto pushed = [](SafetyEvent event, double force, double period, int ticks) {
    return Cause{event, [=](SafetyGuard&, DeviceState&, Tick tick) {
                   for (int n = 0; n < ticks; ++n) tick(Vec3(0, 0, force), period);
                 }};
  };
  const auto told = [](SafetyEvent event, const std::function<void(SafetyGuard&)>& tell) {
    return Cause{event, [tell](SafetyGuard& guard, DeviceState&, Tick tick) {
                   tell(guard);
                   tick(Vec3::Zero(), kPeriod);
                 }};
  };
  const auto faulty = [&](SafetyEvent event, DeviceFault fault) {
    return once(event, [fault](DeviceState& s) { s.fault = fault; });
  };
  return {
      once(SafetyEvent::pose_not_finite, [](DeviceState& s) { s.X_BS.translation.x() = kNan; }),
      once(SafetyEvent::pose_not_a_rotation, [](DeviceState& s) { s.X_BS.rotation *= 1.01; }),
      once(SafetyEvent::pose_outside_workspace, [](DeviceState& s) { s.X_BS.translation.y() = 0.3; }),
      once(SafetyEvent::pose_jump, [](DeviceState& s) { s.X_BS.translation.x() += 0.03; }),
      once(SafetyEvent::pose_turn_jump,
           [](DeviceState& s) {
             s.X_BS.rotation = rotation_from_vector({0.5, 0, 0});
           }),
      {SafetyEvent::pose_frozen,
       [](SafetyGuard&, DeviceState& s, Tick tick) {
         for (int n = 0; n < 200; ++n) {
           s.X_BS.rotation = rotation_from_vector(Vec3(0, 0, 0.2 * std::sin(0.03 * n)));
           tick(Vec3::Zero(), kPeriod);
         }
       }},
      once(SafetyEvent::pose_units, [](DeviceState& s) { s.X_BS.translation.y() = 110; }),
      once(SafetyEvent::reading_invalid, [](DeviceState& s) { s.valid = false; }),
      once(SafetyEvent::reading_stale, [](DeviceState& s) { --s.sequence; }),
      told(SafetyEvent::armed,
           [](SafetyGuard& guard) {
             guard.stop();
             guard.start();
           }),
      told(SafetyEvent::waiting_free, [](SafetyGuard& guard) { guard.requests().interrupt(SafetyEvent::reclutched); }),
      {SafetyEvent::start_inside,
       [](SafetyGuard& guard, DeviceState&, Tick tick) {
         guard.requests().interrupt(SafetyEvent::reclutched);
         tick({0, 0, 1}, kPeriod);
       }},
      {SafetyEvent::fading_in,
       [](SafetyGuard& guard, DeviceState&, Tick tick) {
         guard.requests().interrupt(SafetyEvent::reclutched);
         for (int n = 0; n < 10; ++n) tick(Vec3::Zero(), kPeriod);
       }},
      {SafetyEvent::engaged,
       [](SafetyGuard& guard, DeviceState&, Tick tick) {
         guard.requests().interrupt(SafetyEvent::reclutched);
         for (int n = 0; n < 300; ++n) tick(Vec3::Zero(), kPeriod);
       }},
      faulty(SafetyEvent::fault, DeviceFault::disconnected),
      {SafetyEvent::fault_reset,
       [](SafetyGuard& guard, DeviceState&, Tick tick) {
         guard.requests().emergency_stop();
         tick(Vec3::Zero(), kPeriod);
         guard.requests().reset_fault();
         tick(Vec3::Zero(), kPeriod);
       }},
      once(SafetyEvent::recalibrated, [](DeviceState& s) { ++s.epoch; }),
      told(SafetyEvent::reclutched, [](SafetyGuard& guard) { guard.requests().interrupt(SafetyEvent::reclutched); }),
      told(SafetyEvent::model_swapped,
           [](SafetyGuard& guard) { guard.requests().interrupt(SafetyEvent::model_swapped); }),
      pushed(SafetyEvent::late_wake_up, 0, 8e-3, 1),
      pushed(SafetyEvent::paused, 0, 0.5, 1),
      pushed(SafetyEvent::force_not_finite, kNan, kPeriod, 1),
      {SafetyEvent::passivity,
       [](SafetyGuard&, DeviceState& s, Tick tick) {
         for (int n = 0; n < 300; ++n) {  // a force along the motion
           s.X_BS.translation.z() += 1e-4;
           tick({0, 0, 2}, kPeriod);
         }
       }},
      pushed(SafetyEvent::saturated, 50, kPeriod, 1),
      pushed(SafetyEvent::slew_limited, 3, kPeriod, 1),
      pushed(SafetyEvent::continuous_limited, 3.3, kPeriod, 20000),
      faulty(SafetyEvent::motors_warm, DeviceFault::motors_warm),
      faulty(SafetyEvent::device_fault, DeviceFault::speed_limit),
      told(SafetyEvent::watchdog_late, [](SafetyGuard& guard) { stay_silent(guard, 5); }),
      told(SafetyEvent::watchdog_fading, [](SafetyGuard& guard) { stay_silent(guard, 20); }),
      told(SafetyEvent::watchdog_fault, [](SafetyGuard& guard) { stay_silent(guard, 60); }),
      told(SafetyEvent::exception, [](SafetyGuard& guard) { guard.report_exception(); }),
      told(SafetyEvent::emergency_stop,
           [](SafetyGuard& guard) { std::thread([&] { guard.requests().emergency_stop(); }).join(); }),
  };
}

void PrintTo(const Cause& cause, std::ostream* out) { *out << name_of(cause.event); }

class EveryEvent : public Events, public testing::WithParamInterface<Cause> {};

TEST(SafetyLog, EveryEventIsASentenceThatSaysWhatToDoUnlessItIsGood) {
  for (std::size_t n = 0; n < kSafetyEvents; ++n) {
    const SafetyLogEntry entry{.event = SafetyEvent(n), .value = double(DeviceFault::motors_warm)};
    const std::string sentence = sentence_of(entry);
    const bool good = entry.event == SafetyEvent::engaged;
    EXPECT_TRUE(sentence.ends_with('.')) << name_of(entry.event) << ": " << sentence;
    EXPECT_EQ(sentence.find(": ") == std::string::npos, good) << name_of(entry.event) << ": " << sentence;
    EXPECT_NE(describe(entry).find(sentence), std::string::npos);
  }
  EXPECT_NE(sentence_of({.event = SafetyEvent::device_fault, .value = double(DeviceFault::motors_warm)})
                .find("let go until they have cooled."),
            std::string::npos);
}

TEST_P(EveryEvent, HasANameACounterAndOneEntryInTheLog) {
  const SafetyEvent event = GetParam().event;
  engage();
  (void)guard.log().drain();
  const std::uint64_t before = guard.log().count(event);
  GetParam().bring_about(guard, reading, [this](const Vec3& force, double period) { tick(force, period); });
  EXPECT_GE(guard.log().count(event), before + 1);
  int entries = 0;
  std::thread([&] {  // outside the loop
    for (const SafetyLogEntry& entry : guard.log().drain())
      if (entry.event == event) {
        ++entries;
        EXPECT_NE(describe(entry).find(name_of(event)), std::string::npos);
      }
  })
      .join();
  EXPECT_GE(entries, 1);
  EXPECT_LE(entries, 2) << "an event that lasts is entered when it begins";
}

INSTANTIATE_TEST_SUITE_P(SafetyLog, EveryEvent, testing::ValuesIn(causes()),
                         [](const auto& cause) { return std::string(name_of(cause.param.event)); });

TEST(SafetyLog, HasACauseForEveryEvent) {
  const std::vector<Cause> all = causes();
  ASSERT_EQ(all.size(), kSafetyEvents);
  for (std::size_t n = 0; n < kSafetyEvents; ++n) EXPECT_EQ(all[n].event, SafetyEvent(n));
}

// --- the state machine
// ------------------------------------------------------------------------------------------------

class StateMachine : public Events {
 protected:
  /// Pushes for a while: no force may come through, and the guard waits.
  void expect_no_force_until_free() {
    for (int n = 0; n < 100; ++n) {
      EXPECT_TRUE(tick({0, 0, 1}).force.isZero(0));
      EXPECT_EQ(guard.state(), ArmingState::wait_free);
    }
    engage();
    for (int n = 0; n < 10; ++n) tick({0, 0, 1});
    EXPECT_NEAR(tick({0, 0, 1}).force.z(), 1, 1e-12);
  }
  void push() {
    for (int n = 0; n < 10; ++n) tick({0, 0, 1});
    EXPECT_NEAR(tick({0, 0, 1}).force.z(), 1, 1e-12);
  }
};

TEST_F(StateMachine, StartInsideMaterialGivesNoForceUntilTheToolIsOut) {
  for (int n = 0; n < 30; ++n) tick({0, 0, 1});
  EXPECT_EQ(guard.log().count(SafetyEvent::start_inside), 1U);
  expect_no_force_until_free();
}

TEST_F(StateMachine, ReclutchInContactGivesNoForceUntilTheToolIsOut) {
  engage();
  push();
  guard.requests().interrupt(SafetyEvent::reclutched);
  expect_no_force_until_free();
}

TEST_F(StateMachine, CalibrationChangeInContactGivesNoForceUntilTheToolIsOut) {
  engage();
  push();
  reading.X_BS.translation.x() += 0.04;  // another place is called the same
  ++reading.epoch;
  expect_no_force_until_free();
}

TEST_F(StateMachine, ReconnectNeedsAResetAndThenAFreeTool) {
  engage();
  push();
  reading.fault = DeviceFault::disconnected;
  reading.valid = false;
  EXPECT_TRUE(tick({0, 0, 1}).force.isZero(0));
  EXPECT_EQ(guard.state(), ArmingState::fault);
  reading.fault = DeviceFault::none;
  reading.valid = true;
  ++reading.epoch;  // the driver's word for "these poses are new"
  for (int n = 0; n < 100; ++n) EXPECT_TRUE(tick({0, 0, 1}).force.isZero(0));
  EXPECT_EQ(guard.state(), ArmingState::fault) << "it latches";
  guard.requests().reset_fault();
  for (int n = 0; n < 30; ++n) tick({0, 0, 1});
  expect_no_force_until_free();
}

TEST_F(StateMachine, DebuggerPauseGivesNoForceUntilTheToolIsOut) {
  engage();
  push();
  reading.X_BS.translation.z() -= 0.02;  // the hand has sunk while everything stood
  EXPECT_TRUE(tick({0, 0, 30}, 5.0).force.isZero(0));
  EXPECT_EQ(guard.log().count(SafetyEvent::paused), 1U);
  expect_no_force_until_free();
}

// --- the watchdog
// ------------------------------------------------------------------------------------------------

class Silence : public Events {};

TEST_F(Silence, IsReportedStageByStageOnceEachAndInTheirOrder) {
  engage();
  (void)guard.log().drain();
  for (const int again : {1, 2}) {
    stay_silent(guard, 200);
    tick();
    std::vector<SafetyEvent> said;
    for (const SafetyLogEntry& entry : guard.log().drain()) said.push_back(entry.event);
    const std::vector<SafetyEvent> expected = {SafetyEvent::watchdog_late, SafetyEvent::watchdog_fading,
                                               SafetyEvent::watchdog_fault};
    EXPECT_EQ(said, expected);
    EXPECT_EQ(guard.log().count(SafetyEvent::watchdog_fault), std::uint64_t(again));
  }
}

TEST_F(Silence, OfThreeTicksIsNotWorthAWord) {
  engage();
  stay_silent(guard, 3);
  EXPECT_EQ(guard.log().count(SafetyEvent::watchdog_late), 0U);
}

TEST_F(Silence, IsAPauseAndNoFaultUnlessTheWatchdogLatches) {
  engage();
  stay_silent(guard, 100);
  tick({0, 0, 1}, 0.1);
  EXPECT_EQ(guard.state(), ArmingState::wait_free);
  EXPECT_EQ(guard.log().count(SafetyEvent::paused), 1U);
  EXPECT_EQ(guard.log().count(SafetyEvent::fault), 0U);
}

class LatchedSilence : public Events {
 protected:
  static GuardOptions latching() {
    GuardOptions options;
    options.watchdog.latch = true;
    return options;
  }
  LatchedSilence() : Events(latching()) {}
};

TEST_F(LatchedSilence, IsAFaultAfterFiftyTicksUntilItIsReset) {
  engage();
  stay_silent(guard, 50, latching().watchdog);
  tick();
  EXPECT_EQ(guard.state(), ArmingState::on) << "fifty are not more than fifty";
  stay_silent(guard, 51, latching().watchdog);
  tick();
  EXPECT_EQ(guard.state(), ArmingState::fault);
  for (int n = 0; n < 3000; ++n) EXPECT_TRUE(tick().force.isZero(0));
  EXPECT_EQ(guard.state(), ArmingState::fault) << "it latches";
  guard.requests().reset_fault();
  engage();
}

// --- the log
// ------------------------------------------------------------------------------------------------

TEST(SafetyLog, IsInTheOrderOfItsTicksWhateverTheDeviceCallsThem) {
  SafetyLog log;
  log.begin_tick(0.1, 100);
  log.report(SafetyEvent::engaged);
  log.begin_tick(0.2, 100);  // the same reading again
  log.note(SafetyEvent::watchdog_late, 1);
  log.begin_tick(0.0, 1);  // a new connection counts from one
  log.report(SafetyEvent::recalibrated);
  log.begin_tick(0.1, 2);
  log.note(SafetyEvent::watchdog_fading, 1);
  log.begin_tick(0.2, 3);
  log.report(SafetyEvent::fading_in);
  std::vector<SafetyEvent> order;
  for (const SafetyLogEntry& entry : log.drain()) order.push_back(entry.event);
  const std::vector<SafetyEvent> expected = {SafetyEvent::engaged, SafetyEvent::watchdog_late,
                                             SafetyEvent::recalibrated, SafetyEvent::watchdog_fading,
                                             SafetyEvent::fading_in};
  EXPECT_EQ(order, expected);
}

}  // namespace
}  // namespace hapticut::safety_events_test
