// SPDX-License-Identifier: Apache-2.0
// Contract of the force of every device: its values, when it is on, and that it is off after every end of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "support/devices_under_test.hpp"

namespace hapticut::device_force_contract_test {
namespace {

using namespace test;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

const Wrench kPush{Vec3(1, 0, 0), Vec3::Zero()};

class DeviceForceContract : public DeviceContractTest {
 protected:
  using Act = std::function<void(long n, DeviceCommand&)>;

  /// A callback that presses after 50 free ticks; `act` then changes the command of the n-th tick.
  DeviceCallback pressing(long ticks, Act act = nullptr, Wrench wrench = kPush) {
    return [=, n = 0L](const DeviceState&) mutable {
      DeviceCommand command;
      if (n >= 50) command.wrench = wrench;
      command.stop = n + 1 >= ticks;
      if (act) act(n, command);
      ++n;
      return command;
    };
  }

  /// Runs the device, and records the wrench of the motors at each reading, which is that of the previous tick.
  RunReport run(Device& device, const DeviceCallback& callback, const RunOptions& options = quick()) {
    held.clear();
    return tested.run(
        device,
        [&](const DeviceState& state) {
          held.push_back(tested.held());
          return callback(state);
        },
        options);
  }
  /// The force of the n-th tick of the run.
  [[nodiscard]] const Vec3& force(long n) const { return held.at(std::size_t(n) + 1).force; }
  [[nodiscard]] bool no_force(long from, long to) const {
    return std::all_of(held.begin() + from + 1, held.begin() + to + 1,
                       [](const Wrench& w) { return w.force.isZero(0) && w.torque.isZero(0); });
  }

  std::vector<Wrench> held;
};

class MotorContract : public DeviceForceContract {};
/// Devices whose motors render exactly the commanded wrench, because only the script moves them.
class FixedDeviceForceContract : public DeviceForceContract {};
class FollowingDeviceForceContract : public DeviceForceContract {};
class CableContract : public DeviceForceContract {};
class ClosedLoopContract : public DeviceForceContract {};

// --- its values ------------------------------------------------------------------------------------------------------
TEST_P(FixedDeviceForceContract, IsRenderedInTheTickOfItsCommand) {
  const auto device = tested.open();
  const bool has_torque = device->capabilities().output_degrees_of_freedom == 6;
  const Wrench asked{Vec3(0.5, -0.25, 0.125), has_torque ? Vec3(0.010, 0.005, -0.020) : Vec3::Zero()};
  const RunReport report = run(*device, pressing(200, nullptr, asked));
  EXPECT_EQ(report.arming, ArmingState::on);
  for (long n = 60; n < 199; ++n) {
    ASSERT_LT((force(n) - asked.force).norm(), 1e-12) << n;
    ASSERT_LT((held.at(std::size_t(n) + 1).torque - asked.torque).norm(), 1e-12) << n;
  }
  EXPECT_LT((device->output().applied.force - asked.force).norm(), 1e-12);
  EXPECT_EQ(device->output().changes, OutputChange::none) << describe(device->output().changes);
}

TEST_P(DeviceForceContract, IsNeverAboveItsCapabilities) {
  const auto device = tested.open();
  const double peak = device->capabilities().peak_force, torque = device->capabilities().peak_torque;
  double max_force = 0;
  run(*device, pressing(1000, [&](long n, DeviceCommand& command) {
    if (n < 50) return;
    command.wrench = {Vec3(n % 200 < 100 ? 1000 : -1000, 10, 0), Vec3(0, n % 100 < 50 ? 9 : -9, 0)};
    const DeviceOutput& before = device->last_output();
    max_force = std::max(max_force, before.applied.force.norm());
    if (n < 60 || !traits().follows) return;  // a hand that is thrown around may get no force
    const OutputChange expected = traits().has_motors ? OutputChange::saturated : OutputChange::no_actuator;
    EXPECT_TRUE(has_any(before.changes, expected)) << n << ": " << describe(before.changes);
    EXPECT_EQ(has_any(before.changes, OutputChange::no_actuator), torque == 0) << n;
  }));
  ASSERT_GT(tested.commands(), 0);
  for (long n = 0; n < tested.commands(); ++n) {
    const Wrench w = tested.command(n);
    ASSERT_LE(w.force.norm(), peak * (1 + 1e-9)) << n;
    ASSERT_LE(w.torque.norm(), torque * (1 + 1e-9)) << n;
  }
  EXPECT_NEAR(max_force, peak, 1e-9 * peak);
  if (!traits().has_motors) expect_no_force_since(0);
}

TEST_P(DeviceForceContract, IsZeroForAWrenchThatIsNotFiniteAndReturns) {
  const auto device = tested.open();
  const RunReport report = run(*device, pressing(400, [&](long n, DeviceCommand& command) {
    if (n == 200) command.wrench.force.y() = kNan;
    if (n == 250) command.wrench.torque.x() = kInfinity;
    const OutputChange before = device->last_output().changes;
    EXPECT_EQ(has_any(before, OutputChange::not_finite), n == 201 || n == 251) << n;
  }));
  for (long n = 0; n < tested.commands(); ++n) {
    ASSERT_TRUE(tested.command(n).force.allFinite() && tested.command(n).torque.allFinite()) << n;
  }
  EXPECT_TRUE((no_force(200, 200) && no_force(250, 250)) || !traits().follows);  // a hand that moves may be damped
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::force_not_finite)], 2U);
  EXPECT_EQ(report.arming, ArmingState::on);
  EXPECT_EQ(force(300).norm() > 0.1, traits().has_motors);
}

