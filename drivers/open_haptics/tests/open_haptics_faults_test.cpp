// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/open_haptics.hpp"

#include <gtest/gtest.h>
#include <hdsim.h>

#include <array>
#include <atomic>
#include <chrono>
#include <clocale>
#include <cmath>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "open_haptics/tests/open_haptics.hpp"

namespace hapticut::open_haptics_faults_test {
namespace {

using test::committed;
using test::options_for;
using test::place;
using test::push_for;
using test::quick;

// Error and status codes of OpenHaptics that the tests make the stand-in report.
constexpr unsigned kWarmMotors = 0x0200, kExceededForce = 0x0201, kExceededImpulse = 0x0202, kExceededSpeed = 0x0203;
constexpr unsigned kCommError = 0x0302, kInvalidInputType = 0x0103;
constexpr unsigned kCalibrationNeedsUpdate = 0x5001, kCalibrationNeedsManualInput = 0x5002;

class OpenHapticsFaults : public test::OpenHapticsTest {};

TEST_F(OpenHapticsFaults, ReportsTheErrorOfTheDriverWhenItIsUnplugged) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  const Outcome outcome = run(*device, push_for(10000), quick(), [](long tick) {
    if (tick == 300) hdsim_unplug(0, 1);
  });
  ASSERT_FALSE(outcome.report.warnings.empty());
  EXPECT_NE(outcome.report.warnings.back().find("0x0302, internal -28"), std::string::npos)
      << outcome.report.warnings.back();
  EXPECT_EQ(hdsim_get_counters(0).zero_force_before_stop, 1);
}

TEST_F(OpenHapticsFaults, EndsWhenTheDriverStopsItsCalls) {
  add_touch();
  OpenHapticsOptions options = options_for();
  options.silence = 0.2;
  const auto device = open_open_haptics(options);
  RunReport report;
  std::thread runner([&] { report = device->run(push_for(100000), quick()); });
  int ticks = 0;
  while (ticks == 0 || (ticks < 100 && hdsim_is_running() != 0)) ticks += hdsim_run_ticks(1);
  runner.join();  // there are no more ticks
  EXPECT_NE(report.end.find("stopped calling back"), std::string::npos) << report.end;
  EXPECT_EQ(report.fault, DeviceFault::disconnected);
  EXPECT_EQ(hdsim_is_running(), 0);
  EXPECT_EQ(hdsim_scheduled_callbacks(), 0);
}

TEST_F(OpenHapticsFaults, ALateCallFindsNoRunAndNoDevice) {
  add_touch();
  OpenHapticsOptions options = options_for();
  options.silence = 0.2;
  {
    auto device = open_open_haptics(options);
    std::thread runner([&] { (void)device->run(push_for(100000), quick()); });
    for (int ticks = 0; ticks == 0 || (ticks < 100 && hdsim_is_running() != 0);) ticks += hdsim_run_ticks(1);
    runner.join();
    const long frames = hdsim_get_counters(0).frames;
    EXPECT_EQ(hdsim_call_late(), 0U) << "and wants no further one";
    EXPECT_EQ(hdsim_get_counters(0).frames, frames);
  }
  EXPECT_EQ(hdsim_call_late(), 0U) << "after the device is closed";
  const auto device = open_open_haptics(options_for());
  const Outcome again = run(*device, push_for(300), quick(), [](long tick) {
    if (tick == 100) hdsim_call_late();
  });
  EXPECT_EQ(again.report.end, "the callback ended it");
  EXPECT_EQ(again.report.ticks, 300U) << "a late call of one run is no tick of another";
}

/// A callback that hangs at its 200th tick, while there is a force, until `released`. From tick 300 on it frees the
/// tool and presses again, 50 ticks each, until a force of 1 N is rendered: where the machine pauses in between, the
/// watchdog rightly asks for a free tool once more.
struct Hang {
  std::atomic<bool> hangs{false}, released{false};
  bool renders_again = false;
  DeviceCommand operator()(const DeviceState& state) {
    if (state.sequence == 200) {
      hangs = true;
      while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      hangs = false;
    }
    const bool free = state.sequence <= 50 || (state.sequence >= 300 && state.sequence % 100 < 50);
    renders_again = state.sequence >= 300 && test::rendered(0).x() == 1;
    return {{Vec3(free ? 0 : 1, 0, 0), Vec3::Zero()}, renders_again || state.sequence >= 20000};
  }
};

/// Whether a condition becomes true within a time that suffices for any machine.
bool happens(const std::function<bool()>& what) {
  for (int n = 0; n < 20000 && !what(); ++n) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return what();
}

RunOptions watched() {
  RunOptions options = quick();
  options.guard.watchdog = {};
  options.guard.late = options.guard.pause = 1;
  return options;
}

TEST_F(OpenHapticsFaults, ReleasesTheHandWhileACallbackHangsAndEndsTheRunAfterIt) {
  for (const bool by_watchdog : {false, true}) {  // false: the run releases the hand because the driver is silent
    hdsim_reset();
    const int first = add_touch("first"), second = add_touch("second");
    hdsim_use_thread(1);
    OpenHapticsOptions options = options_for("first"), others = options_for("second");
    options.silence = others.silence = 1;
    const RunOptions how = by_watchdog ? watched() : quick();
    auto device = open_open_haptics(options), other = open_open_haptics(others);
    RunReport report;
    std::atomic<bool> ended{false};
    {
      Hang hang;  // destroyed after the run, when no callback may be running
      std::thread other_runner([&] { (void)other->run(push_for(100000), how); });
      std::thread runner([&] {
        report = device->run(std::ref(hang), how);
        ended = true;
      });
      EXPECT_TRUE(happens([&] { return hang.hangs.load(); }));
      EXPECT_TRUE(happens([&] { return test::rendered(first).isZero(0) && test::rendered(second).isZero(0); }));
      EXPECT_TRUE(happens([&] { return hdsim_get_counters(first).force_output_enabled == 0; }));
      std::this_thread::sleep_for(std::chrono::duration<double>(2 * options.silence));
      EXPECT_FALSE(ended) << "the callback still uses objects of the caller";
      hang.released = true;
      runner.join();
      other_runner.join();
      EXPECT_FALSE(hang.hangs);
    }
    EXPECT_NE(report.end.find("the callback did not return"), std::string::npos) << report.end;
    EXPECT_TRUE(committed(first).force.isZero(0));
    EXPECT_EQ(hdsim_scheduled_callbacks(), 0);
    hdsim_use_thread(0);
    EXPECT_EQ(run(*device, push_for(300)).report.ticks, 300U) << "the same device again";
    EXPECT_EQ(hdsim_get_counters(first).force_output_enabled, 0) << "after the run, as always";
    device.reset();
  }
}

TEST_F(OpenHapticsFaults, RendersForceAgainWithAFreeToolAfterAHangThatTheWatchdogSaw) {
  add_touch();
  hdsim_use_thread(1);
  const auto device = open_open_haptics(options_for());
  Hang hang;
  RunReport report;
  std::thread runner([&] { report = device->run(std::ref(hang), watched()); });
  EXPECT_TRUE(happens([&] { return hang.hangs.load(); }));
  EXPECT_TRUE(happens([] { return test::rendered(0).isZero(0); }));
  const long before = hdsim_committed_count(0);
  hang.released = true;
  runner.join();
  EXPECT_TRUE(committed(0, before).force.isZero(0)) << "the force of the tick that hung is too old";
  for (long n = before; n < 299; ++n) ASSERT_TRUE(committed(0, n).force.isZero(0)) << "the tool is not free yet: " << n;
  EXPECT_TRUE(hang.renders_again) << report.end;
}

TEST_F(OpenHapticsFaults, DetectsAPositionThatStaysAtTheOrigin) {
  add_touch();
  place(0, Pose::from_translation({0, -0.110, -0.035}));
  const auto device = open_open_haptics(options_for());
  ArmingState state = ArmingState::off;
  const Outcome outcome = run(
      *device,
      [&, n = 0](const DeviceState& s) mutable {
        state = device->arming();
        return DeviceCommand{{Vec3(s.time > 0.1 ? 1 : 0, 0, 0), Vec3::Zero()}, ++n >= 1500};
      },
      quick(),
      [](long tick) {  // the gimbal's angles move
        place(0, {rotation_from_vector(Vec3(0.5 * std::sin(0.01 * double(tick)), 0, 0)), Vec3(0, -0.110, -0.035)});
      });
  EXPECT_EQ(outcome.report.arming, ArmingState::fault);
  EXPECT_GE(outcome.report.events[std::size_t(SafetyEvent::pose_frozen)], 1U);
  EXPECT_TRUE(committed(0).force.isZero(0));
}

TEST_F(OpenHapticsFaults, ReducesTheForceWhileTheMotorsAreWarm) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  double warm = 0, cooled = 0;
  RunOptions options = quick();
  options.guard.thermal.time_constant = 1e6;  // so that only the device's temperature matters
  const Outcome outcome = run(*device, push_for(6000, {Vec3(2, 0, 0), Vec3::Zero()}), options, [&](long tick) {
    if (tick == 500) hdsim_inject_error(0, kWarmMotors, 0);
    if (tick == 500) hdsim_set_temperature(0, 0.6);
    if (tick == 3000) warm = committed(0).force.x();
    if (tick == 3000) hdsim_set_temperature(0, 0.3);
    if (tick == 5990) cooled = committed(0).force.x();
  });
  EXPECT_NEAR(warm, 0.88, 1e-9);
  EXPECT_NEAR(cooled, 2, 1e-9);
  EXPECT_GE(outcome.report.events[std::size_t(SafetyEvent::motors_warm)], 1U);
}

