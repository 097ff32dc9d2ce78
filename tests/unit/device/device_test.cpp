// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/device.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "hapticut/bench/closed_loop.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "support/written_device.hpp"

namespace hapticut::device_test {
namespace {

/// Exact periods, no wall clock.
RunOptions simulated(double seconds) {
  RunOptions options;
  options.seconds = seconds;
  options.simulated_time = true;
  return options;
}

using test::pushing;
using test::real;
using test::WrittenDevice;

DeviceCommand wall(const DeviceState& state) {
  DeviceCommand command;
  command.wrench.force.z() = std::max(0.0, -300 * state.X_BS.translation.z());
  return command;
}

TEST(OpenDevice, SaysWhatWasAskedWhatThereIsAndWhatToInstall) {
  try {
    (void)open_device("falcon:1");
    FAIL();
  } catch (const Error& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("falcon:1"), std::string::npos) << text;
    EXPECT_NE(text.find("mock:PATH"), std::string::npos) << text;
    EXPECT_NE(text.find("openhaptics[:NAME]"), std::string::npos) << text;
  }
  try {
    (void)open_device("mock:figure-of-eight");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("spiral"), std::string::npos) << e.what();
  }
  EXPECT_THROW((void)open_device("mock:spiral,hand=robot"), Error);
  EXPECT_THROW((void)open_device("mock:spiral,speed=3"), Error);
  EXPECT_THROW((void)open_device("mock:spiral,seconds=-1"), Error);
}

TEST(OpenDevice, FindsDriversThatOthersRegister) {
  register_device_driver(
      {"written", "written", "", [](const std::string&) { return std::make_unique<WrittenDevice>(); }});
  EXPECT_EQ(open_device("written")->name(), "written");
  register_device_driver({"written", "written", "the moon", nullptr});
  try {
    (void)open_device("written");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("install the moon"), std::string::npos) << e.what();
  }
}

TEST(MockDevice, FollowsItsPathExactlyWhenRigid) {
  const auto device = open_device("mock:spiral");
  const ScriptedPath path = scripted_path("spiral");
  long ticks = 0;
  const RunReport report = device->run(
      [&](const DeviceState& state) {
        EXPECT_EQ(state.X_BS.translation, path(double(ticks++) * 1e-3).translation);
        return wall(state);
      },
      simulated(5));
  EXPECT_EQ(report.ticks, 5001U);
  EXPECT_EQ(report.guard, ArmingState::on);
  EXPECT_EQ(report.missed, 0U);
}

TEST(MockDevice, IsMovedByTheForceWhenAHandHoldsIt) {
  const auto deepest = [](const char* name) {
    double z = 0;
    open_device(name)->run(
        [&](const DeviceState& state) {
          z = state.X_BS.translation.z();
          return wall(state);
        },
        simulated(6));
    return z;
  };
  EXPECT_NEAR(deepest("mock:press"), -5e-3, 1e-9);
  // The set point is 5 mm deep; hand and wall of 300 N/m each share the way, give or take dry friction and encoder.
  EXPECT_NEAR(deepest("mock:press,hand=nominal"), -2.5e-3, 0.3e-3);
  EXPECT_LT(deepest("mock:press,hand=firm"), deepest("mock:press,hand=light"));
}

TEST(MockDevice, GivesTheSameReadingsOnEveryRun) {
  const auto run = [] {
    std::vector<Vec3> positions;
    open_device("mock:circle,hand=nominal-pad,device=premium6dof")
        ->run(
            [&](const DeviceState& state) {
              positions.push_back(state.X_BS.translation);
              return wall(state);
            },
            simulated(4));
    return positions;
  };
  EXPECT_EQ(run(), run());
}

TEST(MockDevice, EndsWhenItsScriptEnds) {
  const RunReport report = open_device("mock:line,seconds=0.5")->run(wall, simulated(0));
  EXPECT_EQ(report.ticks, 500U);
  EXPECT_EQ(report.end, "the device has nothing more to tell");
}

TEST(Device, ReachesEveryStateOfItsRunFromOtherThreads) {
  const auto device = open_device("mock:press");
  std::thread observer;
  std::atomic<bool> seen{false}, begun{false};
  observer = std::thread([&] {
    while (!begun.load()) std::this_thread::yield();
    while (device->is_running()) {
      const DeviceOutput output = device->output();
      const DeviceState state = device->state();
      if (output.applied.force.z() > 0.1 && state.sequence > 0 && device->arming() == ArmingState::on) {
        seen.store(true);
        device->stop();
      }
    }
  });
  const RunReport report = device->run(
      [&](const DeviceState& state) {
        begun.store(true);
        return wall(state);
      },
      simulated(0));
  observer.join();
  EXPECT_TRUE(seen.load());
  EXPECT_EQ(report.end, "stopped");
  EXPECT_GT(report.events[std::size_t(SafetyEvent::engaged)], 0U);
}

