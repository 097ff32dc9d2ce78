// SPDX-License-Identifier: Apache-2.0
// Dry friction of a standing head in the whole step: where it acts, its constants, its energy, and the transition to
// the cutting ratio when the spindle starts.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/static_contact.hpp"
#include "hapticut/force/limit_surface.hpp"

namespace hapticut::friction_test {
namespace {

using namespace test;
using units::mm;

constexpr double kDepth = 0.3 * mm;

constexpr double kNormal = 3e-3;        // [1] rotation of the normal force by voxels of a third of the depth
constexpr double kTwoMaterials = 5e-3;  // [1] rotation of the normal force near a softer half
constexpr double kArm = 1e-2;           // [1] error of the point where this rotated force leaves the ball
constexpr double kClosure = 1e-4;       // [1] error of the ledger
constexpr double kPressedOnce = 1e-3;   // [1] the step that presses is not part of the path

Material rough(const char* name, double ratio) {
  Material material = plain_material();
  material.name = name;
  material.static_friction = 1.5 * ratio;
  material.dynamic_friction = ratio;
  material.tangential_stiffness = 2000;
  return material;
}

Simulation ball_on_block(SimulationConfig config = {}, Spindle spindle = {}, double half_width = 3 * mm) {
  config.reference_stiffness = 1e12;
  const Box box{Vec3(-half_width, -2 * mm, -2 * mm), Vec3(half_width, 2 * mm, 0)};
  return Simulation(build_block(box, kVoxel, rough("rough", 0.3)), Tool(SphereHead{kRadius}, RayHandle{0}, spindle),
                    config);
}

/// Presses down to kDepth in 100 steps, then drags along x.
const StepResult& press_and_drag(Simulation& simulation, double to_x, double speed) {
  Pose pose = Pose::from_translation(Vec3(0, 0, kRadius));
  for (int i = 0; i < 100; ++i) {
    pose.translation.z() -= kDepth / 100;
    (void)simulation.step(pose, {}, kTick);
  }
  const int steps = int(to_x / (speed * kTick));
  for (int i = 0; i < steps; ++i) {
    pose.translation.x() += speed * kTick;
    (void)simulation.step(pose, {}, kTick);
  }
  return simulation.last_result();
}

/// Force on a ball that slides along x, kDepth deep in a flat solid: the limit surface of all its points.
struct Sliding {
  double ratio;  // [1] force along x over that along z
  double arm;    // [m] below the ball's centre, at which the force along x acts
};
Sliding sliding_cap(double friction, const Vec3& along = Vec3::UnitX()) {
  SpreadFriction contact;
  double normal_force = 0;
  constexpr int kAcross = 80;
  const double step = 2 * kRadius / kAcross, surface = -(kRadius - kDepth);
  for (int i = 0; i < kAcross; ++i)
    for (int j = 0; j < kAcross; ++j)
      for (int k = 0; k < kAcross; ++k) {
        const Vec3 p((i + 0.5) * step - kRadius, (j + 0.5) * step - kRadius, surface - (k + 0.5) * kDepth / kAcross);
        if (p.norm() >= kRadius) continue;
        const double normal = kRadius - p.norm();
        contact.add(p, p.normalized(), normal, {friction, friction, 1});
        normal_force -= normal * p.normalized().z();
      }
  LimitSurface anchor;
  const Wrench wrench = anchor.move(contact, {1e6 * along, Vec3::Zero()}).wrench;
  return {-wrench.force.dot(along) / normal_force, wrench.torque.norm() / wrench.force.norm()};
}

// Proves: sticking.
TEST(Friction, OfAStandingBallIsTheDynamicRatioOfItsNormalForceAndActsAtTheContact) {
  Simulation simulation = ball_on_block();
  const StepResult& result = press_and_drag(simulation, 1 * mm, 5 * units::mm_per_s);
  const double normal = result.force.z();
  // The grid's normal force is vertical up to its quadrature error.
  const Sliding expected = sliding_cap(0.3);
  EXPECT_NEAR(expected.ratio, 0.315, 1e-3) << "5 % above the ratio, because the forces around the pole are inclined";
  EXPECT_NEAR(result.force.x() / normal, -expected.ratio, kNormal);
  EXPECT_NEAR(result.force.y() / normal, 0, kNormal);
  EXPECT_NEAR(result.torque.y() / (-expected.arm * result.force.x()), 1, kArm) << "arm: from the centre to the contact";
  EXPECT_EQ(result.removed_volume, 0);
  EXPECT_LT(unbooked(result.energy), kClosure);
  EXPECT_GT(result.energy.sliding, 0);
  EXPECT_GT(result.energy.anchored, 0);
}

// Proves: energy of the anchor.
TEST(Friction, SticksAndReturnsItsEnergyWhenThePathDoes) {
  Simulation simulation = ball_on_block();
  Pose pose = Pose::from_translation(Vec3(0, 0, kRadius - kDepth));
  Pose above = pose;
  above.translation.z() += kDepth;
  (void)simulation.step(above, {}, kTick);
  (void)simulation.step(pose, {}, 0.02);
  const double before = simulation.last_result().energy.hand_work, slid = simulation.last_result().energy.sliding;
  for (int i = 0; i < 40; ++i) {
    pose.translation.x() += (i < 20 ? 1 : -1) * 1e-7;  // 2 um back and forth: below mu_s N / k_t = 5 um
    (void)simulation.step(pose, {}, kTick);
  }
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_LT(std::abs(energy.hand_work - before), kPressedOnce * energy.elastic);
  EXPECT_LT(energy.sliding - slid, 1e-6 * energy.elastic);
}

// Proves: constants of friction.
TEST(Friction, IsThatOfTheMaterialUnderTheContact) {
  const Box box{Vec3(-3, -2, -2) * mm, Vec3(3, 2, 0) * mm};
  const auto two = box_at_phase(box, kVoxel, Vec3::Zero(), MaterialTable({rough("left", 0.2), rough("right", 0.5)}),
                                [](const Vec3& p) { return MaterialId(p.x() < 0 ? 1 : 2); });
  for (const double side : {-1.0, 1.0}) {
    Simulation simulation(two.clone(), Tool(SphereHead{kRadius}), on_foundation(1e12));
    Pose pose = Pose::from_translation(Vec3(side * 1.5 * mm, 0, kRadius));
    for (int i = 0; i < 300; ++i) {
      if (i < 100)
        pose.translation.z() -= kDepth / 100;
      else
        pose.translation.y() += 2e-6;
      (void)simulation.step(pose, {}, kTick);
    }
    const Vec3& force = simulation.last_result().force;
    EXPECT_NEAR(-force.y() / force.z(), sliding_cap(side < 0 ? 0.2 : 0.5).ratio, kTwoMaterials);
  }
}

// Proves: constants of friction.
TEST(Friction, OfTheConfigurationReplacesThatOfTheMaterials) {
  SimulationConfig config;
  config.friction = DryFriction{0.7, 0.6, 3000};
  Simulation simulation = ball_on_block(config);
  const StepResult& result = press_and_drag(simulation, 1 * mm, 5 * units::mm_per_s);
  EXPECT_NEAR(-result.force.x() / result.force.z(), sliding_cap(0.6).ratio, kNormal);
}

// Proves: hand-over to the spin.
TEST(Friction, D10HandsOverToTheCuttingRatioAndBackWithoutAStep) {
  SimulationConfig config;
  config.removal = RemovalLaw::none;  // so that only the friction changes
  const double full = kFullSpinSpeed / kRadius;
  const double ramp = 2 * full / 0.5;  // [rad/s^2] reaches twice the speed of the hand-over in half a second
  Simulation simulation = ball_on_block(config, Spindle{0, std::numeric_limits<double>::infinity(), ramp}, 5 * mm);
  Pose pose = Pose::from_translation(Vec3(-4 * mm, 0, kRadius));
  const double speed = 2 * units::mm_per_s;
  Vec3 before = Vec3::Zero();
  double max_change = 0, normal = 0;
  std::array<double, 3> ratio = {};  // standing, spinning, standing again
  for (int i = 0; i < 3300; ++i) {
    if (i < 100)
      pose.translation.z() -= kDepth / 100;
    else
      pose.translation.x() += speed * kTick;
    if (i == 1000) simulation.spindle().set_speed(2 * full * units::rad_per_s);
    if (i == 2000) simulation.spindle().set_speed(0);
    const StepResult& result = simulation.step(pose, {}, kTick);
    const Vec3 tangential(result.force.x(), result.force.y(), 0);
    normal = result.force.z();
    if (i > 900) max_change = std::max(max_change, (tangential - before).norm());
    before = tangential;
    if (i == 999 || i == 1999 || i == 3299)
      ratio[std::size_t(i / 1000 - (i == 3299 ? 1 : 0))] = tangential.norm() / normal;
    if (i == 1999) {
      EXPECT_EQ(result.spindle.speed, 2 * full);
    }
  }
  EXPECT_NEAR(ratio[0], sliding_cap(0.3).ratio, kNormal);
  EXPECT_EQ(simulation.last_result().spindle.speed, 0);
  EXPECT_NEAR(ratio[2], sliding_cap(0.3).ratio, kNormal);
  // A jump would change the whole friction, 0.3 N, in one tick. The hand-over takes 250 ticks, a quarter of a second.
  EXPECT_LT(max_change, 0.03 * normal);
  EXPECT_LT(std::abs(simulation.last_result().energy.closure()), 1e-3);
}

}  // namespace
}  // namespace hapticut::friction_test
