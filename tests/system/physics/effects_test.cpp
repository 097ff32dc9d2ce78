// SPDX-License-Identifier: Apache-2.0
// Effects in the whole step: the hand feels them in addition to the model, and the
// ledger does not contain them.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"

namespace hapticut::effects_test {
namespace {

using namespace test;
using units::deg;
using units::mm;

Effects all_effects() {
  Effects effects;
  effects.gravity = Gravity{0.05, Vec3(0, 0, -0.03)};
  effects.vibration = Vibration{};
  effects.limits = {3.3, 0.2, 2000, 100, 0.1};
  return effects;
}

Simulation cut(const Effects& effects) {
  SimulationConfig config;
  config.effects = effects;
  return Simulation(plain_block(3 * mm, 3 * mm),
                    Tool(SphereHead{kRadius}, LHandle{80 * mm, 15 * mm, 60 * deg}, Spindle{3000 * units::rad_per_s}),
                    config);
}

/// Moves the head down at 2 mm/s from just above the surface.
Pose head_at(int tick) { return Pose::from_translation(Vec3(0.03, 0.02, 1.1 - 0.002 * tick) * mm); }

const StepResult& step(Simulation& simulation, int tick) {
  return simulation.step(head_at(tick) * simulation.tool().X_HT().inverse(), {}, kTick);
}

// Proves: effects and the model.
TEST(EffectsInTheStep, ChangeWhatTheHandFeelsAndNeitherTheModelNorItsLedger) {
  Simulation plain = cut({}), shaken = cut(all_effects());
  double gravity = 0, difference = 0;
  for (int tick = 0; tick < 300; ++tick) {
    const StepResult& a = step(plain, tick);
    const StepResult& b = step(shaken, tick);
    ASSERT_EQ(a.force, a.model.force);
    ASSERT_EQ(a.torque, a.model.torque);
    ASSERT_EQ(a.model.force, b.model.force);
    ASSERT_EQ(a.model.torque, b.model.torque);
    ASSERT_EQ(a.energy.hand_work, b.energy.hand_work);
    ASSERT_EQ(a.energy.cutting, b.energy.cutting);
    if (tick == 40) gravity = b.force.z() / (-0.05 * 9.80665);
    if (tick > 150) difference = std::max(difference, (a.force - b.force).norm());
    ASSERT_LE(b.force.norm(), 3.3);
  }
  EXPECT_NEAR(gravity, 0.41, 1e-9) << "in the air only gravity, on the start-up ramp";
  EXPECT_NEAR(difference, 0.3 + 0.05 * 9.80665, 0.1) << "gravity and vibration, not always along each other";
}

// Proves: vibration.
TEST(EffectsInTheStep, VibrateAlongTheSpindleOnlyWhileItSpinsInMaterial) {
  Effects effects;
  effects.vibration = Vibration{};
  Simulation simulation = cut(effects);
  for (int tick = 0; tick < 200; ++tick) {
    const StepResult& result = step(simulation, tick);
    const Vec3 extra = result.force - result.model.force;
    if (result.contact.voxels == 0) {
      ASSERT_EQ(extra, Vec3(0, 0, 0));
    } else {
      ASSERT_LT(extra.head<2>().norm(), 1e-12) << "the spindle's axis is vertical here";
      ASSERT_LE(std::abs(extra.z()), 0.3 + 1e-12);
    }
  }
  // Spinning in the air, or standing in material, there is no vibration.
  simulation.spindle().set_speed(0);
  for (int tick = 200; tick < 210; ++tick) {
    const StepResult& result = step(simulation, tick);
    ASSERT_GT(result.contact.voxels, 0);
    ASSERT_EQ(result.force, result.model.force);
  }
}

TEST(EffectsInTheStep, LeaveTheVibrationOutAndSayItWhenAStepIsTooLong) {
  Effects effects;
  effects.vibration = Vibration{};
  Simulation simulation = cut(effects);
  for (int tick = 0; tick < 100; ++tick) (void)step(simulation, tick);
  const Pose next = head_at(101) * simulation.tool().X_HT().inverse();
  const StepResult& result = simulation.step(next, {}, 4e-3);  // 150 Hz sampled at 250 Hz
  EXPECT_TRUE(has_any(result.status, StepStatus::vibration_left_out));
  EXPECT_EQ(result.force, result.model.force);
}

TEST(EffectsInTheStep, FallToZeroWithARejectedInputAndGrowAgainWithinTheLimit) {
  Effects effects;
  effects.gravity = Gravity{1};
  effects.limits.force_growth = 100;
  Simulation simulation = cut(effects);
  for (int tick = 0; tick < 200; ++tick) (void)step(simulation, tick);
  EXPECT_GT(simulation.last_result().force.norm(), 5);
  Pose bad;
  bad.translation.x() = std::nan("");
  EXPECT_EQ(simulation.step(bad, {}, kTick).force, Vec3(0, 0, 0));
  EXPECT_LE(step(simulation, 200).force.norm(), 100 * kTick * (1 + 1e-12));
}

}  // namespace
}  // namespace hapticut::effects_test
