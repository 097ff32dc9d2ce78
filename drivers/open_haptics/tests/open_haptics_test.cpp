// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/open_haptics.hpp"

#include <gtest/gtest.h>
#include <hdsim.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "open_haptics/tests/open_haptics.hpp"

namespace hapticut::open_haptics_test {
namespace {

using test::options_for;
using test::push_for;
using test::quick;

class OpenHaptics : public test::OpenHapticsTest {};

TEST_F(OpenHaptics, OpensTheDefaultDeviceAndReadsItsCapabilities) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  const DeviceCapabilities& c = device->capabilities();
  EXPECT_EQ(c.model, "Touch");
  EXPECT_EQ(c.output_degrees_of_freedom, 3);
  EXPECT_NEAR(c.stiffness, 500, 1e-9);  // 0.5 N/mm, not the number of the enumerator
  EXPECT_NEAR(c.peak_force, 3.3, 1e-12);
  EXPECT_NEAR(c.continuous_force, 0.88, 1e-12);
  EXPECT_NEAR(c.workspace_low.x(), -0.210, 1e-12);
  EXPECT_NEAR(c.workspace_high.z(), 0.130, 1e-12);
  EXPECT_EQ(hdsim_get_counters(0).running_at_init, 0);
}

TEST_F(OpenHaptics, KnowsTheTorqueOfADeviceOfSixDegreesInNewtonmetres) {
  add_premium();
  const DeviceCapabilities c = open_open_haptics(options_for())->capabilities();
  EXPECT_EQ(c.output_degrees_of_freedom, 6);
  EXPECT_NEAR(c.peak_torque, 0.188, 1e-12);
  EXPECT_NEAR(c.continuous_torque, 0.048, 1e-12);
}

TEST_F(OpenHaptics, GoesThroughTheNamesThatDriversUse) {
  add_touch("Default PHANToM");
  hdsim_refuse_name(nullptr);
  hdsim_refuse_name("Default Device");
  const auto device = open_open_haptics(options_for("My Touch"));
  const Outcome outcome = run(*device, push_for(5));
  ASSERT_FALSE(outcome.report.warnings.empty());
  EXPECT_NE(outcome.report.warnings.front().find("My Touch"), std::string::npos) << outcome.report.warnings.front();
  EXPECT_NE(outcome.report.warnings.front().find("Default PHANToM"), std::string::npos);
}

TEST_F(OpenHaptics, ReportsWhyNoDeviceCouldBeOpened) {
  try {
    (void)open_open_haptics(options_for("Left"));
    FAIL();
  } catch (const Error& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("\"Left\": device fault (stand-in) (0x0300"), std::string::npos) << text;
    EXPECT_NE(text.find("dialout"), std::string::npos) << text;
  }
  add_touch();
  OpenHapticsOptions strict = options_for("Left");
  strict.other_names = false;
  EXPECT_THROW((void)open_open_haptics(strict), Error);
}

TEST_F(OpenHaptics, NeedsALicenceWhereTheSdkDoes) {
  add_touch();
  hdsim_require_license(1);
  EXPECT_THROW((void)open_open_haptics(options_for()), Error);
  OpenHapticsOptions licensed = options_for();
  licensed.license_vendor = "vendor";
  licensed.license_application = "application";
  licensed.license_password = "secret";
  EXPECT_EQ(open_open_haptics(licensed)->capabilities().model, "Touch");
}

TEST_F(OpenHaptics, ReportsASchedulerThatDoesNotStart) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  hdsim_fail_start(1);
  EXPECT_THROW(device->run(push_for(5), quick()), Error);
  EXPECT_EQ(hdsim_scheduled_callbacks(), 0);
  EXPECT_EQ(hdsim_get_counters(0).force_output_enabled, 0);
  hdsim_fail_start(0);
  EXPECT_EQ(run(*device, push_for(5)).report.ticks, 5U);
}

TEST_F(OpenHaptics, IsFoundByTheNameOfItsMakersSetup) {
  add_touch();
  use_open_haptics();
  EXPECT_EQ(open_device("openhaptics:Default Device")->name(), "openhaptics:Default Device");
}

TEST_F(OpenHaptics, BeginsOneFrameInEveryTickAndOneMoreToTakeTheForceAway) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  const DeviceCallback push = push_for(1000);
  const Outcome outcome = run(*device, [&, n = 0](const DeviceState& state) mutable {
    if (++n == 150) throw std::runtime_error("the tool broke");
    return push(state);
  });
  EXPECT_THROW(std::rethrow_exception(outcome.exception), std::runtime_error);
  EXPECT_EQ(hdsim_get_counters(0).frames, 151);
}