TEST_P(DeviceForceContract, StaysZeroAfterThreeWrenchesInARowThatAreNotFinite) {
  const auto device = tested.open();
  const RunReport report = run(*device, pressing(400, [&](long n, DeviceCommand& command) {
    if (n >= 200 && n < 203) command.wrench.force = Vec3::Constant(kNan);
  }));
  EXPECT_EQ(report.arming, ArmingState::fault);
  EXPECT_TRUE(no_force(202, 398));
  expect_no_force_now();
}

// --- when it is on ---------------------------------------------------------------------------------------------------
TEST_P(DeviceForceContract, IsZeroWhileTheToolWasNeverFree) {
  const auto device = tested.open();
  const RunReport report = run(*device, pressing(300, [](long, DeviceCommand& command) { command.wrench = kPush; }));
  EXPECT_EQ(report.arming, ArmingState::wait_free);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::start_inside)], 1U);
  expect_no_force_since(0);
}

TEST_P(MotorContract, IsFadedInAndOutAtEveryEndOfARun) {
  const auto device = tested.open();
  for (const char* end : {"the callback", "stop()", "the time"}) {
    SCOPED_TRACE(end);
    const bool by_time = end == std::string("the time"), by_stop = end == std::string("stop()");
    RunOptions options = quick();
    options.seconds = by_time ? 0.1995 : 0;
    options.guard.arming.ramp = 0.05;
    const long before = tested.commands();
    const RunReport report = run(
        *device,
        [&, n = 0](const DeviceState&) mutable {
          DeviceCommand command;
          if (++n > 20) command.wrench = kPush;  // while the force is faded in
          if (n == 200 && by_stop) device->stop();
          command.stop = n == 200 && !by_time && !by_stop;
          return command;
        },
        options);
    EXPECT_EQ(report.ticks, by_time ? 201U : 200U);
    EXPECT_EQ(report.end, by_time ? "its time was up" : by_stop ? "stopped" : "the callback ended it");
    EXPECT_EQ(report.arming, ArmingState::on);
    EXPECT_TRUE(no_force(0, 10)) << "at the start of every run";
    double grown = 0;
    for (long n = 15; n < 65; ++n) grown = std::max(grown, force(n).norm() - force(n - 1).norm());
    EXPECT_LT(grown, 0.2) << "no sudden growth";
    EXPECT_GT(force(150).x(), 0.5);

    long last = tested.commands() - 1;
    while (last > before && tested.command(last - 1).force.isZero(0)) --last;
    ASSERT_GT(last, before + 20);
    const auto ticks = int(std::lround(Servo::kFadeOut / GuardOptions{}.period));
    const double full = tested.command(last - ticks).force.x();
    EXPECT_GT(full, 0.5);
    for (int n = 0; n < ticks; ++n) EXPECT_NEAR(tested.command(last - n).force.x(), full * n / ticks, 1e-9) << n;
    expect_no_force_now();
    tested.expect_left_in_order();
  }
}

