// SPDX-License-Identifier: Apache-2.0
// The device of the pointer in a page.
#include "page/session/pointer_hand.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/units.hpp"

namespace hapticut::pointer_hand_test {
namespace {

using units::mm;

const Box kAround{Vec3(-50, -50, -50) * mm, Vec3(50, 50, 50) * mm};

/// The readings of the loop, tick by tick, without pressing.
std::vector<DeviceState> read(apps::PointerHand& hand, int ticks) {
  std::vector<DeviceState> states;
  RunOptions options;
  options.simulated_time = true;
  options.stop_on_signals = false;
  (void)hand.run(
      [&](const DeviceState& state) {
        states.push_back(state);
        DeviceCommand command;
        command.stop = int(states.size()) >= ticks;
        return command;
      },
      options);
  return states;
}

TEST(PointerHand, ComesToWhereThePointerIsNoFasterThanAHandThatWorks) {
  constexpr double kMaxSpeed = 0.2, kAngle = 0.5;  // [m/s], [rad]
  apps::PointerHand hand(kAround);
  hand.put({});
  const Pose wanted{rotation_from_vector({0, kAngle, 0}), Vec3(20, -10, 5) * mm};
  hand.move_to(wanted, true);
  const std::vector<DeviceState> states = read(hand, 500);
  for (std::size_t n = 1; n < states.size(); ++n) {
    ASSERT_TRUE(states[n].pressed(apps::PointerHand::kPress));
    const double moved = (states[n].X_BS.translation - states[n - 1].X_BS.translation).norm();
    ASSERT_LE(moved, kMaxSpeed * 1e-3 * (1 + 1e-9));
    ASSERT_LE(states[n].velocity.linear.norm(), kMaxSpeed * (1 + 1e-9));
    ASSERT_NEAR(states[n].time - states[n - 1].time, 1e-3, 1e-12);
    ASSERT_EQ(states[n].sequence, states[n - 1].sequence + 1);
  }
  EXPECT_GT(states.size(), 20 * mm / (kMaxSpeed * 1e-3));
  EXPECT_LT((states.back().X_BS.translation - wanted.translation).norm(), 1e-6);
  EXPECT_LT((states.back().X_BS.rotation - wanted.rotation).norm(), 1e-6);
  EXPECT_LT(states.back().velocity.linear.norm(), 1e-4);
}

TEST(PointerHand, StaysAroundTheWorkpiece) {
  apps::PointerHand hand(kAround);
  hand.put({});
  hand.move_to(Pose::from_translation(Vec3(500, 0, 10) * mm), false);
  const Vec3 end = read(hand, 800).back().X_BS.translation;
  EXPECT_LT((end - Vec3(50, 0, 10) * mm).norm(), 1e-6);
}

TEST(PointerHand, BeginsWhereItIsPut) {
  apps::PointerHand hand(kAround);
  hand.move_to(Pose::from_translation(Vec3(9, 9, 9) * mm), true);
  hand.put(Pose::from_translation(Vec3(1, 2, 3) * mm));
  for (const DeviceState& state : read(hand, 20)) {
    EXPECT_LT((state.X_BS.translation - Vec3(1, 2, 3) * mm).norm(), 1e-12);
    EXPECT_FALSE(state.pressed(apps::PointerHand::kPress));
  }
}

}  // namespace
}  // namespace hapticut::pointer_hand_test
