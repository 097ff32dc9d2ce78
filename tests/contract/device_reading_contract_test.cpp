// SPDX-License-Identifier: Apache-2.0
// Contract of the readings of every device, on which the loop relies.
#include <gtest/gtest.h>

#include <cmath>

#include "support/devices_under_test.hpp"

namespace hapticut::device_reading_contract_test {
namespace {

using namespace test;

class ReadingContract : public DeviceContractTest {
 protected:
  /// A hand that moves in a circle of 5 mm and rotates the stylus, without jumps.
  static ScriptedTick round_and_round(long tick) {
    const double angle = 2e-3 * double(tick);
    return {Pose{rotation_from_vector(Vec3(0.1, 0.3, std::sin(angle))),
                 5e-3 * Vec3(std::cos(angle), std::sin(angle), 0.5 * std::sin(angle))},
            {10e-3 * Vec3(-std::sin(angle), std::cos(angle), 0.5 * std::cos(angle)), Vec3::Zero()}};
  }
};

/// Devices whose readings follow the script.
class FollowingDeviceContract : public ReadingContract {};
class ButtonContract : public ReadingContract {};
class MakersReadingContract : public ReadingContract {};

TEST_P(ReadingContract, GivesReadingsOfARigidBodyInMetresEachLaterThanTheLast) {
  tested.script = round_and_round;
  const auto device = tested.open();
  const DeviceCapabilities& c = device->capabilities();
  for (int run = 0; run < 2; ++run) {
    DeviceState last;
    tested.run(*device, [&, n = 0](const DeviceState& state) mutable {
      EXPECT_TRUE(state.valid);
      EXPECT_EQ(state.fault, DeviceFault::none);
      EXPECT_TRUE(is_finite(state.X_BS) && is_finite(state.velocity.linear) && is_finite(state.velocity.angular));
      EXPECT_TRUE(is_rotation(state.X_BS.rotation, 1e-12));
      EXPECT_LT(state.X_BS.translation.norm(), 1) << "m, not mm";
      EXPECT_LT(state.velocity.linear.norm(), 2) << "m/s, not mm/s";
      EXPECT_LT(state.velocity.angular.norm(), 30) << "rad/s";
      const bool bounded = (c.workspace_high - c.workspace_low).minCoeff() > 0;
      EXPECT_TRUE(!bounded || ((state.X_BS.translation - c.workspace_low).minCoeff() >= 0 &&
                               (c.workspace_high - state.X_BS.translation).minCoeff() >= 0));
      EXPECT_TRUE(state.temperature >= 0 && state.temperature <= 1);
      EXPECT_EQ(state.sequence, n == 0 ? 1 : last.sequence + 1);
      EXPECT_NEAR(state.time, n == 0 ? 0 : last.time + 1e-3, 1e-9) << "since the run began";
      EXPECT_EQ(state.epoch, n == 0 ? state.epoch : last.epoch);
      last = state;
      return DeviceCommand{{}, ++n >= 3000};
    });
    EXPECT_EQ(last.sequence, 3000U);
    EXPECT_EQ(device->state().sequence, 3000U) << "the last reading is available after the run";
    EXPECT_EQ(device->state().X_BS.translation, last.X_BS.translation);
  }
}

TEST_P(FollowingDeviceContract, IsWhereTheHandIs) {
  tested.script = round_and_round;
  const auto device = tested.open();
  const bool has_rotation = device->capabilities().input_degrees_of_freedom == 6;
  tested.run(*device, [&, n = 0L](const DeviceState& state) mutable {
    const Pose X_BS = round_and_round(n).X_BS;
    EXPECT_LT((state.X_BS.translation - X_BS.translation).norm(), 1e-12) << n;
    EXPECT_LT((state.X_BS.rotation - (has_rotation ? X_BS.rotation : Mat3::Identity())).norm(), 1e-12) << n;
    return DeviceCommand{{}, ++n >= 500};
  });
}

TEST_P(FollowingDeviceContract, MeasuresLinearAndAngularVelocity) {
  const Twist velocity{Vec3(0.02, -0.01, 0.03), Vec3(0.5, -1, 2)};
  tested.script = [=](long tick) {
    const double time = 1e-3 * double(tick);
    return ScriptedTick{Pose{rotation_from_vector(time * velocity.angular), time * velocity.linear}, velocity};
  };
  const auto device = tested.open();
  const bool has_rotation = device->capabilities().input_degrees_of_freedom == 6;
  const DeviceState last = rest(*device, 300);
  EXPECT_LT((last.velocity.linear - velocity.linear).norm(), 1e-6);
  EXPECT_LT((last.velocity.angular - (has_rotation ? velocity.angular : Vec3::Zero())).norm(), 1e-6);
}

TEST_P(MakersReadingContract, MakesAnInexactRotationExact) {
  Mat3 inexact = rotation_from_vector(Vec3(0.2, 0.1, -0.4));
  inexact.col(0) *= 1.003;
  inexact.col(1) += 0.002 * inexact.col(2);
  tested.script = [=](long) { return ScriptedTick{Pose{inexact, Vec3::Zero()}}; };
  const auto device = tested.open();
  const bool has_rotation = device->capabilities().input_degrees_of_freedom == 6;
  const DeviceState last = rest(*device);
  EXPECT_TRUE(last.valid);
  EXPECT_TRUE(is_rotation(last.X_BS.rotation, 1e-12));
  EXPECT_LT((last.X_BS.rotation - (has_rotation ? inexact : Mat3::Identity())).norm(), 0.01);
}

TEST_P(ButtonContract, TellsWhichButtonsArePressed) {
  tested.script = [](long tick) { return ScriptedTick{{}, {}, std::uint32_t(tick / 10 % 8)}; };
  const auto device = tested.open();
  tested.run(*device, [&, n = 0](const DeviceState& state) mutable {
    EXPECT_EQ(state.pressed(0), n / 10 % 2 == 1) << n;
    EXPECT_EQ(state.pressed(1), n / 20 % 2 == 1) << n;
    EXPECT_EQ(state.pressed(2), n / 40 % 2 == 1) << n;
    EXPECT_FALSE(state.pressed(3));
    return DeviceCommand{{}, ++n >= 160};
  });
}

TEST_P(FollowingDeviceContract, HoldsTheLastGoodPoseThroughReadingsThatAreNotFinite) {
  tested.script = [](long tick) {
    ScriptedTick now = round_and_round(tick);
    now.not_a_number = tick >= 100 && tick < 105;
    return now;
  };
  const auto device = tested.open();
  const RunReport report = tested.run(*device, [&, n = 0L](const DeviceState& state) mutable {
    EXPECT_TRUE(state.valid && is_finite(state.X_BS) && is_finite(state.velocity.linear)) << n;
    if (n < 100 || n >= 120) {
      EXPECT_LT((state.X_BS.translation - round_and_round(n).X_BS.translation).norm(), 1e-12) << n;
    } else if (n < 105) {
      EXPECT_LT((state.X_BS.translation - round_and_round(99).X_BS.translation).norm(), 1e-12) << n;
      EXPECT_TRUE(state.velocity.linear.isZero(0)) << n;
    }
    return DeviceCommand{{}, ++n >= 300};
  });
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::pose_not_finite)], 5U);
  EXPECT_EQ(report.arming, ArmingState::on);
}

INSTANTIATE_TEST_SUITE_P(Devices, ReadingContract, testing::ValuesIn(devices_under_test()), kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, FollowingDeviceContract, testing::ValuesIn(devices_that({&DeviceTraits::follows})),
                         kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, ButtonContract, testing::ValuesIn(devices_that({&DeviceTraits::has_buttons})),
                         kNameOfDevice);
INSTANTIATE_TEST_SUITE_P(Devices, MakersReadingContract, testing::ValuesIn(devices_that({&DeviceTraits::is_makers})),
                         kNameOfDevice);

}  // namespace
}  // namespace hapticut::device_reading_contract_test
