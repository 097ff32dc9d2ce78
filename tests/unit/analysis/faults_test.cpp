// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/faults.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "hapticut/core/errors.hpp"
#include "support/refusal.hpp"

namespace hapticut::faults_test {
namespace {

ModelFactory wall(double damping) {
  return [=](double stiffness) {
    LinearWall w;
    w.stiffness = stiffness;
    w.damping = damping;
    w.filter = 100;
    return ForceModel(w);
  };
}

ClosedLoopConfig pressed(std::string_view device, int delay) {
  ClosedLoopConfig config;
  config.device = device_model(device);
  config.hand = hand_model("nominal-pad");
  config.delay = delay;
  config.dry_friction = config.encoder = config.saturation = true;
  config.velocity_filter = 100;
  return config;
}

TEST(Faults, NoFaultBreaksTheRulesOnAnyDeviceWithAnyDelay) {
  for (const DeviceModel& device : device_models())
    for (const int delay : {0, 1, 2})
      for (const InjectedFault fault : injected_faults()) {
        const SafetyGuard guard(capabilities(device), {});
        const FaultResponse response = measure_fault_response(pressed(device.name, delay), wall(1), 600, {}, fault);
        EXPECT_TRUE(obeys_the_rules(response, guard, 1e-3))
            << device.name << ", delay " << delay << ", " << name_of(fault) << ": " << response.max_force << " N, +"
            << response.max_growth << " N in a tick of " << guard.slew() * 1e-3 << ", force "
            << response.oldest_force * 1e3 << " ms old";
      }
}

TEST(Faults, ThatDoNotExistAreRefused) {
  const auto measured = [](InjectedFault fault, double height) {
    return measure_fault_response(pressed("touch", 0), wall(1), 600, {}, fault, height);
  };
  test::expect_refused([&] { return measured(InjectedFault(99), 0); }, "InjectedFault = 99; must be one of nan_pose,");
  test::expect_refused([&] { return measured(InjectedFault::nan_pose, HUGE_VAL); }, "the height [m] = inf");
  const SafetyGuard guard(capabilities(device_model("touch")), {});
  test::expect_refused([&] { return obeys_the_rules({}, guard, 0); }, "the period [s] = 0");
}

TEST(Faults, EveryFaultThatHidesTheHandEndsTheForce) {
  for (const InjectedFault fault : {InjectedFault::nan_pose, InjectedFault::frozen_pose, InjectedFault::stale_reading,
                                    InjectedFault::jump_30mm, InjectedFault::units_x1000, InjectedFault::nan_force,
                                    InjectedFault::unplugged, InjectedFault::emergency_stop}) {
    const FaultResponse response = measure_fault_response(pressed("touch", 0), wall(1), 600, {}, fault);
    EXPECT_GE(response.time_to_zero, 0) << name_of(fault);
    EXPECT_LE(response.time_to_zero, 0.05) << name_of(fault);
    EXPECT_EQ(response.end, ArmingState::fault) << name_of(fault);
    EXPECT_GT(response.max_force, fault == InjectedFault::emergency_stop || fault == InjectedFault::unplugged ||
                                          fault == InjectedFault::nan_force
                                      ? -1
                                      : 0.3)
        << name_of(fault) << ": the hand should have been pressing when it happened";
  }
}

TEST(Faults, NoFaultBreaksTheRulesAtAnyRate) {
  for (const double period : {4e-3, 2e-3, 0.5e-3, 0.25e-3})
    for (const InjectedFault fault : injected_faults()) {
      ClosedLoopConfig config = pressed("touch", 1);
      config.period = period;  // set only here
      GuardOptions options;
      const FaultResponse response = measure_fault_response(config, wall(1), 600, options, fault);
      options.period = period;
      const SafetyGuard guard(capabilities(config.device), options);
      EXPECT_TRUE(obeys_the_rules(response, guard, period))
          << period << " s, " << name_of(fault) << ": " << response.max_force << " N, +" << response.max_growth
          << " N in a tick of " << guard.slew() * period << ", force " << response.oldest_force << " s old";
    }
  ClosedLoopConfig config = pressed("touch", 0);
  config.period = 2e-3;
  GuardOptions options;
  options.period = 0.5e-3;
  EXPECT_THROW((void)measure_fault_response(config, wall(1), 600, options, InjectedFault::missed_1), Error);
}

TEST(Faults, InterruptionsThatLeaveTheToolInsideGiveNoForceUntilItIsOut) {
  for (const InjectedFault fault : {InjectedFault::buried_5mm, InjectedFault::reclutch, InjectedFault::calibration_jump,
                                    InjectedFault::missed_20, InjectedFault::missed_100}) {
    const FaultResponse response = measure_fault_response(pressed("touch", 0), wall(1), 600, {}, fault);
    EXPECT_GE(response.time_to_zero, 0) << name_of(fault);
    EXPECT_EQ(response.end, ArmingState::wait_free) << name_of(fault);
  }
}

TEST(Faults, AFewMissedTicksDoNotEndTheForce) {
  EXPECT_EQ(measure_fault_response(pressed("touch", 0), wall(1), 600, {}, InjectedFault::missed_1).end,
            ArmingState::on);
  EXPECT_EQ(measure_fault_response(pressed("touch", 0), wall(1), 600, {}, InjectedFault::missed_5).end,
            ArmingState::on);
}

TEST(Faults, WithoutTheGuardAJumpWouldThrowTheHand) {
  // The purpose of the guard: without it, a wall answers a jump of 30 mm with the full force of the device in one tick.
  const double bare = 600 * 0.030;
  const FaultResponse guarded = measure_fault_response(pressed("touch", 0), wall(1), 600, {}, InjectedFault::jump_30mm);
  EXPECT_LT(guarded.max_force, 0.25 * bare);
  EXPECT_LT(guarded.max_growth, 0.1);
}

// 800, 1600 and 3000 N/m, the exact observer, damping bounded by 3.3 N.
TEST(Passivity, TheControllerTakesTheSpeedOutOfABounceAsInTheTable) {
  struct Row {
    double stiffness;
    double by_delay[2];
  };
  for (const Row& row :
       std::initializer_list<Row>{{800, {0.962, 0.880}}, {1600, {0.996, 1.065}}, {3000, {1.041, 1.400}}})
    for (int delay = 0; delay < 2; ++delay) {
      ClosedLoopConfig config;
      config.device = device_model("touch");
      config.hand = hand_model("released");
      config.delay = delay;
      config.saturation = true;
      const ModelFactory controlled = [delay](double stiffness) {
        LinearWall w;
        w.stiffness = stiffness;
        PassivityOptions options;
        options.delay = delay;
        return ForceModel([w, controller = PassivityController(options, 3.3), last = Vec3(0, 0, 0),
                           held = Vec3(0, 0, 0), started = false](const DeviceState& s) mutable {
          Wrench wrench = w(s);
          const Vec3 motion = started ? Vec3(s.X_BS.translation - last) : Vec3::Zero();
          started = true;
          last = s.X_BS.translation;
          wrench = controller.control({wrench, {}, {held}, motion, Vec3::Zero(), 1e-3, {}});
          if (wrench.force.norm() > 3.3) wrench.force *= 3.3 / wrench.force.norm();
          held = wrench.force;
          return wrench;
        });
      };
      EXPECT_NEAR(measure_bounce(config, controlled, row.stiffness).restitution, row.by_delay[delay], 0.02)
          << row.stiffness << " N/m, delay " << delay;
    }
}

// A wall gives back its stored energy. A controller that mistakes this for activity would react again and again.
TEST(Passivity, TheControllerOfTheGuardLeavesAHandAloneThatPressesSteadily) {
  for (const char* device : {"touch", "premium15"})
    for (const double stiffness : {200.0, 600.0}) {
      auto guard = std::make_shared<SafetyGuard>(capabilities(device_model(device)), GuardOptions{});
      guard->start();
      const ModelFactory guarded = [&](double k) {
        LinearWall w;
        w.stiffness = k;
        return ForceModel(
            [w, guard](const DeviceState& reading) mutable { return guard->limit(w(guard->admit(reading))); });
      };
      ClosedLoopConfig config = pressed(device, 0);
      PressTest test;
      test.speed = 0;
      test.depth = 6e-3;
      test.seconds = 8;
      // The hand waits above the surface until the force is faded in.
      config.hand.stiffness = 200;
      test.approach = 3;
      const Buzz buzz = measure_buzz(config, guarded, stiffness, test);
      EXPECT_EQ(guard->state(), ArmingState::on);
      EXPECT_FALSE(buzz.buzzes()) << device << ", " << stiffness << " N/m: " << buzz.position_rms * 1e6 << " um, "
                                  << buzz.force_peak_to_peak << " N";
      // A held wall generates a little energy while the tip bounces once: 20 ticks of 5000.
      EXPECT_LT(guard->log().count(SafetyEvent::passivity), 20U) << device << ", " << stiffness;
    }
}

}  // namespace
}  // namespace hapticut::faults_test
