// SPDX-License-Identifier: Apache-2.0
// Each effect alone, and their order.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hapticut/closed_forms.hpp"
#include "hapticut/simulation/output.hpp"
#include "support/generators.hpp"
#include "support/refusal.hpp"

namespace hapticut::effects_test {
namespace {

using test::arbitrary_vector;
using test::number_between;
using units::kPi;

constexpr double kTick = 1e-3;

template <class... Arguments>
std::string refusal(const Arguments&... arguments) {
  return test::refusal([&] { validate(arguments...); });
}

// --- gravity (5.9) ---------------------------------------------------------------------------------------------------

// Proves: gravity.
TEST(Gravity, PullsDownWithTheWeightAndTurnsTheHandAboutTheCentreOfMass) {
  const Gravity tool{0.1, Vec3(0, 0, -0.05), Vec3(0, 0, -9.81)};
  const Wrench upright = gravity_wrench(tool, Mat3::Identity());
  EXPECT_LT((upright.force - Vec3(0, 0, -0.981)).norm(), 1e-15);
  EXPECT_EQ(upright.torque, Vec3(0, 0, 0));
  // The stylus lies along +x: its centre of mass is 50 mm along -z_H = -x_W, and pulls that end down.
  const Wrench level = gravity_wrench(tool, rotation_from_vector(Vec3(0, kPi / 2, 0)));
  EXPECT_NEAR((level.torque - Vec3(0, -0.05 * 0.981, 0)).norm(), 0, 1e-15);
}

// Proves: gravity.
RC_GTEST_PROP(Gravity, DoesNoWorkOnAClosedPath, ()) {
  // The wrench is the gradient of the potential energy -m g . p_com, so the work of small rotations back and forth
  // cancels to second order.
  const Gravity tool{0.2, *arbitrary_vector(0.1), *arbitrary_vector(9.81)};
  const Mat3 R = *test::arbitrary_rotation();
  const Vec3 rotation = *arbitrary_vector(1e-6);
  const Vec3 com = R * tool.center_of_mass;
  const double work = gravity_wrench(tool, R).torque.dot(rotation);
  const double potential = tool.mass * tool.acceleration.dot(rotation_from_vector(rotation) * com - com);
  RC_ASSERT(std::abs(work - potential) < 1e-11);
}

// --- vibration (5.10) ------------------------------------------------------------------------------------------------

/// [N] root mean square and zero crossings per second of a second of vibration.
struct Shake {
  double rms = 0, peak = 0;
  int crossings = 0;
};

Shake shake(const Vibration& vibration, double rate) {
  VibrationPhase phase;
  Shake s;
  double before = 0;
  for (int i = 0; i < int(rate); ++i) {
    const double force = phase.advance(vibration, true, 0, 1 / rate);
    s.rms += force * force / rate;
    s.peak = std::max(s.peak, std::abs(force));
    s.crossings += before * force < 0;
    before = force;
  }
  s.rms = std::sqrt(s.rms);
  return s;
}

constexpr double kPartOfAPeriod = 0.01;  // [1] error of a mean over a second that does not hold whole periods
constexpr double kSampledPeak = 1e-3;    // [N] error of the peak with sixty samples in a period

// Proves: vibration.
TEST(Vibration, ShakesAtItsFrequencyWithItsAmplitudeAtEveryAllowedRate) {
  for (const double rate : {1000.0, 2000.0, 4000.0})
    for (const double frequency : {31.0, 147.0, 443.0}) {
      Vibration vibration;
      vibration.frequency = frequency;
      ASSERT_EQ(refusal(vibration, rate), "");
      const Shake s = shake(vibration, rate);
      EXPECT_NEAR(s.rms, 0.3 / std::sqrt(2.0), kPartOfAPeriod * 0.3);
      EXPECT_LE(s.peak, 0.3);
      EXPECT_NEAR(s.crossings, 2 * frequency, 2);
    }
}

// Proves: vibration.
TEST(Vibration, D9OfTheThesisIsRefusedAt1kHzWithTheReason) {
  Vibration vibration;
  vibration.frequency = 500;
  test::expect_refused([&] { validate(vibration, 1000.0); },
                       {"Vibration::frequency = 500 Hz; must be below 450 Hz", "zero at every sample"});
  EXPECT_EQ(refusal(vibration, 2000.0), "");
  vibration.frequency = 450;
  EXPECT_NE(refusal(vibration, 1000.0), "");
}

TEST(Vibration, IsOffWhenNothingIsTouched) {
  VibrationPhase phase;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(phase.advance(Vibration{}, false, 1, kTick), 0);
}

// Proves: vibration.
TEST(Vibration, GrowsWithTheCuttingPowerUpToItsLargest) {
  Vibration vibration;
  vibration.amplitude = 0;
  vibration.amplitude_per_watt = 0.1;
  const auto peak = [&](double power) {
    VibrationPhase phase;
    double maximum = 0;
    for (int i = 0; i < 1000; ++i) maximum = std::max(maximum, phase.advance(vibration, true, power, 1e-4));
    return maximum;
  };
  EXPECT_EQ(peak(0), 0);
  EXPECT_NEAR(peak(2), 0.2, kSampledPeak);
  EXPECT_NEAR(peak(100), vibration.max_amplitude, kSampledPeak);
}

// --- passing teeth ---------------------------------------------------------------------------------------------------

struct Turning {
  double mean = 0, variation = 0;
};

/// Of what `turns` turns add to a force of 1, in steps of the loop.
Turning turn(const ToothPassing& teeth, double speed, int lips, double turns = 100) {
  CutterAngle angle;
  Turning t;
  const int steps = int(std::lround(turns * 2 * kPi / (speed * kTick)));
  for (int n = 0; n < steps; ++n) {
    const double factor = angle.advance(teeth, speed * kTick, lips);
    t.mean += factor / steps, t.variation += factor * factor / steps;
  }
  t.variation = std::sqrt(t.variation);
  return t;
}

// Proves: passing teeth.
TEST(ToothPassing, C45ChangesTheForceByItsAmplitudesAroundAMeanOfZero) {
  const ToothPassing teeth{0.05, 0.02};
  for (const double rpm : {300.0, 1500.0, 9000.0}) {
    const Turning t = turn(teeth, rpm * units::rpm, 2);
    EXPECT_NEAR(t.mean, 0, 1e-4) << rpm;
    EXPECT_NEAR(t.variation / closed_forms::tooth_passing_variation(0.05, 0.02), 1, 1e-3) << rpm;
  }
}

// Proves: passing teeth.
TEST(ToothPassing, LeavesOutWhatIsFasterThan045OfTheRateAndNeverAliasesIt) {
  const ToothPassing teeth;
  const auto variation = [&](double turns_per_step, int lips) {
    return turn(teeth, turns_per_step * 2 * kPi / kTick, lips).variation;
  };
  const double once = teeth.once_per_turn / std::sqrt(2);
  EXPECT_NEAR(variation(0.23, 2), once, 1e-3 * once) << "the teeth are faster";
  EXPECT_GT(variation(0.22, 2), 1.05 * once);
  EXPECT_EQ(variation(0.45, 2), 0);
  EXPECT_EQ(variation(1.0001, 2), 0) << "would beat slowly";
  EXPECT_EQ(variation(-7.3, 6), 0);
  EXPECT_NEAR(variation(0.1, 1), once, 1e-3 * once) << "grains have no teeth";
}

// Proves: passing teeth.
TEST(ToothPassing, ScalesForceAndTorqueOfTheModelButNotTheWeight) {
  Effects effects;
  effects.gravity = Gravity{0.1, Vec3(0, 0, -0.05), Vec3(0, 0, -9.81)};
  effects.teeth = ToothPassing{0.5, 0};
  EffectsInput at;
  at.touching = true, at.dt = kTick, at.turn = kPi / 2, at.lips = 2;
  const Wrench model = {Vec3(1, 2, 3), Vec3(0.1, 0, 0)};
  Output output;
  const Wrench given = output.give(effects, at, model);
  EXPECT_LT((given.force - 1.5 * model.force - Vec3(0, 0, -0.981)).norm(), 1e-12);
  EXPECT_LT((given.torque - 1.5 * model.torque).norm(), 1e-12);
  at.touching = false;
  EXPECT_LT((output.give(effects, at, model).force - model.force - Vec3(0, 0, -0.981)).norm(), 1e-12);
}

// --- the thesis's filter (Table 6.1) ---------------------------------------------------------------------------------

// Proves: delta filter.
TEST(DeltaFilter, LagsAStepOf3NByHalfASecondAndDoesNotRunAwayOnRelease) {
  const DeltaFilter filter;
  Vec3 force = Vec3::Zero();
  int ticks = 0;
  while ((force - Vec3(3, 0, 0)).norm() > 1e-12) force = filtered(filter, force, Vec3(3, 0, 0)), ++ticks;
  // The filter adds epsilon in each tick until delta is left; the last tick adds delta: (3 - 0.5)/0.005 + 1.
  EXPECT_NEAR(ticks, 501, 1);
  ticks = 0;
  while (force.norm() > 0 && ticks < 10000) {
    const double before = force.norm();
    force = filtered(filter, force, Vec3::Zero());
    ASSERT_LE(force.norm(), before);
    ++ticks;
  }
  EXPECT_NEAR(ticks, 501, 1);
}

// --- limits ----------------------------------------------------------------------------------------------------------

// Proves: saturation.
TEST(Saturation, KeepsTheDirection) {
  EXPECT_LT((saturated(Vec3(3, 4, 0), 2.5) - Vec3(1.5, 2, 0)).norm(), 1e-15);
  EXPECT_EQ(saturated(Vec3(3, 4, 0), 5), Vec3(3, 4, 0));
}

// Proves: growth limit.
TEST(GrowthLimit, ReleasesAtOnce) {
  EXPECT_EQ(growth_limited(Vec3(3, 0, 0), Vec3::Zero(), 1e-3), Vec3(0, 0, 0));
  EXPECT_LT((growth_limited(Vec3(3, 0, 0), Vec3(1, 0, 0), 1e-3) - Vec3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((growth_limited(Vec3(3, 0, 0), Vec3(-2, 0, 0), 0.1) - Vec3(-0.1, 0, 0)).norm(), 1e-15)
      << "a reversal is a release, then growth in the other direction";
}

// Proves: growth limit.
RC_GTEST_PROP(GrowthLimit, NeverExceedsTheLargerEndAndAlwaysArrives, ()) {
  const Vec3 start = *arbitrary_vector(5), target = *arbitrary_vector(5);
  const double growth = *number_between(0.01, 1);
  Vec3 force = start;
  for (int i = 0; i < 1100 && (force - target).norm() > 0; ++i) {
    const Vec3 next = growth_limited(force, target, growth);
    RC_ASSERT(next.norm() <= std::max(force.norm(), target.norm()) * (1 + 1e-12));
    RC_ASSERT((next - target).norm() <= (force - target).norm() * (1 + 1e-12));
    RC_ASSERT(next.norm() <= force.norm() + growth * (1 + 1e-12));
    force = next;
  }
  RC_ASSERT((force - target).norm() < 1e-12);
}

// Proves: growth limit.
TEST(GrowthLimit, AtItsLeastRateFollowsAWallThatTheHandRunsInto) {
  const double stiffness = 1000, speed = 0.2;
  const double rate = min_force_growth(stiffness, speed);
  Vec3 force = Vec3::Zero();
  for (int i = 1; i <= 20; ++i) {
    const Vec3 wall(0, 0, stiffness * speed * kTick * i);
    force = growth_limited(force, wall, rate * kTick);
    EXPECT_EQ(force, wall) << "a limiter that lags makes a wall active";
  }
}

// --- all together ----------------------------------------------------------------------------------------------------

// Proves: start-up ramp.
RC_GTEST_PROP(Output, StaysWithinItsLimitsForAnyModelAndEffects, ()) {
  Effects effects;
  effects.gravity = Gravity{0.1, Vec3(0, 0.01, 0.02)};
  effects.vibration = Vibration{};
  if (*rc::gen::arbitrary<bool>()) effects.delta_filter = DeltaFilter{};
  effects.limits = {3.3, 0.1, 500, 10, 0.05};
  Output output;
  Wrench before;
  for (int i = 0; i < 60; ++i) {
    const Wrench model = {*arbitrary_vector(20), *arbitrary_vector(1)};
    const EffectsInput at = {{*test::arbitrary_rotation(), Vec3::Zero()}, {}, true, 1, kTick};
    const Wrench out = output.give(effects, at, model);
    const double ramp = std::min(1.0, (i + 1) * kTick / 0.05);
    RC_ASSERT(out.force.norm() <= 3.3 * ramp * (1 + 1e-12));
    RC_ASSERT(out.torque.norm() <= 0.1 * ramp * (1 + 1e-12));
    // The ramp may add a fiftieth of the maximum force in a tick.
    RC_ASSERT(out.force.norm() <= before.force.norm() + 500 * kTick + 3.3 / 50 + 1e-12);
    before = out;
  }
}

// Proves: mask.
TEST(AxisMask, SwitchesComponentsOff) {
  AxisMask mask;
  mask.force = {true, false, true};
  mask.torque = {false, false, true};
  const Wrench out = masked(mask, {Vec3(1, 2, 3), Vec3(4, 5, 6)});
  EXPECT_EQ(out.force, Vec3(1, 0, 3));
  EXPECT_EQ(out.torque, Vec3(0, 0, 6));
}

TEST(Output, PassesTheModelThroughUnchangedByDefault) {
  Output output;
  const Wrench model = {Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3)};
  const Wrench out = output.give({}, {{}, {}, true, 5, kTick}, model);
  EXPECT_EQ(out.force, model.force);
  EXPECT_EQ(out.torque, model.torque);
}

TEST(EffectsInput, IsRefusedWithItsValueAndTheCure) {
  const auto expect = [](const char* words, const auto&... arguments) {
    const std::string said = refusal(arguments...);
    EXPECT_TRUE(test::contains(said, words)) << said;
  };
  expect("Gravity::mass", Gravity{-1});
  expect("center_of_mass", Gravity{1, Vec3(0, std::nan(""), 0)});
  expect("epsilon = 0.2 N; must not exceed delta = 0.1 N", DeltaFilter{0.1, 0.2});
  expect("delta", DeltaFilter{-1, 0.2});
  EXPECT_EQ(refusal(OutputLimits{}), "");
  OutputLimits none, shrinking;
  none.max_force = 0;
  expect("max_force [N] = 0; must be > 0", none);
  shrinking.force_growth = -5;
  expect("force_growth", shrinking);
  Vibration vibration;
  vibration.amplitude = 2;
  expect("max_amplitude = 0.5 N", vibration, 1000.0);
}

}  // namespace
}  // namespace hapticut::effects_test