TEST_P(DeviceForceContract, IsZeroInTheTickThatThrowsAndTheExceptionIsPassedOn) {
  const auto device = tested.open();
  const DeviceCallback throws = pressing(1000, [](long n, DeviceCommand&) {
    if (n == 150) throw std::runtime_error("the tool broke");
  });
  long before = 0;
  try {
    run(*device, [&](const DeviceState& state) {
      before = tested.commands();
      return throws(state);
    });
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "the tool broke");
  }
  EXPECT_EQ(held.back().force.norm() > 0.1, traits().has_motors);
  EXPECT_GE(tested.commands(), before + 2) << "one in the tick, and one at the end";
  expect_no_force_since(before);
  EXPECT_FALSE(device->is_running());
  EXPECT_EQ(device->arming(), ArmingState::off);
  EXPECT_EQ(device->count(SafetyEvent::exception), 1U);
  tested.expect_left_in_order();
  EXPECT_THROW(run(*device, [](const DeviceState&) -> DeviceCommand { throw 7; }), int) << "whatever it is";
  EXPECT_EQ(run(*device, pressing(150)).arming, ArmingState::on) << "and it runs again";
  EXPECT_EQ(force(140).norm() > 0.1, traits().has_motors);
}

TEST_P(DeviceForceContract, IsZeroInAnEmergencyUntilItIsResetAndTheToolIsFree) {
  const auto device = tested.open();
  const RunReport report = run(*device, pressing(700, [&](long n, DeviceCommand& command) {
    if (n == 200) device->emergency_stop();
    if (n == 300) device->reset_fault();
    if (n >= 400 && n < 450) command.wrench = {};
  }));
  EXPECT_EQ(force(199).norm() > 0.1, traits().has_motors);
  EXPECT_TRUE(no_force(200, 403)) << "it presses until the 400th tick";
  EXPECT_EQ(force(600).norm() > 0.1, traits().has_motors);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::fault)], 1U);
  EXPECT_EQ(report.arming, ArmingState::on);
}

TEST_P(DeviceForceContract, IsZeroAtOnceWhenAnEmergencyEndsTheRun) {
  const auto device = tested.open();
  long before = 0;
  run(*device, pressing(200, [&](long n, DeviceCommand& command) {
    before = tested.commands();
    if (n == 150) device->emergency_stop();
    command.stop = n == 150;
  }));
  expect_no_force_since(before);
}

TEST_P(DeviceForceContract, IsZeroInARunAfterAnEmergencyWithoutReset) {
  const auto device = tested.open();
  device->emergency_stop();
  for (int n = 0; n < 2; ++n) EXPECT_EQ(run(*device, pressing(200)).arming, ArmingState::fault);
  expect_no_force_since(0);
  device->reset_fault();
  EXPECT_EQ(run(*device, pressing(200)).arming, ArmingState::on);
  EXPECT_EQ(force(190).norm() > 0.1, traits().has_motors);
}

