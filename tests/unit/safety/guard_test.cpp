// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/guard.hpp"
#include "hapticut/safety/device_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/guarded_loop.hpp"
#include "support/refusal.hpp"

namespace hapticut::guard_test {
namespace {

using test::GuardedLoop;
using test::kPeriod;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Guard, GivesNoForceUntilTheToolWasFreeAndThenFadesItIn) {
  GuardedLoop loop;
  const Vec3 push(0, 0, 1);
  for (int n = 0; n < 500; ++n) EXPECT_TRUE(loop.tick(push).force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::wait_free);
  EXPECT_EQ(loop.count(SafetyEvent::start_inside), 1U);
  for (int n = 0; n < 10; ++n) loop.tick();
  EXPECT_EQ(loop.guard.state(), ArmingState::ramp);
  double last = 0;
  int ticks = 0;
  for (; loop.guard.state() != ArmingState::on; ++ticks) {
    const double force = loop.tick(push).force.z();
    EXPECT_GE(force, last);
    EXPECT_LT(force - last, 2e-3);  // maximum slope of the smoothstep: 1.5 times the mean of 1 N in 1.5 s
    last = force;
  }
  EXPECT_NEAR(ticks, 1500, 10);
  EXPECT_NEAR(loop.tick(push).force.z(), 1, 1e-12);
}

TEST(Guard, RejectsPosesThatNoHandMakesAndFailsWhenTheyStay) {
  struct Case {
    SafetyEvent event;
    std::function<void(DeviceState&)> spoil;
  };
  for (const Case& bad : std::initializer_list<Case>{
           {SafetyEvent::pose_not_finite, [](DeviceState& s) { s.X_BS.translation.x() = kNan; }},
           {SafetyEvent::pose_not_finite, [](DeviceState& s) { s.X_BS.rotation(0, 1) = kNan; }},
           {SafetyEvent::pose_not_a_rotation, [](DeviceState& s) { s.X_BS.rotation *= 1.01; }},
           {SafetyEvent::pose_outside_workspace, [](DeviceState& s) { s.X_BS.translation.y() = 0.2; }},
           {SafetyEvent::pose_jump, [](DeviceState& s) { s.X_BS.translation.x() += 0.03; }},
           {SafetyEvent::pose_rotation_jump,
            [](DeviceState& s) { s.X_BS.rotation = rotation_from_vector(Vec3(0.5, 0, 0)); }},
           {SafetyEvent::reading_invalid, [](DeviceState& s) { s.valid = false; }}}) {
    GuardedLoop loop;
    loop.engage();
    bad.spoil(loop.reading);
    // At first the last good pose is held, and the model computes with it.
    for (int n = 0; n < 20; ++n) {
      EXPECT_EQ(loop.tick(Vec3(0, 0, 0.1)).force.z(), 0.1) << name_of(bad.event);
      EXPECT_EQ(loop.guard.state(), ArmingState::on);
    }
    EXPECT_TRUE(loop.tick(Vec3(0, 0, 0.1)).force.isZero(0)) << name_of(bad.event);
    EXPECT_EQ(loop.guard.state(), ArmingState::fault) << name_of(bad.event);
    EXPECT_EQ(loop.count(bad.event), 21U) << name_of(bad.event);
  }
}

TEST(Guard, TakesAForceThatIsNotFiniteAsNoneAndFailsAtTheThird) {
  GuardedLoop loop;
  loop.engage();
  const Vec3 bad(kNan, 0, 0);
  EXPECT_TRUE(loop.tick(bad).force.isZero(0));
  EXPECT_TRUE(has_any(loop.guard.output().changes, OutputChange::not_finite));
  EXPECT_EQ(loop.tick(Vec3(0.1, 0, 0)).force.x(), 0.1);
  for (int n = 0; n < 2; ++n) loop.tick(bad);
  EXPECT_EQ(loop.guard.state(), ArmingState::on);
  loop.tick(Vec3(0, 0, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(loop.guard.state(), ArmingState::fault);
  EXPECT_EQ(loop.count(SafetyEvent::force_not_finite), 4U);
}

TEST(Guard, ShortensAForceWithoutTurningItAndTellsBothSides) {
  GuardedLoop loop;
  loop.engage();
  const Vec3 commanded(6, 0, 8);
  Wrench given;
  for (int n = 0; n < 50; ++n) given = loop.tick(commanded);
  EXPECT_NEAR(given.force.norm(), 3.3, 1e-9);
  EXPECT_NEAR(given.force.normalized().dot(commanded.normalized()), 1, 1e-12);
  EXPECT_EQ(loop.guard.output().commanded.force, commanded);
  EXPECT_EQ(loop.guard.output().applied.force, given.force);
  EXPECT_TRUE(has_any(loop.guard.output().changes, OutputChange::saturated));
}

TEST(Guard, LimitsTheGrowthOfAForceButNotItsRelease) {
  GuardedLoop loop;
  loop.engage();
  const double step = loop.guard.slew() * kPeriod;
  EXPECT_NEAR(step, 1.25 * 700 * 0.5 * kPeriod, 1e-12);
  EXPECT_NEAR(loop.tick(Vec3(0, 0, 3)).force.z(), step, 1e-12);
  EXPECT_NEAR(loop.tick(Vec3(0, 0, 3)).force.z(), 2 * step, 1e-12);
  EXPECT_TRUE(has_any(loop.guard.output().changes, OutputChange::slew_limited));
  EXPECT_EQ(loop.tick(Vec3(0, 0, 0.1)).force.z(), 0.1);
  EXPECT_NEAR(loop.tick(Vec3(0, 0, -3)).force.z(), -step, 1e-12);
  EXPECT_TRUE(loop.tick().force.isZero(0));
}

TEST(Guard, LimitsTheGrowthOfATorqueThatTurnsToTheOtherSide) {
  GuardedLoop loop({}, "premium6dof");
  loop.engage();
  const Vec3 max_torque(0, 0.515, 0);
  for (int n = 0; n < 100; ++n) loop.tick(Vec3::Zero(), max_torque);
  ASSERT_NEAR(loop.guard.output().applied.torque.y(), 0.515, 1e-12);
  const double step = loop.guard.slew() / 8.5 * 0.515 * kPeriod;
  for (int n = 1; n <= 5; ++n) {
    loop.tick(Vec3::Zero(), -max_torque);
    EXPECT_NEAR(loop.guard.output().applied.torque.y(), -n * step, 1e-9) << n;
  }
}

// Proves: saturation.
TEST(OutputLimitsOfADevice, AreThoseThatTheGuardHoldsTo) {
  for (const DeviceModel& model : device_models()) {
    const DeviceCapabilities device = capabilities(model);
    const SafetyGuard guard(device, {});
    const OutputLimits limits = output_limits(device);
    EXPECT_EQ(limits.max_force, guard.max_force());
    EXPECT_EQ(limits.force_growth, guard.slew());
    EXPECT_EQ(limits.force_growth, min_force_growth(model.rendered_stiffness, 0.5));
    EXPECT_EQ(std::isinf(limits.max_torque), device.output_degrees_of_freedom < 6);
    EXPECT_NO_THROW(validate(limits));
  }
  const OutputLimits six = output_limits(capabilities(device_model("premium6dof")));
  EXPECT_EQ(six.max_torque, 0.515);
  EXPECT_NEAR(six.max_torque / six.torque_growth, six.max_force / six.force_growth, 1e-12)
      << "the torque reaches its peak in the same time as the force";
}

TEST(OutputLimitsOfADevice, ThatRendersNoForceAreRefused) {
  DeviceCapabilities mouse;
  mouse.model = "mouse";
  EXPECT_THROW((void)output_limits(mouse), Error);
  EXPECT_THROW((void)output_limits(capabilities(device_model("touch")), 0), Error);
}

TEST(Guard, RefusesASlewLimitThatWouldMakeAWallActive) {
  GuardOptions options;
  options.slew = 100;
  test::expect_refused([&] { GuardedLoop loop(options); }, {"437.5"});
}

TEST(Guard, GivesATorqueOnlyToDevicesThatHaveMotorsForIt) {
  GuardedLoop three;
  three.engage();
  EXPECT_TRUE(three.tick(Vec3::Zero(), Vec3(0, 0, 0.01)).torque.isZero(0));
  EXPECT_TRUE(has_any(three.guard.output().changes, OutputChange::no_actuator));

  GuardedLoop six({}, "premium6dof");
  six.engage();
  Wrench given;
  for (int n = 0; n < 100; ++n) given = six.tick(Vec3::Zero(), Vec3(0, 0, 0.01));
  EXPECT_NEAR(given.torque.z(), 0.01, 1e-12);
  for (int n = 0; n < 100; ++n) given = six.tick(Vec3::Zero(), Vec3(0, 0.6, 0.8));
  EXPECT_NEAR(given.torque.norm(), 0.515, 1e-12);
}

TEST(Guard, WaitsUntilFreeAfterALateTickAndFadesInShortly) {
  GuardedLoop loop;
  loop.engage();
  for (int n = 0; n < 10; ++n) loop.tick(Vec3(0, 0, 1));
  EXPECT_GT(loop.tick(Vec3(0, 0, 1), 4e-3).force.z(), 0.9);
  EXPECT_TRUE(loop.tick(Vec3(0, 0, 1), 8e-3).force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::wait_free);
  EXPECT_EQ(loop.count(SafetyEvent::late_wake_up), 1U);
  int ticks = 0;
  for (; loop.guard.state() != ArmingState::on; ++ticks) loop.tick();
  EXPECT_NEAR(ticks, 255, 5);

  EXPECT_TRUE(loop.tick(Vec3(0, 0, 1), 2.0).force.isZero(0));  // a debugger
  EXPECT_EQ(loop.count(SafetyEvent::paused), 1U);
  for (ticks = 0; loop.guard.state() != ArmingState::on; ++ticks) loop.tick();
  EXPECT_NEAR(ticks, 1505, 5);
}

TEST(Guard, WaitsUntilFreeAfterEventsThatCanPutTheToolIntoMaterial) {
  struct Case {
    SafetyEvent event;
    double period;  // [s] duration of the tick
    Vec3 moved;     // [m]
  };
  for (const Case& c :
       {Case{SafetyEvent::recalibrated, kPeriod, Vec3(0.04, 0, 0)},  // farther than a hand can move
        Case{SafetyEvent::reclutched, kPeriod, Vec3::Zero()}, Case{SafetyEvent::model_swapped, kPeriod, Vec3::Zero()},
        Case{SafetyEvent::paused, 5, Vec3(0, 0, -0.02)}}) {
    SCOPED_TRACE(name_of(c.event));
    GuardedLoop loop;
    loop.engage();
    loop.push();
    loop.reading.X_BS.translation += c.moved;
    if (c.event == SafetyEvent::recalibrated)
      ++loop.reading.epoch;
    else if (c.event != SafetyEvent::paused)
      loop.guard.requests().interrupt(c.event);
    EXPECT_TRUE(loop.tick(Vec3(0, 0, 30), c.period).force.isZero(0));
    EXPECT_GE(loop.count(c.event), 1U);
    loop.expect_no_force_until_free();
  }
}

TEST(Guard, AFaultLatchesUntilResetAndThenNeedsAFreeTool) {
  GuardedLoop loop;
  loop.engage();
  loop.push();
  loop.reading.fault = DeviceFault::disconnected;
  loop.reading.valid = false;
  EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::fault);
  loop.reading.fault = DeviceFault::none;
  loop.reading.valid = true;
  ++loop.reading.epoch;  // the driver reports new poses
  for (int n = 0; n < 100; ++n) EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::fault);
  loop.guard.requests().reset_fault();
  for (int n = 0; n < 30; ++n) EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0));
  loop.expect_no_force_until_free();
  EXPECT_EQ(loop.count(SafetyEvent::fault_reset), 1U);
}

