// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "force_dimension/tests/force_dimension.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut::force_dimension_faults_test {
namespace {

using namespace test;

class ForceDimensionFaults : public ForceDimensionTest {};

TEST_F(ForceDimensionFaults, FadesInAgainAfterItsWatchdogHasTripped) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  std::vector<double> forces;
  DeviceFault fault = DeviceFault::none;
  double noticed = 0;  // [s]
  const RunReport report = run(
      *device,
      [&, press = press_and_release(600, 606, 1000)](const DeviceState& state) mutable {
        if (fault == DeviceFault::none && state.fault != fault) noticed = state.time;
        if (state.fault != DeviceFault::none) fault = state.fault;
        return press(state);
      },
      quick(),
      [&](long tick) {
        forces.push_back(rendered_wrench(0).force.x());
        // The loop pauses for a time that the watchdog (20 ms) allows, and later for one that it does not.
        if (tick == 200) dhdsim_advance(15e-3);
        if (tick == 199 || tick == 201) {
          EXPECT_EQ(dhdsim_get_counters(0).force_on, 1);
        }
        if (tick == 403) dhdsim_advance(20e-3);
        if (tick == 403) {
          EXPECT_EQ(dhdsim_get_counters(0).force_on, 0) << "no command, so no force";
        }
      });
  EXPECT_EQ(report.ticks, 1000U);
  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_EQ(fault, DeviceFault::overloaded);
  EXPECT_NEAR(noticed, 0.403 + 0.015 + 0.020, 1e-6) << "in the same tick, not at the next poll of the status";
  EXPECT_GE(report.events[std::size_t(SafetyEvent::device_fault)], 1U);
  EXPECT_TRUE(says(report.warnings, "forces off once: its watchdog waited too long"));
  for (std::size_t n = 404; n <= 606; ++n) EXPECT_EQ(forces[n], 0) << n;
  EXPECT_GT(forces[612], 0) << "faded in";
  EXPECT_LT(forces[612], 0.9);
  EXPECT_EQ(forces[900], 1);
  EXPECT_EQ(dhdsim_get_counters(0).enables, 2);
  expect_safe(0);
}

TEST_F(ForceDimensionFaults, FadesInAgainAfterItBrakedBecauseTheHandWasTooFast) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  std::vector<double> forces;
  DeviceFault fault = DeviceFault::none;
  const RunReport report = run(
      *device,
      [&, press = press_and_release(600, 606, 1000)](const DeviceState& state) mutable {
        if (state.fault != DeviceFault::none) fault = state.fault;
        return press(state);
      },
      quick(),
      [&](long tick) {
        place_omega(0, Pose{}, {Vec3(tick >= 400 && tick < 405 ? 1.3 : 0, 0, 0), Vec3::Zero()});  // its limit is 1 m/s
        if (tick == 410) {
          EXPECT_EQ(dhdsim_get_counters(0).brakes_on, 1);
        }
        forces.push_back(rendered_wrench(0).force.x());
      });
  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_EQ(fault, DeviceFault::speed_limit);
  EXPECT_TRUE(says(report.warnings, "moved faster than it allows, and braked"));
  EXPECT_EQ(forces[400], 1);
  for (std::size_t n = 402; n <= 606; ++n) EXPECT_EQ(forces[n], 0) << n;
  EXPECT_EQ(forces[900], 1);
  expect_safe(0);
}

TEST_F(ForceDimensionFaults, StaysOffUntilTheUserSwitchesItsForcesOnAgain) {
  const std::array<std::pair<dhdsim_cause, const char*>, 3> causes = {{
      {DHDSIM_OFF_BUTTON, "its force button was pressed"},
      {DHDSIM_OFF_DEADMAN, "dead man's switch was released"},
      {DHDSIM_OFF_SOFTWARE, "a program switched them off"},
  }};
  for (const auto& [cause, words] : causes) {
    dhdsim_reset();
    add(kOmega6);
    const auto device = open_force_dimension(options_for());
    std::vector<double> forces;
    DeviceFault fault = DeviceFault::none;
    const RunReport report = run(
        *device,
        [&, press = press_and_release(600, 606, 1000)](const DeviceState& state) mutable {
          if (state.fault != DeviceFault::none) fault = state.fault;
          return press(state);
        },
        quick(),
        [&, cause = cause](long tick) {
          if (tick == 200) dhdsim_switch_off(0, cause);
          if (tick == 500) dhdsim_switch_on(0);  // while the hand still presses
          forces.push_back(rendered_wrench(0).force.x());
        });
    EXPECT_EQ(fault, DeviceFault::switched_off) << words;
    EXPECT_NE(describe(fault).find("motors were switched off"), std::string::npos);
    EXPECT_EQ(report.fault, DeviceFault::none) << words;
    EXPECT_TRUE(says(report.warnings, words)) << words;
    EXPECT_EQ(dhdsim_get_counters(0).enables_in_vain, 0) << "never while the user keeps them off: " << words;
    for (std::size_t n = 200; n <= 606; ++n) EXPECT_EQ(forces[n], 0) << words << ", tick " << n;
    EXPECT_EQ(forces[900], 1) << words;
  }
}

