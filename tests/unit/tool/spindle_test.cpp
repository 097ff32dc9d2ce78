// SPDX-License-Identifier: Apache-2.0
// The motor alone: ramps, power limit and droop, in both directions.
#include "hapticut/tool/spindle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hapticut/loop/commands.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/tool/motors.hpp"
#include "support/refusal.hpp"

namespace hapticut::spindle_test {
namespace {

class SpindleDirection : public testing::TestWithParam<double> {
 protected:
  const double sign = GetParam();
};

// Proves: ramp.
TEST_P(SpindleDirection, ReachesASettingOnARampOfTheAccelerationLimitForAnyStep) {
  for (const double dt : {1e-3, 2.5e-4}) {
    SpindleMotor motor(Spindle{0, std::numeric_limits<double>::infinity(), 1e4});
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
TEST_P(SpindleDirection, ReversesThroughZero) {
  SpindleMotor motor(Spindle{sign * 500 * units::rad_per_s, std::numeric_limits<double>::infinity(), 1e4});
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
  SpindleMotor motor({.speed = sign * 1000 * units::rad_per_s, .droop = 2e4});
  motor.advance(sign * 0.01, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 800, 1e-9);
  EXPECT_FALSE(motor.loaded()) << "more power is available";
  motor.advance(sign * 0.03, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 400, 1e-9);
  EXPECT_TRUE(motor.loaded()) << "beyond the maximum, more load lowers the power";
  motor.advance(sign * 1, 1e-3);
  EXPECT_EQ(motor.speed(), 0) << "stalled, not reversed";
  EXPECT_TRUE(motor.stalled());
  motor.advance(-sign * 0.01, 1e-3);
  EXPECT_EQ(motor.speed(), sign * 1000) << "a torque that drives the spindle does not count as load";
  EXPECT_FALSE(motor.loaded());
  EXPECT_FALSE(motor.stalled());
}

// Proves: power limit.
TEST_P(SpindleDirection, HoldsItsPowerLimit) {
  SpindleMotor motor(Spindle{sign * 1000 * units::rad_per_s, 5});
  motor.advance(sign * 0.01, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 500, 1e-9);
  motor.advance(sign * 0.001, 1e-3);
  EXPECT_EQ(motor.speed(), sign * 1000);
}

TEST_P(SpindleDirection, SlowsDownAtOnceButRecoversOnItsRamp) {
  SpindleMotor motor(Spindle{sign * 1000 * units::rad_per_s, 5, 1e4});
  motor.advance(sign * 0.01, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 500, 1e-9);
  motor.advance(0, 1e-3);
  EXPECT_NEAR(motor.speed(), sign * 510, 1e-9);
}

constexpr double kStall = 2 * units::N_mm, kFree = 3e4;  // [rad/s]

Spindle turbine(double sign, double inertia) {
  return {.speed = sign * kFree * units::rad_per_s, .droop = kFree / kStall, .rotor_inertia = inertia};
}

// A load rises to 1.5 times the stall torque and falls back. The motor does not alternate between running and stalling,
// and its torque never exceeds its line of torque over speed.
// Proves: droop.
TEST_P(SpindleDirection, StallsAtItsStallTorqueAndRunsAgainBelowIt) {
  for (const double inertia : {0.0, 1e-9})
    for (const double dt : {1e-3, 2.5e-4}) {
      SpindleMotor motor(turbine(sign, inertia));
      EXPECT_NEAR(motor.stall_torque(), kStall, 1e-15);
      const double rise = 2;  // [s] slow compared to a run-up of 15 ms
      double stalled_at = 0, ran_at = 0, before = motor.speed();
      int reversals = 0;
      for (double time = 0; time < 2 * rise; time += dt) {
        const double load = 1.5 * kStall * (time < rise ? time : 2 * rise - time) / rise;
        motor.drive(sign * load, dt);
        motor.advance(sign * load, dt);
        if (stalled_at == 0 && motor.stalled()) stalled_at = load;
        if (stalled_at > 0 && ran_at == 0 && !motor.stalled()) ran_at = load;
        const bool falls = sign * (motor.speed() - before) < 0;
        reversals += (falls && time >= rise) || (sign * (motor.speed() - before) > 1e-9 * kFree && time < rise);
        before = motor.speed();
        const double line = kStall * (1 - sign * motor.speed() / kFree);
        if (inertia == 0 && !motor.stalled()) {
          ASSERT_LE(load, line * (1 + 1e-9));
        }
      }
      EXPECT_NEAR(stalled_at / kStall, 1, inertia > 0 ? 0.02 : 2e-3) << "the inertia delays the stall";
      EXPECT_NEAR(ran_at / kStall, 1, 2e-3);
      EXPECT_EQ(reversals, 0);
    }
}

// J domega/dt = M_stall (1 - omega/omega_f) - M: an exponential with the time constant J omega_f/M_stall.
// Proves: inertia.
TEST_P(SpindleDirection, RunsUpAndDownAccordingToItsInertia) {
  const double inertia = 1e-8, tau = inertia * kFree / kStall, load = 0.3 * kStall;
  double error[2];
  for (int i = 0; i < 2; ++i) {
    const double dt = i == 0 ? 1e-3 : 5e-4, duration = 0.1;
    SpindleMotor motor(turbine(sign, inertia));
    motor.halt();
    motor.set(sign * kFree);
    for (int n = 0; n < std::lround(duration / dt); ++n) motor.advance(sign * load, dt);
    error[i] = sign * motor.speed() / kFree - 0.7 * (1 - std::exp(-duration / tau));
    EXPECT_NEAR(error[i], 0, 2e-3);
  }
  EXPECT_NEAR(error[0] / error[1], 2, 0.05) << "first order in the step";
}

// Proves: torque limit.
TEST_P(SpindleDirection, KeepsItsSpeedUpToItsTorqueLimitAndStallsAboveIt) {
  for (const double inertia : {0.0, 1e-9}) {
    SpindleMotor motor({.speed = sign * 1000 * units::rad_per_s, .torque_limit = 0.02, .rotor_inertia = inertia});
    for (int n = 0; n < 10; ++n) motor.advance(sign * 0.0199, 1e-3);
    EXPECT_EQ(motor.speed(), sign * 1000);
    EXPECT_FALSE(motor.loaded());
    for (int n = 0; n < 10; ++n) motor.advance(sign * 0.0201, 1e-3);
    EXPECT_TRUE(motor.stalled());
    EXPECT_TRUE(motor.loaded());
    EXPECT_EQ(motor.speed(), 0);
    for (int n = 0; n < 10; ++n) motor.advance(sign * 0.0199, 1e-3);
    EXPECT_NEAR(motor.speed(), sign * 1000, 1e-9) << "it starts again";
  }
}

// Proves: inertia; power limit.
TEST_P(SpindleDirection, ARotorSettlesAtThePowerLimit) {
  constexpr double kInertia = 1e-5;  // settles in 0.5 s
  SpindleMotor motor({.speed = sign * 1000 * units::rad_per_s, .power_limit = 5, .rotor_inertia = kInertia});
  double before = 1000;
  for (int n = 0; n < 8000; ++n) {
    motor.advance(sign * 0.01, 1e-3);
    ASSERT_LE(sign * motor.speed(), before * (1 + 1e-12));
    before = sign * motor.speed();
  }
  EXPECT_NEAR(motor.speed(), sign * 500, 0.5);
  EXPECT_TRUE(motor.loaded());
}

// Proves: inertia.
TEST_P(SpindleDirection, AMotorWithInertiaReversesThroughZero) {
  constexpr double kInertia = 1e-6;  // 0.1 s from full speed to 0
  SpindleMotor motor({.speed = sign * 1000 * units::rad_per_s, .torque_limit = 0.01, .rotor_inertia = kInertia});
  motor.set(-sign * 1000);
  double before = sign * motor.speed(), time = 0;
  for (; motor.speed() != -sign * 1000; time += 1e-3) {
    motor.advance(0, 1e-3);
    ASSERT_LE(sign * motor.speed(), before);
    ASSERT_LE(before - sign * motor.speed(), 10 * (1 + 1e-9));
    before = sign * motor.speed();
    ASSERT_LT(time, 1);
  }
  EXPECT_NEAR(time, 0.2, 3e-3);
  motor.set(0);
  for (int n = 0; n < 101; ++n) motor.advance(0, 1e-3);
  EXPECT_EQ(motor.speed(), 0);
}

// Proves: motors.
TEST_P(SpindleDirection, OfCommonHandpiecesAreThoseOfTheirMotors) {
  const Spindle turbine = common_spindle(sign * 350e3 * units::rpm);
  EXPECT_NEAR(SpindleMotor(turbine).stall_torque(), 1.5 * units::N_mm, 1e-12);
  EXPECT_NEAR(turbine.speed, sign * 350e3 * units::rpm, 1e-6);
  const Spindle fast = common_spindle(sign * 200e3 * units::rpm), slow = common_spindle(sign * 2000 * units::rpm);
  EXPECT_NEAR(fast.torque_limit, 6 * units::N_mm, 1e-12);
  EXPECT_NEAR(slow.torque_limit, 600 * units::N_mm, 1e-9);
  EXPECT_EQ(fast.power_limit, 60);
  EXPECT_NEAR(fast.rotor_inertia, 2e-9, 1e-15);
  EXPECT_TRUE(common_spindle(MotorKind::surgical_drill, sign * 80e3 * units::rpm).is_limited());
  EXPECT_FALSE(common_spindle(MotorKind::ideal, sign * 80e3 * units::rpm).is_limited());
  EXPECT_FALSE(common_spindle(0).is_limited());
  EXPECT_THROW((void)common_spindle(MotorKind::electric, 0), Error);
  EXPECT_THROW((void)common_spindle(sign * 2e6 * units::rpm), Error);
}

template <class... Arguments>
concept MakesASpindle = requires(Arguments... arguments) {
  common_spindle(arguments...);
};
template <class... Arguments>
concept IsASpindle = requires(Arguments... arguments) {
  Spindle{arguments...};
};
template <class Argument>
concept IsASpeedToSet = requires(Simulation& simulation, Argument speed) {
  simulation.spindle().set_speed(speed);
  commands::SetSpindleSpeed{speed};
};

// 40000 rpm without a unit would be read as 40000 rad/s; forces were then nine times too large.
TEST_P(SpindleDirection, HasOneUnitEverywhereAndRpmAreRefusedAsRadiansPerSecond) {
  static_assert(MakesASpindle<AngularSpeed> && MakesASpindle<MotorKind, AngularSpeed>);
  static_assert(!MakesASpindle<int> && !MakesASpindle<MotorKind, int>);
  static_assert(!MakesASpindle<double> && !MakesASpindle<MotorKind, double>);
  static_assert(IsASpindle<AngularSpeed> && IsASpeedToSet<AngularSpeed>);
  static_assert(!IsASpindle<int> && !IsASpindle<double> && !IsASpindle<double, double>);
  static_assert(!IsASpeedToSet<int> && !IsASpeedToSet<double>);
  static_assert(-(40000 * units::rpm) == -40000 * units::rpm && 2 * units::rad_per_s == 2 && AngularSpeed{} == 0);
  const AngularSpeed speed = sign * 40000 * units::rpm;
  EXPECT_EQ(common_spindle(speed).speed, speed);
  EXPECT_EQ(common_motor(speed), MotorKind::electric);
  for (const MotorKind motor : {MotorKind::electric, MotorKind::surgical_drill, MotorKind::air_turbine}) {
    const double limit = max_speed(motor);
    EXPECT_EQ(std::abs(common_spindle(motor, sign * limit * units::rad_per_s).speed), limit);
    test::expect_refused([&] { (void)common_spindle(motor, sign * 1.01 * limit * units::rad_per_s); },
                         {"Write 40000 * units::rpm"});
  }
  EXPECT_THROW((void)common_spindle(MotorKind::electric, sign * 40000 * units::rad_per_s), Error);
  EXPECT_THROW((void)common_spindle(MotorKind::air_turbine, sign * 300000 * units::rad_per_s), Error);
}

INSTANTIATE_TEST_SUITE_P(BothWays, SpindleDirection, testing::Values(1.0, -1.0));

TEST(SpindleMotor, WithoutAnAccelerationLimitReachesASettingAtOnce) {
  SpindleMotor motor({});
  motor.set(-300);
  EXPECT_EQ(motor.speed(), -300);
}

TEST(SpindleInput, IsRefusedWithItsValueAndTheCure) {
  const auto expect = [](double Spindle::*member, double value, const char* begin) {
    Spindle spindle;
    spindle.*member = value;
    EXPECT_EQ(test::refusal([&] { validate(spindle); }).find(begin), 0U) << begin;
  };
  EXPECT_NO_THROW(validate(Spindle{}));
  expect(&Spindle::acceleration_limit, 0, "Spindle::acceleration_limit [rad/s^2] = 0; must be > 0");
  expect(&Spindle::droop, -1, "Spindle::droop [rad/(s N m)] = -1");
  expect(&Spindle::power_limit, -1, "Spindle::power_limit [W] = -1");
  test::expect_refused([] { validate(Spindle{400000 * units::rad_per_s}); },
                       {"Spindle::speed [rad/s] = 400000; that is 3.8", "Write 40000 * units::rpm"});
  EXPECT_THROW(validate(Spindle{std::nan("") * units::rad_per_s}), Error);
}

}  // namespace
}  // namespace hapticut::spindle_test