TEST(Guard, AnEmergencyStopCancelsAnEarlierResetAndIsResetByALaterOne) {
  GuardedLoop loop;
  loop.engage();
  loop.guard.requests().reset_fault();
  loop.guard.requests().emergency_stop();
  EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0));
  EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::fault);
  loop.guard.requests().reset_fault();
  loop.engage();
  loop.guard.requests().emergency_stop();  // both requests before the next tick
  loop.guard.requests().reset_fault();
  EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0));
  EXPECT_EQ(loop.guard.state(), ArmingState::armed) << "as after any fault";
  EXPECT_EQ(loop.count(SafetyEvent::fault_reset), 2U);
}

TEST(Guard, StopsWhenTheDeviceSaysThatItCannotBeTrusted) {
  for (const DeviceFault fault : {DeviceFault::disconnected, DeviceFault::uncalibrated, DeviceFault::driver_error}) {
    GuardedLoop loop;
    loop.engage();
    loop.reading.fault = fault;
    EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0)) << describe(fault);
    EXPECT_EQ(loop.guard.state(), ArmingState::fault) << describe(fault);
  }
  for (const DeviceFault fault :
       {DeviceFault::force_limit, DeviceFault::speed_limit, DeviceFault::overloaded, DeviceFault::switched_off}) {
    GuardedLoop loop;
    loop.engage();
    loop.reading.fault = fault;
    EXPECT_TRUE(loop.tick(Vec3(0, 0, 1)).force.isZero(0)) << describe(fault);
    EXPECT_EQ(loop.guard.state(), ArmingState::wait_free) << describe(fault);
  }
}