TEST_F(OpenHapticsFaults, FadesInAgainAfterTheDriverRefusedAForce) {
  for (const unsigned code : {kExceededForce, kExceededImpulse, kExceededSpeed}) {
    hdsim_reset();
    add_touch();
    const auto device = open_open_haptics(options_for());
    std::vector<double> forces;
    const Outcome outcome = run(*device, test::press_and_release(300, 350, 600), quick(), [&](long tick) {
      if (tick == 280) hdsim_inject_error(0, code, 0);
      forces.push_back(committed(0).force.x());
    });
    EXPECT_EQ(outcome.report.fault, DeviceFault::none) << code;
    EXPECT_EQ(outcome.report.ticks, 600U) << code;
    EXPECT_EQ(forces[279], 1) << code;
    for (std::size_t n = 283; n < 300; ++n) EXPECT_EQ(forces[n], 0) << code << ", tick " << n;
    EXPECT_EQ(forces[500], 1) << code;
  }
}

TEST_F(OpenHapticsFaults, NeverMakesTheDriverToggleItsAmplifiersForAnyRequestedForce) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  double fading_in = 0, in_the_end = 0;
  run(
      *device,
      [&, n = 0](const DeviceState&) mutable {
        DeviceCommand command;
        ++n;
        if (n > 50) command.wrench.force.x() = n % 100 < 50 ? 1000 : -1000;
        command.stop = n >= 2000;
        return command;
      },
      quick(),
      [&](long tick) {
        fading_in = std::max(fading_in, tick < 200 ? test::rendered(0).norm() : 0.0);
        in_the_end = std::max(in_the_end, tick > 1000 ? test::rendered(0).norm() : 0.0);
      });
  EXPECT_EQ(hdsim_get_counters(0).amplifier_toggles, 0);
  EXPECT_NEAR(in_the_end, 3.3, 1e-9);
  EXPECT_LE(fading_in, 2.0) << "the driver's own ramp, 10 N/s";
}

