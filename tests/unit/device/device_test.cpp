// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/device.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "support/written_device.hpp"

namespace hapticut::device_test {
namespace {

/// Options with exact periods, without the wall clock.
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

TEST(OpenDevice, RefusesAnUnknownDeviceWithItsNameTheKnownOnesAndTheCure) {
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

TEST(OpenDevice, NamesTheCallThatIsMissingWhereTheBuildHasTheDevice) {
  try {
    (void)open_device("replay:run.h5");
    FAIL();
  } catch (const Error& e) {
    const std::string text = e.what();
#ifdef HAPTICUT_HAS_IO
    EXPECT_NE(text.find("call hapticut::use_recordings()"), std::string::npos) << text;
    EXPECT_EQ(text.find("install"), std::string::npos) << text;
    EXPECT_EQ(text.find("this build;"), std::string::npos) << text;
#else
    EXPECT_NE(text.find("-DHAPTICUT_WITH_IO=ON"), std::string::npos) << text;
#endif
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
  EXPECT_EQ(report.arming, ArmingState::on);
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
  // The set point is 5 mm deep. Hand and wall of 300 N/m each share this depth, except for dry friction and encoder.
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
  EXPECT_EQ(report.end, "the device has no more readings");
}

/// A mock whose driver has a new reading only in every third tick.
class SlowDevice : public MockDevice {
 public:
  using MockDevice::MockDevice;
  std::vector<double> written;  // [N]

 protected:
  bool read(DeviceState& state) noexcept override {
    DeviceState now;
    const bool more = MockDevice::read(now);
    if (tick_++ % 3 == 0) latest_ = now;
    state = latest_;
    return more;
  }
  Wrench write(const Wrench& wrench) noexcept override {
    written.push_back(wrench.force.z());
    return MockDevice::write(wrench);
  }

 private:
  int tick_ = 0;
  DeviceState latest_;
};

TEST(Device, CallsBackOnceForEachReadingAndRendersTheCommandUntilTheNext) {
  MockOptions options;
  options.path = scripted_path("line");
  SlowDevice device(options);
  std::uint64_t calls = 0;
  const RunReport report = device.run(
      [&](const DeviceState&) {
        DeviceCommand command;
        command.wrench.force.z() = ++calls % 2 == 0 ? 1e-3 : 2e-3;
        return command;
      },
      simulated(3));
  EXPECT_NEAR(double(calls), double(report.ticks) / 3, 2);
  ASSERT_EQ(report.arming, ArmingState::on);
  ASSERT_GT(device.written.size(), 2900U);
  for (std::size_t n = 2700; n + 2 < 2850; n += 3) {  // groups of three, which begin at a reading
    EXPECT_NEAR(device.written[n], (n / 3 + 1) % 2 == 0 ? 1e-3 : 2e-3, 1e-9) << n;
    EXPECT_EQ(device.written[n], device.written[n + 1]) << n;
    EXPECT_EQ(device.written[n], device.written[n + 2]) << n;
  }
}

TEST(Device, AnEmergencyStopWhileTheForceFadesOutEndsItAtOnce) {
  WrittenDevice device;
  RunOptions options = simulated(0.3);
  options.guard.arming.ramp = 0.02;
  bool fading = false;
  device.on_write = [&](const Vec3& force) {
    if (fading && force.x() < 0.55) device.emergency_stop();
    fading = fading || force.x() == 1;
  };
  device.run(pushing(), options);
  ASSERT_GT(device.forces.size(), 20U);
  EXPECT_TRUE(device.forces.back().isZero(0));
  EXPECT_NEAR(device.forces[device.forces.size() - 2].x(), 0.5, 1e-9) << "half of the force was left";
}

#ifndef NDEBUG
TEST(Device, IsAMistakeToCloseWhileItRuns) {
  const auto close_inside = [] {
    auto device = std::make_unique<WrittenDevice>();
    device->run(
        [&](const DeviceState&) {
          device.reset();
          return DeviceCommand{};
        },
        simulated(1));
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(close_inside(), "idle");
}
#endif

/// A device that takes as long to end a run as some drivers do.
class SlowToClose final : public WrittenDevice {
  void end_run() noexcept override { std::this_thread::sleep_for(std::chrono::milliseconds(100)); }
};

TEST(Device, NoWatchdogMissesAForceAfterTheLastOne) {
  bool missed = true;
  for (int n = 0; n < 5 && missed; ++n) {  // the machine may pause during a run
    SlowToClose device;
    const RunReport report = device.run(
        [](const DeviceState& state) {
          return DeviceCommand{{}, state.sequence >= 20};
        },
        real(0));
    missed = report.events[std::size_t(SafetyEvent::watchdog_fading)] != 0 ||
             report.events[std::size_t(SafetyEvent::watchdog_fault)] != 0;
  }
  EXPECT_FALSE(missed);
}

TEST(Device, AWatchdogFadesTheForceOfADeviceWhoseLoopHangs) {
  for (const bool latch : {false, true}) {
    WrittenDevice device;
    device.next = [](DeviceState& state) {
      state.time = monotonic_time();
      return true;
    };
    double min_scale = 1;
    bool hung = false;
    RunOptions options = real(0);
    options.guard.watchdog.latch = latch;
    const RunReport report = device.run(
        [&](const DeviceState& state) {
          if (state.sequence == 20 && !std::exchange(hung, true)) {
            for (int n = 0; n < 20000 && (device.share > 0 || device.count(SafetyEvent::watchdog_fault) == 0); ++n)
              std::this_thread::sleep_for(std::chrono::milliseconds(1));
            min_scale = device.share;
          }
          return DeviceCommand{{Vec3(0, 0, state.sequence > 20 ? 1 : 0), Vec3::Zero()}, state.sequence > 60};
        },
        options);
    EXPECT_EQ(min_scale, 0);
    // The watchdog's thread has reported the fault. On a busy machine it may have woken up too late for earlier events.
    EXPECT_TRUE(std::any_of(report.log.begin(), report.log.end(), [](const SafetyLogEntry& entry) {
      return entry.event == SafetyEvent::watchdog_fault && entry.value == 0;
    }));
    // A loop that resumes late has no force: it waits until the tool is free, or is in the fault state with `latch`.
    EXPECT_GE(report.events[std::size_t(SafetyEvent::paused)], 1U);
    EXPECT_EQ(report.arming, latch ? ArmingState::fault : ArmingState::wait_free);
    EXPECT_TRUE(device.forces.back().isZero(0));
  }
}

}  // namespace
}  // namespace hapticut::device_test