TEST(Guard, DetectsAConstantPositionWhileTheStylusRotates) {
  GuardedLoop loop;
  loop.engage();
  loop.reading.X_BS.translation = {0, -0.04, -0.035};
  loop.guard.requests().interrupt(SafetyEvent::reclutched);
  ++loop.reading.epoch;
  int ticks = 0;
  for (; loop.guard.state() != ArmingState::fault && ticks < 1000; ++ticks) {
    loop.reading.X_BS.rotation = rotation_from_vector(Vec3(0, 0, 0.2 * std::sin(0.03 * ticks)));
    loop.tick();
  }
  EXPECT_LT(ticks, 200);
  EXPECT_GE(loop.count(SafetyEvent::pose_frozen), 1U);
}

TEST(Guard, TakesAStylusAtRestForNothingElse) {
  GuardedLoop loop;
  loop.engage();
  for (int n = 0; n < 5000; ++n) {
    loop.reading.X_BS.rotation = rotation_from_vector(Vec3(0, 0, 1e-3 * std::sin(0.05 * n)));  // tremor of a calm hand
    loop.tick(Vec3(0, 0, 0.1));
  }
  EXPECT_EQ(loop.guard.state(), ArmingState::on);
  EXPECT_EQ(loop.count(SafetyEvent::pose_units), 0U);
}

