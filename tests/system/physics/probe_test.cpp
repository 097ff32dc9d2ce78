// SPDX-License-Identifier: Apache-2.0
// A probe has every stage of the step that gives force: what it reports is what the next step gives.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "support/scenes.hpp"

namespace hapticut::probe_test {
namespace {

using namespace test;
using units::mm;

constexpr double kRounding = 1e-6;  // [1] rounding of single precision
constexpr double kNothing = 1e-9;   // [N], [N m]
constexpr double kLever = 0.1;      // [m] length of the longest handle

void expect_equal(const ContactProbe& probed, const StepResult& stepped, const std::string& where) {
  ASSERT_LT((probed.wrench.force - stepped.model.force).norm(), kNothing + kRounding * stepped.model.force.norm())
      << where;
  ASSERT_LT((probed.wrench.torque - stepped.model.torque).norm(),
            kNothing + kRounding * kLever * stepped.model.force.norm())
      << where;
  ASSERT_EQ(probed.contact.voxels, stepped.contact.voxels) << where;
  ASSERT_LT((probed.contact.point_W - stepped.contact.point_W).norm(), kRounding * kLever) << where;
}

TEST(Probe, IsTheStepOfEveryScene) {
  for (const Scene& scene : scenes()) {
    Simulation simulation = scene.make();
    int compared = 0;
    for (int tick = 0; tick < 300; ++tick) {
      const StepInput input = scene.input(tick);
      const ContactProbe probed = simulation.probe(input.X_WH, input.V_WH, input.dt, ProbedMotions::none);
      const StepResult& stepped = simulation.step(input.X_WH, input.V_WH, input.dt);
      // A probe leaves the material as it is, which later sub-steps of the step have cut.
      if (stepped.sub_steps != 1 || stepped.contact.voxels == 0) continue;
      expect_equal(probed, stepped, scene.name + ", tick " + std::to_string(tick));
      if (HasFatalFailure()) return;
      ++compared;
    }
    if (scene.name != "fast_strokes") {
      EXPECT_GT(compared, 20) << scene.name;
    }
  }
}

/// A ball that is pressed into rough material beyond its radius while it moves sideways.
struct Press {
  const char* name;
  double spin;  // [rad/s]
  bool held;
  Effects effects;
};

std::vector<Press> presses() {
  Effects effects;
  effects.gravity = Gravity{0.2, Vec3(0, 0, 5 * mm)};
  effects.delta_filter = DeltaFilter{};
  effects.limits.max_force = 0.5;
  effects.limits.ramp_time = 0.2;
  return {{"standing", 0, false, {}},
          {"with effects", 0, false, effects},
          {"turning slowly", 0.5, false, {}},
          {"held", kSpin, true, {}}};
}

Material rough_material() {
  Material material = plain_material();
  material.static_friction = 0.4;
  material.dynamic_friction = 0.3;
  material.tangential_stiffness = 2000;
  return material;
}

Simulation rough_block(double spin, const Effects& effects = {}) {
  SimulationConfig config = on_foundation(1e12);
  config.removal = RemovalLaw::none;
  config.effects = effects;
  return Simulation(build_block({Vec3(-3 * mm, -3 * mm, -4 * mm), Vec3(3 * mm, 3 * mm, 0)}, kVoxel, rough_material()),
                    tool_of(SphereHead{kRadius}, spin), config);
}

Vec3 pressed_to(int tick) { return {2e-6 * tick, 0, kRadius - 5e-6 * tick}; }

TEST(Probe, HasDryFrictionAndDeepContactAndNoEffects) {
  for (const Press& press : presses()) {
    Simulation simulation = rough_block(press.spin, press.effects);
    if (press.held) simulation.spindle().hold(true);
    for (int tick = 0; tick < 300; ++tick) {
      const Pose at = Pose::from_translation(pressed_to(tick));
      const Twist velocity = {Vec3(2e-3, 0, -5e-3), Vec3::Zero()};
      const ContactProbe probed = simulation.probe(at, velocity, kTick);
      expect_equal(probed, simulation.step(at, velocity, kTick), press.name);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(simulation.last_result().energy.sliding, 0) << press.name << ": nothing slid";
  }
}

TEST(Probe, BeforeTheFirstStepOfAnotherToolHasNoSpringsOfTheOldOne) {
  Simulation simulation = rough_block(0), fresh = rough_block(0);
  for (int tick = 0; tick < 300; ++tick) step_to(simulation, pressed_to(tick));
  simulation.set(tool_of(SphereHead{kRadius}));
  const Pose at = Pose::from_translation(pressed_to(280));
  const ContactProbe probed = simulation.probe(at, {}, kTick), expected = fresh.probe(at, {}, kTick);
  EXPECT_GT(expected.wrench.force.norm(), 0.1);
  EXPECT_EQ(probed.wrench.force, expected.wrench.force);
  EXPECT_EQ(probed.wrench.torque, expected.wrench.torque);
}

TEST(Probe, LeavesTheTimesOfTheLastStep) {
  SimulationConfig config;
  config.stage_times = true;
  Simulation simulation(plain_block(), tool_of(SphereHead{kRadius}, kSpin), config);
  step_to(simulation, {0, 0, 0.9 * kRadius});
  const double before = simulation.stage_times().press_and_cut;
  EXPECT_GT(before, 0);
  (void)simulation.probe(Pose::from_translation({0, 0, 0.9 * kRadius}), {}, kTick);
  EXPECT_EQ(simulation.stage_times().press_and_cut, before);
}

}  // namespace
}  // namespace hapticut::probe_test