TEST_F(ForceDimensionFaults, EndsWhenTheDeviceReportsALostConnection) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  const RunReport report = run(*device, push_for(10000), quick(), [](long tick) {
    if (tick == 300) dhdsim_switch_off(0, DHDSIM_OFF_USBDISCN);
  });
  EXPECT_EQ(report.fault, DeviceFault::disconnected);
  EXPECT_LE(report.ticks, 312U);
  EXPECT_TRUE(says(report.warnings, "USB connection was lost"));
  expect_safe(0);
}

TEST_F(ForceDimensionFaults, ReportsTheErrorOfTheLibraryWhenItIsUnplugged) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  const RunReport report = run(*device, push_for(10000), quick(), [](long tick) {
    if (tick == 300) dhdsim_unplug(0);
  });
  EXPECT_EQ(report.ticks, 301U);
  EXPECT_TRUE(says(report.warnings, "communication error (stand-in) (error 2)"));
}

TEST_F(ForceDimensionFaults, ContinuesAfterShortTimeoutsAndEndsWhenTheDeviceNoLongerAnswers) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  RunReport report = run(*device, push_for(1000), quick(), [](long tick) {
    if (tick == 300) dhdsim_fail(0, DHDSIM_READ, kErrorTimeout, 3);
    if (tick == 400) dhdsim_fail(0, DHDSIM_WRITE, kErrorTimeout, 3);
    if (tick == 500) dhdsim_fail(0, DHDSIM_VELOCITY, kErrorTimeout, 3);
    if (tick == 600) dhdsim_fail(0, DHDSIM_STATUS, kErrorTimeout, 3);
  });
  EXPECT_EQ(report.ticks, 1000U);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::reading_invalid)], 3U);
  EXPECT_EQ(report.arming, ArmingState::on);
  for (const dhdsim_call call : {DHDSIM_READ, DHDSIM_WRITE}) {
    report = run(*device, push_for(1000), quick(), [&](long tick) {
      if (tick == 300) dhdsim_fail(0, call, kErrorTimeout, 100000);
    });
    EXPECT_EQ(report.fault, DeviceFault::disconnected) << call;
    EXPECT_LE(report.ticks, 403U) << call;
    dhdsim_fail(0, call, 0, 0);
  }
}

TEST_F(ForceDimensionFaults, ReportsTheRenderedForceWhenACommandIsLost) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  run(
      *device,
      [&, n = 0](const DeviceState&) mutable {
        DeviceCommand command;
        if (++n > 50) command.wrench.force.x() = n <= 300 ? 1 : 0.5;
        command.stop = n >= 400;
        if (n > 2) {
          EXPECT_EQ(device->last_output().applied.force, rendered_wrench(0).force) << n;
          EXPECT_EQ(has_any(device->last_output().changes, OutputChange::by_driver), n > 301 && n <= 304) << n;
        }
        return command;
      },
      quick(),
      [](long tick) {
        if (tick == 300) dhdsim_fail(0, DHDSIM_WRITE, kErrorTimeout, 3);
      });
}

TEST_F(ForceDimensionFaults, EndsOnErrorsOfTheProgrammer) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  const RunReport report = run(*device, push_for(10000), quick(), [](long tick) {
    if (tick == 200) dhdsim_fail(0, DHDSIM_WRITE, kErrorInvalid, 1);
  });
  EXPECT_EQ(report.fault, DeviceFault::driver_error);
  EXPECT_TRUE(says(report.warnings, "(error 21)"));
  expect_safe(0);
}

TEST_F(ForceDimensionFaults, ReportsForcesThatCannotBeSwitchedOnAndAllowsAnotherRun) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  dhdsim_fail(0, DHDSIM_ENABLE, kErrorInvalid, 1);
  try {
    run(*device, push_for(5));
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("cannot switch its forces on: some error (stand-in) (error 21)"),
              std::string::npos)
        << e.what();
  }
  expect_safe(0);
  EXPECT_EQ(run(*device, push_for(5)).ticks, 5U);
}