TEST_F(OpenHaptics, TwoDevicesShareOneScheduler) {
  add_touch("Left");
  add_premium("Right");
  OpenHapticsOptions left_options = options_for("Left"), right_options = options_for("Right");
  const auto left = open_open_haptics(left_options), right = open_open_haptics(right_options);
  EXPECT_THROW((void)open_open_haptics(left_options), Error) << "it is open";
  std::atomic<int> ended{0};
  RunReport left_report, right_report;
  std::thread a([&] {
    left_report = left->run(push_for(400), quick());
    ++ended;
  });
  std::thread b([&] {
    right_report = right->run(push_for(900, {Vec3(0, 2, 0), Vec3::Zero()}), quick());
    ++ended;
  });
  while (ended < 2)
    if (hdsim_run_ticks(1) == 0) std::this_thread::yield();
  a.join();
  b.join();
  EXPECT_EQ(left_report.ticks, 400U);
  EXPECT_EQ(right_report.ticks, 900U);
  EXPECT_EQ(hdsim_is_running(), 0);
  for (const int device : {0, 1}) {
    EXPECT_EQ(hdsim_get_counters(device).zero_force_before_stop, 1) << device;
    EXPECT_EQ(hdsim_get_counters(device).illegal_begins, 0) << device;
  }
  EXPECT_NEAR(test::committed(1, 890).force.y(), 2, 1e-12);
}

TEST_F(OpenHaptics, RefusesToOpenADeviceWhileAnotherRuns) {
  add_touch("Left");
  add_touch("Right");
  const auto left = open_open_haptics(options_for("Left"));
  run(*left, [&](const DeviceState&) {
    EXPECT_THROW((void)open_open_haptics(options_for("Right")), Error);
    return DeviceCommand{{}, true};
  });
}

/// Result of a run with a given period. The stylus rotates at 2 rad/s under a constant force; `speed` is the last
/// angular speed.
struct RotatingRun {
  RunReport report;
  double speed = 0, seconds = 0;
};
RotatingRun run_rotating(Device& device, double period) {
  RotatingRun seen;
  RunOptions options = quick();
  options.guard.period = period;
  options.seconds = 0.5;
  const DeviceCallback push = push_for(1000000);
  const test::OpenHapticsOutcome outcome = test::run_in_ticks(
      device,
      [&](const DeviceState& state) {
        seen.speed = state.velocity.angular.z();
        seen.seconds = state.time;
        return push(state);
      },
      options,
      [](long) {
        const double t = hdsim_time();
        test::place(0, {rotation_from_vector(Vec3(0, 0, 2 * t)), Vec3(1e-3 * std::sin(20 * t), 0, 0)});
      });
  seen.report = outcome.report;
  return seen;
}

TEST_F(OpenHaptics, TicksWithThePeriodOfTheRunAndKnowsHowFastItTurns) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  for (const double period : {2e-3, 1e-3, 0.5e-3}) {
    const RotatingRun seen = run_rotating(*device, period);
    EXPECT_EQ(seen.report.period, period);
    EXPECT_NEAR(seen.speed, 2, 1e-3) << period;
    EXPECT_NEAR(seen.seconds, double(seen.report.ticks - 1) * period, 1e-9);
    EXPECT_EQ(seen.report.missed, 0U);
    EXPECT_EQ(seen.report.arming, ArmingState::on);
    EXPECT_TRUE(seen.report.warnings.empty());
  }
}

TEST_F(OpenHaptics, RunsWithTheDriversOwnPeriodWhereItRefusesAnother) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  for (const double refused : {0.25e-3, 4e-3}) {
    const RotatingRun seen = run_rotating(*device, refused);
    EXPECT_EQ(seen.report.period, 1e-3);
    EXPECT_NEAR(seen.speed, 2, 1e-3) << refused;
    EXPECT_EQ(seen.report.missed, 0U);
    ASSERT_EQ(seen.report.warnings.size(), 1U);
    EXPECT_NE(seen.report.warnings[0].find("imposes its own period: "), std::string::npos) << seen.report.warnings[0];
    EXPECT_NE(seen.report.warnings[0].find("became 0.001 s"), std::string::npos) << seen.report.warnings[0];
  }
}

TEST_F(OpenHaptics, RefusesTwoPeriodsAtOnce) {
  add_touch("Left");
  add_touch("Right");
  const auto left = open_open_haptics(options_for("Left")), right = open_open_haptics(options_for("Right"));
  std::string words;
  run(*left, push_for(200), quick(), [&](long tick) {
    if (tick != 100) return;
    RunOptions options = quick();
    options.guard.period = 0.5e-3;
    try {
      right->run(push_for(1), options);
    } catch (const Error& error) {
      words = error.what();
    }
  });
  EXPECT_NE(words.find("0.0005 s is not the 0.001 s"), std::string::npos) << words;
}

}  // namespace
}  // namespace hapticut::open_haptics_test
