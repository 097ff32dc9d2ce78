// SPDX-License-Identifier: Apache-2.0
// The motor by itself: ramps, power limit and droop, in both directions.
#include "hapticut/tool/spindle.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"

namespace hapticut::spindle_test {
namespace {

class SpindleDirection : public testing::TestWithParam<double> {};

// Proves: ramp.
TEST_P(SpindleDirection, ReachesASettingOnARampOfTheAccelerationLimitWhateverTheStep) {
  const double sign = GetParam();
  for (const double dt : {1e-3, 2.5e-4}) {
    SpindleMotor motor({0, std::numeric_limits<double>::infinity(), 1e4});
    motor.set(sign * 1000);
    double time = 0;
    while (motor.speed() != sign * 1000) {
      const double before = motor.speed();
      motor.advance(0, dt);
      time += dt;
      ASSERT_LE(std::abs(motor.speed() - before), 1e4 * dt * (1 + 1e-12));
      ASSERT_LT(time, 1);
    }
    EXPECT_NEAR(time, 0.1, 1.5 * dt);
  }
}

// Proves: ramp.
TEST_P(SpindleDirection, TurnsTheOtherWayThroughZero) {
  const double sign = GetParam();
  SpindleMotor motor({sign * 500, std::numeric_limits<double>::infinity(), 1e4});
  motor.set(-sign * 500);
  double time = 0, before = sign * motor.speed();
  while (motor.speed() != -sign * 500) {
    motor.advance(0, 1e-3);
    time += 1e-3;
    ASSERT_LT(sign * motor.speed(), before);
    before = sign * motor.speed();
    ASSERT_LT(time, 1);
  }
  EXPECT_NEAR(time, 0.1, 1.5e-3);
}

// Proves: droop.
TEST_P(SpindleDirection, DroopsInProportionToItsLoadAndRecovers) {
  const double sign = GetParam();
  Spindle spindle{sign * 1000};
  spindle.droop = 2e4;
  SpindleMotor motor(spindle);
  motor.advance(sign * 0.01, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 800, 1e-9);
  EXPECT_TRUE(motor.loaded());
  motor.advance(sign * 1, 1e-3);
  EXPECT_EQ(motor.speed(), 0) << "stalled, not turning backwards";
  motor.advance(-sign * 0.01, 1e-3);
  EXPECT_EQ(motor.speed(), sign * 1000) << "a torque that drives the spindle is no load";
  EXPECT_FALSE(motor.loaded());
}

// Proves: power limit.
TEST_P(SpindleDirection, HoldsItsPowerLimit) {
  const double sign = GetParam();
  SpindleMotor motor({sign * 1000, 5});
  motor.advance(sign * 0.01, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 500, 1e-9);
  motor.advance(sign * 0.001, 1e-3);
  EXPECT_EQ(motor.speed(), sign * 1000);
}

TEST_P(SpindleDirection, SlowsDownAtOnceButRecoversOnItsRamp) {
  const double sign = GetParam();
  SpindleMotor motor({sign * 1000, 5, 1e4});
  motor.advance(sign * 0.01, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 500, 1e-9);
  motor.advance(0, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 510, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(BothWays, SpindleDirection, testing::Values(1.0, -1.0));

TEST(SpindleMotor, WithoutAnAccelerationLimitReachesASettingAtOnce) {
  SpindleMotor motor({});
  motor.set(-300);
  EXPECT_EQ(motor.speed(), -300);
}

TEST(SpindleInput, IsRefusedWithItsValueAndTheCure) {
  const auto message = [](const Spindle& spindle) -> std::string {
    try {
      validate(spindle);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  Spindle spindle;
  EXPECT_EQ(message(spindle), "");
  spindle.acceleration_limit = 0;
  EXPECT_EQ(message(spindle).find("Spindle::acceleration_limit [rad/s^2] = 0; must be > 0"), 0U);
  spindle = {};
  spindle.droop = -1;
  EXPECT_EQ(message(spindle).find("Spindle::droop [rad/(s N m)] = -1"), 0U);
  spindle = {};
  spindle.power_limit = -1;
  EXPECT_EQ(message(spindle).find("Spindle::power_limit [W] = -1"), 0U);
}

}  // namespace
}  // namespace hapticut::spindle_test