TEST(Guard, NoticesPositionsInOtherUnits) {
  GuardedLoop loop;
  loop.reading.X_BS.translation = {0, 110, 35};  // millimetres
  for (int n = 0; n < 100; ++n) EXPECT_TRUE(loop.tick().force.isZero(0));
  EXPECT_GE(loop.count(SafetyEvent::pose_units), 1U);
  EXPECT_EQ(loop.guard.state(), ArmingState::armed);
}

TEST(Guard, TellsKilometresFromAHandAtRest) {
  for (const bool kilometres : {true, false}) {
    GuardedLoop loop;
    for (int n = 0; n < 3000; ++n) {
      const double time = n * kPeriod, size = kilometres ? 1e-3 : 1;
      // A hand that moves by 0.2 mm as it rotates the stylus, or a simulated one that rests but for rounding.
      loop.reading.X_BS.translation.x() = size * (kilometres ? 2e-4 : 1e-12) * std::sin(3 * time);
      if (kilometres) loop.reading.X_BS.rotation = rotation_from_vector(Vec3(0, 0, 0.3 * std::sin(3 * time)));
      loop.tick();
    }
    EXPECT_EQ(loop.count(SafetyEvent::pose_units) > 0, kilometres);
  }
}

TEST(Guard, CountsEveryTickOfAnEventButEntersItOnce) {
  GuardedLoop loop;
  loop.engage();
  (void)loop.guard.log().drain();
  for (int n = 0; n < 30; ++n) loop.tick(Vec3(0, 0, 9));
  for (int n = 0; n < 5; ++n) loop.tick();
  for (int n = 0; n < 30; ++n) loop.tick(Vec3(0, 0, 9));
  EXPECT_EQ(loop.count(SafetyEvent::saturated), 60U);
  int entries = 0;
  for (const SafetyLogEntry& entry : loop.guard.log().drain())
    if (entry.event == SafetyEvent::saturated) {
      ++entries;
      EXPECT_NEAR(entry.value, 9, 1e-12);
      EXPECT_NE(describe(entry).find("saturated (9)"), std::string::npos) << describe(entry);
    }
  EXPECT_EQ(entries, 2);
}

