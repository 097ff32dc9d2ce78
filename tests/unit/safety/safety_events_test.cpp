// SPDX-License-Identifier: Apache-2.0
// Causes every safety event: each is counted, and entered once in the log, which another thread reads.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <thread>

#include "support/guarded_loop.hpp"

namespace hapticut::safety_events_test {
namespace {

using test::GuardedLoop;
using test::kPeriod;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Does what the watchdog's thread does while the loop is silent, in simulated time.
void stay_silent(SafetyGuard& guard, int ticks, const WatchdogOptions& options = {}) {
  const Watchdog watchdog(options);
  for (int n = 1; n <= ticks; ++n) guard.report_silence(watchdog.verdict(n * kPeriod), watchdog.scale(n * kPeriod));
  guard.report_silence(Watchdog::Verdict::alive, 1);
}

/// Causes an event, starting from an engaged guard.
struct Cause {
  SafetyEvent event;
  std::function<void(GuardedLoop&)> cause;
};

std::vector<Cause> causes() {
  using Event = SafetyEvent;
  const auto pushed = [](Event event, double force, double period, int ticks) {
    return Cause{event, [=](GuardedLoop& loop) {
                   for (int n = 0; n < ticks; ++n) loop.tick(Vec3(0, 0, force), period);
                 }};
  };
  const auto once = [](Event event, const std::function<void(DeviceState&)>& spoil) {
    return Cause{event, [spoil](GuardedLoop& loop) {
                   spoil(loop.reading);
                   loop.tick();
                 }};
  };
  const auto after_call = [](Event event, const std::function<void(SafetyGuard&)>& call) {
    return Cause{event, [call](GuardedLoop& loop) {
                   call(loop.guard);
                   loop.tick();
                 }};
  };
  const auto faulty = [&](Event event, DeviceFault fault) {
    return once(event, [fault](DeviceState& s) { s.fault = fault; });
  };
  const auto interrupted = [](Event event, Event by, double force, int ticks) {
    return Cause{event, [=](GuardedLoop& loop) {
                   loop.guard.requests().interrupt(by);
                   for (int n = 0; n < ticks; ++n) loop.tick(Vec3(0, 0, force));
                 }};
  };
  const auto silent = [&](Event event, int ticks) {
    return after_call(event, [ticks](SafetyGuard& guard) { stay_silent(guard, ticks); });
  };
  return {
      once(Event::pose_not_finite, [](DeviceState& s) { s.X_BS.translation.x() = kNan; }),
      once(Event::pose_not_a_rotation, [](DeviceState& s) { s.X_BS.rotation *= 1.01; }),
      once(Event::pose_outside_workspace, [](DeviceState& s) { s.X_BS.translation.y() = 0.3; }),
      once(Event::pose_jump, [](DeviceState& s) { s.X_BS.translation.x() += 0.03; }),
      once(Event::pose_rotation_jump, [](DeviceState& s) { s.X_BS.rotation = rotation_from_vector(Vec3(0.5, 0, 0)); }),
      {Event::pose_frozen,
       [](GuardedLoop& loop) {
         for (int n = 0; n < 200; ++n) {
           loop.reading.X_BS.rotation = rotation_from_vector(Vec3(0, 0, 0.2 * std::sin(0.03 * n)));
           loop.tick();
         }
       }},
      once(Event::pose_units, [](DeviceState& s) { s.X_BS.translation.y() = 110; }),
      once(Event::reading_invalid, [](DeviceState& s) { s.valid = false; }),
      once(Event::reading_stale, [](DeviceState& s) { --s.sequence; }),
      after_call(Event::armed,
                 [](SafetyGuard& guard) {
                   guard.stop();
                   guard.start();
                 }),
      interrupted(Event::waiting_free, Event::reclutched, 0, 1),
      interrupted(Event::start_inside, Event::reclutched, 1, 1),
      interrupted(Event::fading_in, Event::reclutched, 0, 10),
      interrupted(Event::engaged, Event::reclutched, 0, 300),
      faulty(Event::fault, DeviceFault::disconnected),
      {Event::fault_reset,
       [](GuardedLoop& loop) {
         loop.guard.requests().emergency_stop();
         loop.tick();
         loop.guard.requests().reset_fault();
         loop.tick();
       }},
      once(Event::recalibrated, [](DeviceState& s) { ++s.epoch; }),
      interrupted(Event::reclutched, Event::reclutched, 0, 1),
      interrupted(Event::model_swapped, Event::model_swapped, 0, 1),
      pushed(Event::late_wake_up, 0, 8e-3, 1),
      pushed(Event::paused, 0, 0.5, 1),
      pushed(Event::force_not_finite, kNan, kPeriod, 1),
      {Event::passivity,
       [](GuardedLoop& loop) {
         for (int n = 0; n < 300; ++n) {  // a force along the motion
           loop.reading.X_BS.translation.z() += 1e-4;
           loop.tick({0, 0, 2});
         }
       }},
      pushed(Event::saturated, 50, kPeriod, 1),
      pushed(Event::slew_limited, 3, kPeriod, 1),
      pushed(Event::continuous_limited, 3.3, kPeriod, 20000),
      faulty(Event::motors_warm, DeviceFault::motors_warm),
      faulty(Event::device_fault, DeviceFault::speed_limit),
      {Event::watchdog_late,
       [](GuardedLoop& loop) {
         for (int n = 0; n < 4; ++n) {
           stay_silent(loop.guard, 5);
           loop.tick();
         }
       }},
      silent(Event::watchdog_fading, 20),
      silent(Event::watchdog_fault, 60),
      after_call(Event::exception, [](SafetyGuard& guard) { guard.report_exception(); }),
      after_call(Event::emergency_stop,
                 [](SafetyGuard& guard) { std::thread([&] { guard.requests().emergency_stop(); }).join(); }),
      pushed(Event::other_period, 0, 1e-4, 1500),
      {Event::slow_readings,
       [](GuardedLoop& loop) {
         for (int n = 0; n < 2500; ++n) {
           loop.reading.valid = n % 2 == 0;
           loop.tick();
         }
       }},
  };
}

void PrintTo(const Cause& cause, std::ostream* out) { *out << name_of(cause.event); }

class EveryEvent : public testing::TestWithParam<Cause> {};

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
                .find("release the stylus until they have cooled."),
            std::string::npos);
}

