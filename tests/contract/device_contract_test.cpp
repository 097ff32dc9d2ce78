// SPDX-License-Identifier: Apache-2.0
// Contract of every device with the loop: how it is opened, run and closed. Its readings are tested in
// device_reading_contract_test.cpp, its force in device_force_contract_test.cpp, and its allocations in
// device_allocation_test.cpp.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <type_traits>

#include "support/devices_under_test.hpp"

namespace hapticut::device_contract_test {
namespace {

using namespace test;

class DeviceContract : public DeviceContractTest {};
/// Devices that use their maker's library, and simulated devices.
class MakersDeviceContract : public DeviceContract {};
class SimulatedDeviceContract : public DeviceContract {};

// A device can be neither copied nor moved; programs hold it by a pointer.
static_assert(!std::is_copy_constructible_v<Device> && !std::is_move_constructible_v<Device>);
static_assert(!std::is_copy_assignable_v<Device> && !std::is_move_assignable_v<Device>);
static_assert(!std::is_move_constructible_v<MockDevice> && !std::is_move_constructible_v<MouseDevice> &&
              !std::is_move_constructible_v<PlaybackDevice> && !std::is_move_constructible_v<WrittenDevice>);
static_assert(std::has_virtual_destructor_v<Device>);

// --- its properties --------------------------------------------------------------------------------------------------
TEST_P(DeviceContract, DescribesItselfAndItsCapabilitiesInSiUnits) {
  const auto device = tested.open();
  const DeviceCapabilities& c = device->capabilities();
  EXPECT_FALSE(device->name().empty());
  EXPECT_FALSE(c.model.empty());
  EXPECT_FALSE(c.vendor.empty());
  EXPECT_TRUE(c.input_degrees_of_freedom == 3 || c.input_degrees_of_freedom == 6);
  EXPECT_EQ(c.output_degrees_of_freedom >= 3, traits().has_motors);
  EXPECT_TRUE(c.output_degrees_of_freedom == 0 || c.output_degrees_of_freedom == 3 || c.output_degrees_of_freedom == 6);
  EXPECT_EQ(c.peak_force > 0, c.output_degrees_of_freedom >= 3);
  EXPECT_EQ(c.peak_torque > 0, c.output_degrees_of_freedom == 6);
  EXPECT_TRUE(c.continuous_force >= 0 && c.continuous_force <= c.peak_force);
  EXPECT_TRUE(c.continuous_torque >= 0 && c.continuous_torque <= c.peak_torque);
  EXPECT_LT(c.peak_force, 100) << "N";
  EXPECT_LT(c.peak_torque, 5) << "N·m, not mN·m";
  EXPECT_TRUE(c.stiffness >= 0 && std::isfinite(c.stiffness));
  EXPECT_TRUE(c.stiffness == 0 || c.stiffness > 50) << "N/m, not N/mm";
  EXPECT_TRUE(c.damping >= 0 && std::isfinite(c.damping));
  EXPECT_TRUE(c.rotational_stiffness >= 0 && std::isfinite(c.rotational_stiffness));
  EXPECT_EQ(c.rotational_stiffness > 0, c.output_degrees_of_freedom == 6);
  EXPECT_TRUE(c.position_resolution >= 0 && c.position_resolution < 1e-3) << "m";
  EXPECT_TRUE((c.workspace_low.array() <= c.workspace_high.array()).all());
  EXPECT_LT((c.workspace_high - c.workspace_low).norm(), 2) << "m, not mm";
  EXPECT_GE(c.rate, 100) << "Hz";
}

TEST_P(DeviceContract, IsQuietBeforeItsFirstRun) {
  const auto device = tested.open();
  EXPECT_FALSE(device->is_running());
  EXPECT_EQ(device->arming(), ArmingState::off);
  EXPECT_FALSE(device->state().valid) << "there was no reading";
  EXPECT_EQ(device->state().sequence, 0U);
  EXPECT_TRUE(is_finite(device->state().X_BS));
  EXPECT_TRUE(device->output().applied.force.isZero(0) && device->output().commanded.force.isZero(0));
  EXPECT_TRUE(device->drain_log().empty());
  for (std::size_t n = 0; n < kSafetyEvents; ++n) EXPECT_EQ(device->count(SafetyEvent(n)), 0U) << n;
  EXPECT_EQ(tested.commands(), 0);
}

// --- opened, closed, opened again -----------------------------------------------------------------------------------
TEST_P(DeviceContract, IsFoundByItsName) {
  const std::string name = traits().name;
  if (!name.empty()) {
    EXPECT_EQ(open_device(name)->name(), name);
    EXPECT_EQ(open_device(name)->name(), name) << "it was closed";
  }
  const std::string words = refusal([&] { (void)open_device("no such device as " + name); });
  for (const DeviceDriver& driver : device_drivers()) EXPECT_TRUE(contains(words, driver.usage)) << words;
}

TEST_P(DeviceContract, IsOpenedAndClosedAgainAndAgainWhetherItRanOrNot) {
  for (int n = 0; n < 4; ++n) {
    auto device = tested.open();
    const std::string model = device->capabilities().model;
    if (n % 2 == 1) (void)rest(*device);
    EXPECT_EQ(device->capabilities().model, model) << "the model does not change";
    device.reset();
    device.reset();  // closed twice
    expect_no_force_now();
    tested.expect_left_in_order();
  }
}

TEST_P(MakersDeviceContract, IsRefusedToASecondOwnerAndStaysWithTheFirst) {
  auto first = tested.open();
  const std::string words = refusal([&] { (void)tested.open(); });
  EXPECT_TRUE(contains(words, "check") || contains(words, "close")) << words;
  EXPECT_TRUE(rest(*first).valid);
  tested.run(*first, [&, n = 0](const DeviceState& state) mutable {
    if (n++ == 0) (void)refusal([&] { (void)tested.open(); });
    EXPECT_TRUE(state.valid);
    return DeviceCommand{{}, n >= 20};
  });
  first.reset();
  EXPECT_TRUE(rest(*tested.open()).valid) << "free again";
}

TEST_P(SimulatedDeviceContract, IsThereAsOftenAsItIsOpened) {
  const auto first = tested.open(), second = tested.open();
  EXPECT_EQ(rest(*first).sequence, 20U);
  EXPECT_EQ(rest(*second).sequence, 20U);
  EXPECT_EQ(rest(*first).sequence, 20U);
}

// --- the loop -------------------------------------------------------------------------------------------------------
TEST_P(DeviceContract, CallsTheFunctionOnceATickInOneThreadAndNeverTwiceAtOnce) {
  const auto device = tested.open();
  std::atomic<int> inside{0}, calls{0};
  std::thread::id loop;
  const RunReport report = tested.run(*device, [&](const DeviceState&) {
    EXPECT_EQ(++inside, 1);
    if (calls++ == 0) loop = std::this_thread::get_id();
    EXPECT_EQ(std::this_thread::get_id(), loop);
    EXPECT_TRUE(device->is_running());
    std::this_thread::yield();
    --inside;
    return DeviceCommand{{}, calls >= 300};
  });
  EXPECT_FALSE(device->is_running());
  EXPECT_EQ(device->arming(), ArmingState::off);
  EXPECT_EQ(report.ticks, 300U);
  EXPECT_EQ(calls, 300);
  EXPECT_EQ(report.compute.count(), 300U);
  EXPECT_EQ(report.missed, 0U);
  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_EQ(report.arming, ArmingState::on);
  EXPECT_EQ(report.end, "the callback ended it");
}

TEST_P(DeviceContract, RunsForTheGivenSecondsOfItsOwnTime) {
  const auto device = tested.open();
  RunOptions options = quick();
  options.seconds = 0.2495;
  EXPECT_EQ(tested
                .run(
                    *device, [](const DeviceState&) { return DeviceCommand{}; }, options)
                .ticks,
            251U);
}

TEST_P(DeviceContract, ShowsTheLoopItsReadingAndItsLastOutputWithoutALock) {
  const auto device = tested.open();
  Wrench last;
  tested.run(*device, [&, n = 0](const DeviceState& state) mutable {
    EXPECT_EQ(&device->last_state(), &state);
    EXPECT_EQ(device->last_output().commanded.force, last.force) << n;
    EXPECT_NE(device->last_arming(), n < 20 ? ArmingState::on : ArmingState::wait_free) << n;
    EXPECT_EQ(device->last_arming(), n < 45 ? device->last_arming() : ArmingState::on) << n;
    last.force = Vec3(1e-4 * ++n, 0, 0);
    return DeviceCommand{last, n >= 60};
  });
}

TEST_P(DeviceContract, IsSeenAndStoppedFromOtherThreads) {
  const auto device = tested.open();
  std::atomic<bool> seen{false}, over{false};
  std::atomic<long> looks{0};
  std::thread observer([&] {
    for (; !seen && !over; ++looks) {
      const DeviceState state = device->state();
      const DeviceOutput output = device->output();
      (void)device->drain_log();
      const bool pushed = output.applied.force.norm() > 0.01 || !traits().has_motors;
      if (!pushed || state.sequence == 0 || device->arming() != ArmingState::on) continue;
      EXPECT_TRUE(device->is_running());
      EXPECT_EQ(device->count(SafetyEvent::engaged), 1U);
      device->stop();
      device->stop();
      seen = true;
    }
  });
  const RunReport report = tested.run(*device, [&](const DeviceState&) {
    for (const long before = looks; looks == before && !seen;) std::this_thread::yield();
    return DeviceCommand{{Vec3(0.1, 0, 0), Vec3::Zero()}, false};
  });
  over = true;
  observer.join();
  EXPECT_TRUE(seen);
  EXPECT_EQ(report.end, "stopped");
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::engaged)], 1U);
}