TEST(SafetyLog, CountsEventsBeyondTheCapacityOfItsList) {
  SafetyLog log;
  for (int n = 0; n < 3000; ++n) {
    log.begin_tick(n * kPeriod, std::uint64_t(n));
    if (n % 2 == 0) log.report(SafetyEvent::saturated, n);
  }
  EXPECT_EQ(log.count(SafetyEvent::saturated), 1500U);
  const std::size_t kept = log.drain().size();
  EXPECT_EQ(kept + log.dropped(), 1500U);
  EXPECT_GT(log.dropped(), 0U);
}

TEST(Guard, ArmsOnContactAtAnyForce) {
  const Wrench weight{Vec3(0, 0, -3), Vec3::Zero()};
  for (const bool touching : {false, true}) {
    GuardedLoop loop;
    loop.contact.touching = touching;
    loop.contact.effects = weight;
    for (int n = 0; n < 3000; ++n) loop.tick(touching ? Vec3(Vec3::Zero()) : weight.force);
    EXPECT_EQ(loop.guard.state(), touching ? ArmingState::wait_free : ArmingState::on);
  }
}

TEST(Guard, IsNotHurtByNumbersThatAreNone) {
  GuardedLoop loop;
  loop.contact.touching = false;
  loop.contact.effects.force.setConstant(kNan);
  loop.contact.stored = kNan;
  for (int n = 0; n < 3000; ++n) {
    loop.reading.X_BS.translation.z() = 1e-3 * std::sin(0.01 * n);
    const Wrench given = loop.tick(Vec3(0, 0, 1));
    ASSERT_TRUE(given.force.allFinite() && given.force.norm() <= loop.guard.max_force()) << n;
  }
  EXPECT_EQ(loop.guard.state(), ArmingState::on);
}

TEST(Watchdog, FadesAForceOutBeforeItIsFiftyMillisecondsOld) {
  const Watchdog watchdog({});
  EXPECT_EQ(watchdog.verdict(2e-3), Watchdog::Verdict::alive);
  EXPECT_EQ(watchdog.verdict(5e-3), Watchdog::Verdict::late);
  EXPECT_EQ(watchdog.scale(9e-3), 1);
  EXPECT_EQ(watchdog.verdict(20e-3), Watchdog::Verdict::fading);
  EXPECT_NEAR(watchdog.scale(25e-3), 0.5, 1e-12);
  EXPECT_EQ(watchdog.scale(41e-3), 0);
  EXPECT_EQ(watchdog.verdict(51e-3), Watchdog::Verdict::dead);
  for (const double period : {4e-3, 2e-3, 0.5e-3, 0.25e-3}) {
    const Watchdog other({}, period);
    EXPECT_EQ(other.verdict(period), Watchdog::Verdict::alive) << "in time";
    EXPECT_EQ(other.verdict(period + 3e-3), Watchdog::Verdict::late);
    EXPECT_EQ(other.scale(period + 8e-3), 1);
    EXPECT_EQ(other.scale(49e-3), 0) << period;
  }
  WatchdogOptions slow;
  slow.fade = 0.1;
  EXPECT_THROW(Watchdog{slow}, Error);
}

}  // namespace
}  // namespace hapticut::guard_test