TEST(Device, FadesTheForceOutBeforeARunEnds) {
  WrittenDevice device;
  RunOptions options = simulated(3);
  device.run(pushing(), options);
  ASSERT_GT(device.forces.size(), 40U);
  EXPECT_TRUE(device.forces.back().isZero(0));
  const std::size_t end = device.forces.size();
  for (std::size_t n = end - 20; n < end; ++n) {
    EXPECT_LT(device.forces[n].x(), device.forces[n - 1].x());
    EXPECT_NEAR(device.forces[n - 1].x() - device.forces[n].x(), 1.0 / 20, 1e-9);
  }
}

TEST(Device, GivesNoForceAfterTheCallbackThrewAndPassesTheExceptionOn) {
  WrittenDevice device;
  const DeviceCallback push = pushing();
  const auto throwing = [&](const DeviceState& state) {
    if (state.time > 2.5) throw std::runtime_error("tool broke");
    return push(state);
  };
  EXPECT_THROW(device.run(throwing, simulated(3)), std::runtime_error);
  EXPECT_TRUE(device.forces.back().isZero(0));
  EXPECT_TRUE(device.forces[device.forces.size() - 2].isZero(0));  // of the very tick that threw
  EXPECT_EQ(device.forces[device.forces.size() - 3].x(), 1);
  EXPECT_FALSE(device.is_running());
  EXPECT_EQ(device.count(SafetyEvent::exception), 1U);
}

TEST(Device, EndsWithoutForceWhenItIsUnplugged) {
  WrittenDevice device;
  device.next = [](DeviceState& state) {
    if (state.time > 2.5) {
      state.fault = DeviceFault::disconnected;
      state.valid = false;
    }
    return true;
  };
  const RunReport report = device.run(pushing(), simulated(0));
  EXPECT_EQ(report.fault, DeviceFault::disconnected);
  EXPECT_NE(report.end.find("cable"), std::string::npos) << report.end;
  EXPECT_TRUE(device.forces.back().isZero(0));
  EXPECT_TRUE(device.forces[device.forces.size() - 2].isZero(0));
}

TEST(Device, CanRunAgain) {
  WrittenDevice device;
  for (int n = 0; n < 3; ++n) {
    device.forces.clear();
    EXPECT_EQ(device.run(pushing(), simulated(2)).guard, ArmingState::on);
    EXPECT_TRUE(device.forces.front().isZero(0));
    EXPECT_TRUE(device.forces.back().isZero(0));
  }
}

TEST(Device, RefusesToRunTwiceAtOnceAndWithoutACallback) {
  WrittenDevice device;
  EXPECT_THROW(device.run(nullptr), Error);
  device.run(
      [&](const DeviceState&) {
        EXPECT_THROW(device.run(pushing(), simulated(1)), Error);
        return DeviceCommand{{}, true};
      },
      simulated(1));
}

TEST(Device, EmergencyStopLastsUntilReset) {
  WrittenDevice device;
  const DeviceCallback push = pushing();
  const RunReport report = device.run(
      [&](const DeviceState& state) {
        if (std::abs(state.time - 2.5) < 1e-9) device.emergency_stop();
        if (std::abs(state.time - 3.0) < 1e-9) device.reset_fault();
        DeviceCommand command = push(state);
        if (state.time > 3 && state.time < 3.2) command.wrench = {};
        return command;
      },
      simulated(5.5));
  EXPECT_EQ(device.forces[2490].x(), 1);
  for (std::size_t n = 2501; n < 3190; ++n) EXPECT_TRUE(device.forces[n].isZero(0)) << n;
  EXPECT_EQ(device.forces[5400].x(), 1);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::fault)], 1U);
}

TEST(Device, AWatchdogFadesTheForceOfADeviceWhoseLoopHangs) {
  for (const bool latch : {false, true}) {
    WrittenDevice device;
    device.next = [](DeviceState& state) {
      state.time = monotonic_time();
      return true;
    };
    double least = 1;
    bool hung = false;
    RunOptions options = real(0);
    options.guard.watchdog.latch = latch;
    const RunReport report = device.run(
        [&](const DeviceState& state) {
          if (state.sequence == 20 && !std::exchange(hung, true))
            while (least = device.share.load(), device.count(SafetyEvent::watchdog_fault) == 0)
              std::this_thread::sleep_for(std::chrono::milliseconds(1));
          return DeviceCommand{{Vec3(0, 0, state.sequence > 20 ? 1 : 0), Vec3::Zero()}, state.sequence > 60};
        },
        options);
    EXPECT_EQ(least, 0);
    // The other thread has said so, in the order of what it saw; on a busy machine it may have woken up too late for
    // some.
    EXPECT_TRUE(std::any_of(report.log.begin(), report.log.end(), [](const SafetyLogEntry& entry) {
      return entry.event == SafetyEvent::watchdog_fault && entry.value == 0;
    }));
    // The loop that comes back late gives no force: it waits until the tool is free, or fails where it is told to.
    EXPECT_GE(report.events[std::size_t(SafetyEvent::paused)], 1U);
    EXPECT_EQ(report.guard, latch ? ArmingState::fault : ArmingState::wait_free);
    EXPECT_TRUE(device.forces.back().isZero(0));
  }
}

}  // namespace
}  // namespace hapticut::device_test