TEST_P(DeviceContract, ObeysAStopAtTheStartOfARunAndIgnoresAnEarlierOne) {
  const auto device = tested.open();
  device->stop();
  (void)rest(*device);
  for (int n = 0; n < 20; ++n) {
    std::atomic<bool> ready{false}, stopped{false};
    std::thread stopper([&] {
      ready = true;
      while (!device->is_running()) {
      }
      device->stop();
      stopped = true;
    });
    while (!ready) std::this_thread::yield();
    const RunReport report = tested.run(*device, [&](const DeviceState& state) {
      while (!stopped) std::this_thread::yield();
      return DeviceCommand{{}, state.sequence >= 100};
    });
    stopper.join();
    EXPECT_LE(report.ticks, 1U) << "the stop was forgotten";
    EXPECT_EQ(report.end, "stopped");
  }
}

TEST_P(DeviceContract, IsRunInAnyThreadAndAgain) {
  const auto device = tested.open();
  for (int n = 0; n < 3; ++n) {
    std::thread other([&] {
      const DeviceState last = rest(*device, 60);
      EXPECT_EQ(last.sequence, 60U) << "every run starts at the first tick";
      EXPECT_NEAR(last.time, 0.059, 1e-9);
    });
    other.join();
    device->stop();  // the next run must ignore this stop
    tested.run(*device, [&](const DeviceState& state) {
      if (state.sequence == 30) device->stop();
      return DeviceCommand{};
    });
    EXPECT_EQ(device->state().sequence, 30U);
  }
}

