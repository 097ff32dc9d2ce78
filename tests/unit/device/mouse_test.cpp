// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/mouse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"

namespace hapticut::mouse_test {
namespace {

RunOptions simulated() {
  RunOptions options;
  options.simulated_time = true;
  options.stop_on_signals = false;
  return options;
}

/// The state of the hand after some ticks, when `act` was called in the first tick.
template <typename Act>
DeviceState after(MouseDevice& mouse, const Act& act, long ticks = 2000) {
  DeviceState last;
  mouse.run(
      [&, n = 0L](const DeviceState& state) mutable {
        if (n == 0) act();
        last = state;
        return DeviceCommand{{}, ++n >= ticks};
      },
      simulated());
  return last;
}

constexpr double kSettled = 1e-6;  // [m] remaining distance of a firm hand after 2 s

TEST(MouseDevice, FollowsPointerAndWheel) {
  MouseDevice mouse;
  const DeviceState state = after(mouse, [&] {
    mouse.pointer_moved(200, 100);  // right, and down in window coordinates
    mouse.wheel_turned(3);
    mouse.button(1, true);
  });
  EXPECT_LT((state.X_BS.translation - Vec3(10e-3, -5e-3, -1.5e-3)).norm(), kSettled);
  EXPECT_TRUE(state.pressed(1));
  EXPECT_FALSE(state.pressed(0));
}

TEST(MouseDevice, MovesAndTurnsWhileAKeyIsHeld) {
  MouseDevice mouse;
  const DeviceState state = after(mouse, [&] {
    mouse.key(MoveKey::nearer, true);
    mouse.key(MoveKey::turn_left, true);
  });
  // The set point moves at 20 mm/s for 2 s; the hand lags by damping over stiffness.
  EXPECT_NEAR(state.X_BS.translation.z(), 0.040, 1e-3);
  EXPECT_NEAR(state.velocity.linear.z(), 0.02, 1e-4);
  EXPECT_NEAR(vector_from_rotation(state.X_BS.rotation).z(), 2, 0.01);
  mouse.key(MoveKey::nearer, false);
}

TEST(MouseDevice, NeverJumpsAndStaysWithinReach) {
  MouseDevice mouse;
  Vec3 last = Vec3::Zero();
  double max_speed = 0;
  const RunReport report = mouse.run(
      [&, n = 0](const DeviceState& state) mutable {
        if (n == 0) mouse.pointer_moved(1e9, std::nan(""));
        max_speed = std::max(max_speed, (state.X_BS.translation - last).norm() / 1e-3);
        last = state.X_BS.translation;
        return DeviceCommand{{}, ++n >= 3000};
      },
      simulated());
  EXPECT_LT(max_speed, 0.5);
  EXPECT_NEAR(last.x(), 0.08, kSettled);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::pose_jump)], 0U);
}

TEST(MouseDevice, IsPushedBackByTheForce) {
  MouseDevice mouse;
  DeviceState last;
  mouse.run(
      [&, n = 0](const DeviceState& state) mutable {
        if (n == 2000) mouse.wheel_turned(20);  // 10 mm away, into a wall at the origin
        last = state;
        DeviceCommand command;
        command.wrench.force.z() = std::max(0.0, -400 * state.X_BS.translation.z());
        command.stop = ++n >= 5000;
        return command;
      },
      simulated());
  // Balance of a hand of 800 N/m and a wall of 400 N/m.
  EXPECT_NEAR(last.X_BS.translation.z(), -10e-3 * 800 / 1200, 1e-4);
  EXPECT_NEAR(mouse.set_point().z(), -10e-3, 1e-9);
}

TEST(MouseDevice, ForgetsWhatMovedBeforeTheRunButNotWhatIsHeld) {
  MouseDevice mouse;
  mouse.pointer_moved(200, 100);
  mouse.wheel_turned(3);
  mouse.button(1, true);
  const DeviceState state = after(
      mouse, [] {}, 500);
  EXPECT_EQ(state.X_BS.translation, Vec3::Zero()) << "relative to the point where the run began";
  EXPECT_TRUE(state.pressed(1));
}

TEST(MouseDevice, HasNoTorqueForAnyDeviceModel) {
  MouseOptions options;
  options.device = "premium6dof";
  const DeviceCapabilities c = MouseDevice(options).capabilities();
  EXPECT_EQ(c.output_degrees_of_freedom, 3);
  EXPECT_EQ(c.peak_torque, 0);
  EXPECT_EQ(c.peak_force, 8.5);
}

TEST(MouseDevice, IsOpenedByNameAndPromisesNoRate) {
  const auto mouse = open_device("mouse");
  EXPECT_FALSE(mouse->capabilities().hard_realtime);
  EXPECT_THROW((void)open_device("mouse:left"), Error);
}

}  // namespace
}  // namespace hapticut::mouse_test