TEST_P(DeviceForceContract, WaitsForAFreeToolAfterAnInterruption) {
  const auto device = tested.open();
  const RunReport report = run(*device, pressing(500, [&](long n, DeviceCommand& command) {
    if (n == 200) device->interrupt(SafetyEvent::reclutched);
    if (n >= 300 && n < 350) command.wrench = {};
  }));
  EXPECT_EQ(force(200).norm() > 0.1, traits().has_motors);
  EXPECT_TRUE(no_force(201, 303));
  EXPECT_EQ(force(450).norm() > 0.1, traits().has_motors);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::reclutched)], 1U);
}

// --- when the device fails ------------------------------------------------------------------------------------------
TEST_P(FollowingDeviceForceContract, StaysZeroWhenThePoseStaysNotFinite) {
  tested.script = [](long tick) { return ScriptedTick{{}, {}, 0, tick >= 200, false}; };
  const auto device = tested.open();
  const RunReport report = run(*device, pressing(500));
  EXPECT_EQ(report.arming, ArmingState::fault);
  EXPECT_GE(report.events[std::size_t(SafetyEvent::pose_not_finite)], 1U);
  EXPECT_EQ(force(199).norm() > 0.1, traits().has_motors);
  EXPECT_TRUE(no_force(225, 498)) << "the last good pose replaces the reading for 20 ticks";
  for (long n = 0; n < tested.commands(); ++n) ASSERT_TRUE(tested.command(n).force.allFinite());
  EXPECT_FALSE(device->state().valid);
  EXPECT_TRUE(is_finite(device->state().X_BS));
  expect_no_force_now();
}

TEST_P(CableContract, EndsWithoutForceAndSaysWhyWhenItIsUnplugged) {
  tested.script = [](long tick) { return ScriptedTick{{}, {}, 0, false, tick >= 200}; };
  auto device = tested.open();
  const RunReport report = run(*device, pressing(10000));
  EXPECT_EQ(report.fault, DeviceFault::disconnected);
  EXPECT_TRUE(contains(report.end, "cable")) << report.end;
  EXPECT_GE(report.ticks, 201U);
  EXPECT_LE(report.ticks, 203U) << "at once";
  EXPECT_FALSE(device->is_running());
  EXPECT_EQ(device->state().fault, DeviceFault::disconnected);
  EXPECT_TRUE(device->output().applied.force.isZero(0));
  expect_no_force_now();
  device.reset();
  expect_no_force_now();
}

// The loop of stability_test.cpp with the whole device and the guard in the loop: they add no delay.
TEST_P(ClosedLoopContract, AddsNoDelay) {
  const auto swing = [&](double stiffness) {
    NudgedPlant plant("touch");
    tested.script = [&](long tick) {
      plant.before_reading(tick, tested.held());
      return ScriptedTick{plant.pose(), {plant.velocity(), Vec3::Zero()}};
    };
    tested.run(*tested.open(), NudgedPlant::wall(stiffness), NudgedPlant::options());
    return plant.growth();
  };
  const double limit = 2 * 0.20 / 1e-3;  // 2 b / T = 400 N/m
  EXPECT_LT(swing(0.98 * limit), 1);
  EXPECT_GT(swing(1.02 * limit), 1);
}

INSTANTIATE_TEST_SUITE_P(Devices, DeviceForceContract, testing::ValuesIn(devices_under_test()), kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, MotorContract, testing::ValuesIn(devices_that({&DeviceTraits::has_motors})),
                         kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, FixedDeviceForceContract,
                         testing::ValuesIn(devices_that({&DeviceTraits::follows, &DeviceTraits::has_motors})),
                         kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, FollowingDeviceForceContract,
                         testing::ValuesIn(devices_that({&DeviceTraits::follows})), kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, CableContract, testing::ValuesIn(devices_that({&DeviceTraits::has_cable})),
                         kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, ClosedLoopContract,
                         testing::ValuesIn(devices_that({&DeviceTraits::follows, &DeviceTraits::is_live,
                                                         &DeviceTraits::has_motors})),
                         kNameOfDevice);

}  // namespace
}  // namespace hapticut::device_force_contract_test