TEST_P(DeviceContract, RunsByTheWallClockInTheDocumentedThread) {
  const auto device = tested.open_for_wall_clock();
  RunOptions options = quick();
  options.realtime = {0, false, true, -1, 0};
  DeviceState last;
  std::thread::id loop;
  const RunReport report = device->run(
      [&, n = 0](const DeviceState& state) mutable {
        loop = std::this_thread::get_id();
        EXPECT_GE(state.time, last.time);
        EXPECT_EQ(state.sequence, std::uint64_t(n) + 1);
        last = state;
        return DeviceCommand{{}, ++n >= 200};
      },
      options);
  EXPECT_EQ(loop == std::this_thread::get_id(), !traits().own_thread);
  EXPECT_EQ(report.ticks, 200U);
  EXPECT_GE(report.wake_up.count(), 200U);
}

// --- invalid use -----------------------------------------------------------------------------------------------------
TEST_P(DeviceContract, RefusesInvalidRunsWithAMessageAndRunsAfterwards) {
  const auto device = tested.open();
  const DeviceCallback rests = [](const DeviceState&) { return DeviceCommand{{}, true}; };
  EXPECT_TRUE(contains(refusal([&] { device->run(nullptr); }), "pass a function"));
  const struct {
    const char* words;
    std::function<void(RunOptions&)> spoil;
  } wrong[] = {{"RunOptions::seconds [s] = -1; must be", [](RunOptions& o) { o.seconds = -1; }},
               {"RunOptions::seconds [s] = nan; must be", [](RunOptions& o) { o.seconds = std::nan(""); }},
               {"GuardOptions::period [s] = 0; must be", [](RunOptions& o) { o.guard.period = 0; }},
               {"ArmingOptions::ramp [s] = 0; must be", [](RunOptions& o) { o.guard.arming.ramp = 0; }},
               {"PoseGateOptions::hold [s] = 0; must be", [](RunOptions& o) { o.guard.gate.hold = 0; }},
               {"GuardOptions::late [s] = 2; must be", [](RunOptions& o) { o.guard.late = 2; }}};
  for (const auto& one : wrong) {
    RunOptions options = quick();
    one.spoil(options);
    const std::string words = refusal([&] { tested.run(*device, rests, options); });
    EXPECT_TRUE(contains(words, one.words)) << words;
    EXPECT_FALSE(device->is_running());
    EXPECT_EQ(device->arming(), ArmingState::off);
    tested.expect_left_in_order();
  }
  expect_no_force_since(0);
  (void)rest(*device);
}