TEST_F(ForceDimensionFaults, GivesNoForceUntilItIsCalibrated) {
  for (const bool wrist : {false, true}) {
    dhdsim_reset();
    add(kOmega6);
    if (wrist)
      dhdsim_set_wrist_initialised(0, 0);
    else
      dhdsim_set_calibrated(0, 0);
    const auto device = open_force_dimension(options_for());
    DeviceFault before = DeviceFault::none;
    const RunReport report = run(
        *device,
        [&, n = 0](const DeviceState& state) mutable {
          DeviceCommand command;
          if (++n == 400) before = state.fault;
          if (n > 1000) command.wrench.force.x() = 1;
          command.stop = n >= 1500;
          return command;
        },
        quick(),
        [](long tick) {
          if (tick == 500) dhdsim_set_calibrated(0, 1);
          if (tick == 500) dhdsim_set_wrist_initialised(0, 1);
        });
    EXPECT_EQ(before, DeviceFault::uncalibrated) << wrist;
    EXPECT_EQ(report.arming, ArmingState::on) << wrist;
    EXPECT_EQ(rendered_wrench(0, dhdsim_committed_count(0) - 40).force.x(), 1) << wrist;
    expect_safe(0);
  }
}

TEST_F(ForceDimensionFaults, FailsWhenItLosesItsCalibrationAndContinuesAfterAReset) {
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  std::vector<double> forces;
  std::uint32_t epoch = 0;
  const RunReport report = run(
      *device,
      [&, n = 0](const DeviceState& state) mutable {
        DeviceCommand command;
        epoch = state.epoch;
        if (++n == 600) device->reset_fault();
        if (n > 50 && (n < 600 || n > 900)) command.wrench.force.x() = 1;
        command.stop = n >= 1200;
        return command;
      },
      quick(),
      [&](long tick) {
        if (tick == 300) dhdsim_set_calibrated(0, 0);
        if (tick == 400) dhdsim_set_calibrated(0, 1);
        forces.push_back(rendered_wrench(0).force.x());
      });
  EXPECT_GE(report.events[std::size_t(SafetyEvent::fault)], 1U);
  EXPECT_EQ(epoch, 1U) << "poses before and after are not comparable";
  for (std::size_t n = 300; n <= 900; ++n) EXPECT_EQ(forces[n], 0) << n;
  EXPECT_EQ(forces[1100], 1);
}

TEST_F(ForceDimensionFaults, CalibratesItselfOnRequest) {
  add(kOmega6);
  dhdsim_set_calibrated(0, 0);
  ForceDimensionOptions options = options_for();
  options.calibrate = true;
  const auto device = open_force_dimension(options);
  EXPECT_EQ(dhdsim_get_counters(0).auto_inits, 1);
  EXPECT_EQ(run(*device, push_for(300)).arming, ArmingState::on);
}

TEST_F(ForceDimensionFaults, WarnsThatADeviceWithoutWatchdogKeepsItsLastForce) {
  add(kFalcon);
  const auto device = open_force_dimension(options_for());
  const RunReport report = run(*device, push_for(200));
  EXPECT_EQ(report.arming, ArmingState::on);
  EXPECT_TRUE(says(report.warnings, "has no watchdog"));
}

TEST_F(ForceDimensionFaults, FadesTheForceOutWhileTheCallbackHangs) {
  add(kFalcon);  // without a watchdog
  dhdsim_use_real_time(1);
  const auto device = open_force_dimension();
  RunOptions options = quick();
  options.realtime = {0, false, true, -1, 0};
  options.guard.late = options.guard.pause = 1;  // a busy machine is late too
  bool pushed = false, faded = false;
  device->run(
      [&, n = 0](const DeviceState&) mutable {
        DeviceCommand command;
        if (++n > 50) command.wrench.force.x() = 1;
        command.stop = n > 20000 || pushed;
        if (rendered_wrench(0).force.x() < 0.9) return command;
        pushed = true;
        for (int waited = 0; waited < 10000 && !faded; ++waited) {  // here it hangs
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
          faded = rendered_wrench(0).force.isZero(0);
        }
        return command;
      },
      options);
  EXPECT_TRUE(pushed);
  EXPECT_TRUE(faded);
}

}  // namespace
}  // namespace hapticut::force_dimension_faults_test