TEST_F(OpenHapticsFaults, ReleasesAStrongDeviceAtOnceWithoutTheDriverSwitchingItOff) {
  add_premium();
  const auto device = open_open_haptics(options_for());
  const Outcome outcome = run(*device, [n = 0](const DeviceState&) mutable {
    DeviceCommand command;
    ++n;
    if (n > 100 && n < 400) command.wrench.force.x() = 8;
    command.stop = n >= 500;
    return command;
  });
  EXPECT_EQ(committed(0, 398).force.x(), 8) << "twice the change per tick that the driver's default limit allows";
  EXPECT_EQ(hdsim_get_counters(0).amplifier_toggles, 0);
  EXPECT_EQ(outcome.report.events[std::size_t(SafetyEvent::device_fault)], 0U);
}

TEST_F(OpenHapticsFaults, FadesInAgainAfterTheHandWasTooFastForTheDriver) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  std::vector<double> motors;
  const Outcome outcome = run(*device, test::press_and_release(500, 550, 1000), quick(), [&](long tick) {
    place(0, Pose{}, Vec3(tick >= 480 && tick < 483 ? 1.3 : 0, 0, 0));  // 1.2 m/s are the driver's limit
    motors.push_back(test::rendered(0).x());
  });
  EXPECT_EQ(outcome.report.fault, DeviceFault::none);
  EXPECT_GE(hdsim_get_counters(0).amplifier_toggles, 1);
  EXPECT_GE(outcome.report.events[std::size_t(SafetyEvent::device_fault)], 1U);
  EXPECT_EQ(motors[479], 1);
  for (std::size_t n = 482; n < 550; ++n) EXPECT_LT(motors[n], 0.05) << n;
  EXPECT_EQ(motors[950], 1);
}