TEST_P(EveryEvent, HasANameACounterAndOneEntryInTheLog) {
  const SafetyEvent event = GetParam().event;
  GuardedLoop loop;
  loop.engage();
  (void)loop.guard.log().drain();
  const std::uint64_t before = loop.count(event);
  GetParam().cause(loop);
  EXPECT_GE(loop.count(event), before + 1);
  int entries = 0;
  std::thread([&] {  // outside the loop
    for (const SafetyLogEntry& entry : loop.guard.log().drain())
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

// --- the watchdog ----------------------------------------------------------------------------------------------------

TEST(Silence, IsReportedStageByStageOnceEachAndInTheirOrder) {
  GuardedLoop loop;
  loop.engage();
  stay_silent(loop.guard, 3);
  EXPECT_EQ(loop.count(SafetyEvent::watchdog_late), 0U) << "three ticks are not reported";
  (void)loop.guard.log().drain();
  for (const int again : {1, 2}) {
    stay_silent(loop.guard, 200);
    std::vector<SafetyEvent> said;
    for (const SafetyLogEntry& entry : loop.guard.log().drain()) said.push_back(entry.event);
    loop.tick();
    (void)loop.guard.log().drain();
    const std::vector<SafetyEvent> expected = {SafetyEvent::watchdog_fading, SafetyEvent::watchdog_fault};
    EXPECT_EQ(said, expected);
    EXPECT_EQ(loop.count(SafetyEvent::watchdog_fault), std::uint64_t(again));
  }
}

// A busy computer holds up every loop now and then, and no smaller head helps.
TEST(Silence, IsLateByAShareOfTheTicks) {
  constexpr int kSecond = 1000;  // [ticks]
  for (const int apart : {kSecond / 2, kSecond / 5}) {
    GuardedLoop loop;
    loop.engage();
    for (int n = 0; n < 20; ++n) {
      stay_silent(loop.guard, 5);
      for (int tick = 0; tick < apart; ++tick) loop.tick();
    }
    EXPECT_EQ(loop.count(SafetyEvent::watchdog_late), apart > kSecond / 3 ? 0U : 17U) << apart;
  }
}

TEST(Silence, IsAPauseAndNoFaultUnlessTheWatchdogLatches) {
  GuardedLoop loop;
  loop.engage();
  stay_silent(loop.guard, 100);
  loop.tick({0, 0, 1}, 0.1);
  EXPECT_EQ(loop.guard.state(), ArmingState::wait_free);
  EXPECT_EQ(loop.count(SafetyEvent::paused), 1U);
  EXPECT_EQ(loop.count(SafetyEvent::fault), 0U);
}

TEST(Silence, OfMoreThanFiftyTicksIsAFaultUntilItIsResetWhereTheWatchdogLatches) {
  GuardOptions latching;
  latching.watchdog.latch = true;
  GuardedLoop loop(latching);
  loop.engage();
  stay_silent(loop.guard, 50, latching.watchdog);
  loop.tick();
  EXPECT_EQ(loop.guard.state(), ArmingState::wait_free);
  loop.engage();
  stay_silent(loop.guard, 51, latching.watchdog);
  loop.tick();
  EXPECT_EQ(loop.guard.state(), ArmingState::fault);
  for (int n = 0; n < 3000; ++n) EXPECT_TRUE(loop.tick().force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::fault) << "it latches";
  loop.guard.requests().reset_fault();
  loop.engage();
}

// --- the log ---------------------------------------------------------------------------------------------------------

TEST(SafetyLog, IsInTheOrderOfItsTicksForAnyNumbersOfTheDevice) {
  SafetyLog log;
  log.begin_tick(0.1, 100);
  log.report(SafetyEvent::engaged);
  log.begin_tick(0.2, 100);  // repeats a reading
  log.note(SafetyEvent::watchdog_late, 1);
  log.begin_tick(0.0, 1);  // a new connection restarts the numbers
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