TEST_P(DeviceContract, RefusesToRunTwiceAtOnce) {
  const auto device = tested.open();
  const RunReport report = tested.run(*device, [&, n = 0](const DeviceState&) mutable {
    if (++n == 10) {
      const std::string words = refusal([&] { device->run([](const DeviceState&) { return DeviceCommand{}; }); });
      EXPECT_TRUE(contains(words, "\"" + device->name() + "\" runs already; stop it")) << words;
    }
    EXPECT_TRUE(device->is_running());
    return DeviceCommand{{}, n >= 20};
  });
  EXPECT_EQ(report.ticks, 20U) << "the first run continues";
}

TEST_P(MakersDeviceContract, RefusesSimulatedTimeIfUnsupportedAndRunsAfterwards) {
  const auto device = tested.open_for_wall_clock();
  RunOptions options = quick();
  options.realtime = {0, false, true, -1, 0};
  options.simulated_time = true;
  const DeviceCallback rests = [](const DeviceState&) { return DeviceCommand{{}, true}; };
  const std::string words = refusal([&] { device->run(rests, options); });
  EXPECT_TRUE(contains(words, "simulated time; do not set RunOptions::simulated_time")) << words;
  EXPECT_FALSE(device->is_running());
  EXPECT_EQ(device->arming(), ArmingState::off) << "without a run the guard is off";
  EXPECT_EQ(tested.commands(), 0);
  options.simulated_time = false;
  EXPECT_EQ(device->run(rests, options).ticks, 1U);
}

INSTANTIATE_TEST_SUITE_P(Devices, DeviceContract, testing::ValuesIn(devices_under_test()), kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, MakersDeviceContract, testing::ValuesIn(devices_that({&DeviceTraits::is_makers})),
                         kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, SimulatedDeviceContract,
                         testing::ValuesIn(devices_that({&DeviceTraits::is_makers}, false)), kNameOfDevice);

}  // namespace
}  // namespace hapticut::device_contract_test