TEST_F(OpenHapticsFaults, EndsOnErrorsOfTheProgrammer) {
  add_touch();
  const auto device = open_open_haptics(options_for());
  const Outcome outcome = run(*device, push_for(10000), quick(), [](long tick) {
    if (tick == 200) hdsim_inject_error(0, kInvalidInputType, 0);
  });
  EXPECT_EQ(outcome.report.fault, DeviceFault::driver_error);
  EXPECT_TRUE(committed(0).force.isZero(0));
}

TEST_F(OpenHapticsFaults, DrainsErrorsThatWaitedBeforeItBegan) {
  add_touch();
  hdsim_inject_error(0, kCommError, 7);
  const auto device = open_open_haptics(options_for());
  hdsim_inject_error(0, kCommError, 7);
  EXPECT_EQ(run(*device, push_for(100)).report.fault, DeviceFault::none);
}

TEST_F(OpenHapticsFaults, CalibratesADockedStylusWithoutForceAndWaitsUntilFree) {
  add_touch();
  hdsim_set_calibration(0, kCalibrationNeedsManualInput);
  const std::array<double, 3> jump = {0, 20, 0};  // mm
  hdsim_set_calibration_jump(0, jump.data());
  const auto device = open_open_haptics(options_for());
  bool valid_before = true;
  double y_after = 0;
  const Outcome outcome = run(
      *device,
      [&, n = 0](const DeviceState& state) mutable {
        if (++n == 100) valid_before = state.valid;
        y_after = state.X_BS.translation.y();
        return DeviceCommand{{Vec3(n > 1500 ? 1 : 0, 0, 0), Vec3::Zero()}, n >= 2000};
      },
      quick(),
      [](long tick) {
        if (tick == 500) hdsim_set_calibration(0, kCalibrationNeedsUpdate);  // docked
      });
  EXPECT_FALSE(valid_before);
  EXPECT_NEAR(y_after, 0.020, 1e-12);
  EXPECT_EQ(hdsim_get_counters(0).calibration_updates, 1);
  EXPECT_EQ(outcome.report.arming, ArmingState::on);
}

TEST_F(OpenHapticsFaults, TakesTheForceAwayBeforeACalibrationInContact) {
  add_touch();
  const std::array<double, 3> jump = {0, 20, 0};  // mm
  hdsim_set_calibration_jump(0, jump.data());
  const auto device = open_open_haptics(options_for());
  const Outcome outcome = run(*device, push_for(2500), quick(), [](long tick) {
    if (tick == 500) hdsim_set_calibration(0, kCalibrationNeedsUpdate);
  });
  EXPECT_EQ(hdsim_get_counters(0).calibration_updates, 1);
  EXPECT_EQ(hdsim_get_counters(0).force_during_calibration, 0);
  EXPECT_GE(outcome.report.events[std::size_t(SafetyEvent::recalibrated)], 1U);
  EXPECT_EQ(outcome.report.arming, ArmingState::wait_free);  // because the callback pushes all the time
}

TEST_F(OpenHapticsFaults, ResetsEncodersOnlyWhileTheUserHoldsTheLinks) {
  add_premium();
  hdsim_set_calibration(0, kCalibrationNeedsManualInput);
  try {
    (void)open_open_haptics(options_for());
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("right angles"), std::string::npos) << e.what();
  }
  OpenHapticsOptions held = options_for();
  held.reset_encoders = true;
  EXPECT_EQ(open_open_haptics(held)->capabilities().output_degrees_of_freedom, 6);
  EXPECT_EQ(hdsim_get_counters(0).calibration_updates, 1);
}

TEST_F(OpenHapticsFaults, ReadsNumbersWithADecimalPointInAnyLocale) {
  add_touch();
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  bool found = false;
  for (const char* name : {"de_DE.UTF-8", "pt_BR.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"})
    if (!found) found = std::setlocale(LC_NUMERIC, name) != nullptr;
  const auto device = open_open_haptics(options_for());
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_STREQ(hdsim_get_counters(0).init_locale_point, "1.5");
  if (!found) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

}  // namespace
}  // namespace hapticut::open_haptics_faults_test
