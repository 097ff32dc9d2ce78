// SPDX-License-Identifier: Apache-2.0
// D15: a ball pushed beyond its radius into material that is not cut keeps pushing back.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "experiments/setup/static_contact.hpp"
#include "hapticut/force/deep_contact.hpp"
#include "support/generators.hpp"
#include "support/laws.hpp"

namespace hapticut::deep_contact_test {
namespace {

using units::mm;

constexpr double kRadius = 0.5 * mm;

const Box kBlock{Vec3(-1, -1, -3) * mm, Vec3(1, 1, 0) * mm};

SimulationConfig swept(bool deep_contact = true) {
  SimulationConfig config = test::static_config();
  config.max_sweep = 64;
  config.reserved_blocks = 2000;
  config.deep_contact = deep_contact;
  return config;
}

Simulation ball_over(const SimulationConfig& config, const Box& box = kBlock, Spindle spindle = {}) {
  return Simulation(test::box_at_phase(box, 0.05 * mm, Vec3(0.3, 0.6, 0.2)),
                    Tool(SphereHead{kRadius}, RayHandle{0}, spindle), config);
}

/// Vertical force with the tip `depth` below the surface, on the way down from above.
double push_to(Simulation& simulation, double& z, double depth) {
  const double target = kRadius - depth;
  while (std::abs(z - target) > 1e-12) {
    z += std::clamp(target - z, -0.005 * mm, 0.005 * mm);
    (void)simulation.step(Pose::from_translation(Vec3(0, 0, z)), {}, 1e-3);
  }
  return simulation.last_result().force.z();
}

// Proves: deep contact.
TEST(DeepContact, D15TheForceOfABallNeverFallsAsItGoesDeeper) {
  Simulation held = ball_over(swept()), springs = ball_over(swept(false));
  double z = kRadius + 0.01 * mm, z_springs = z, before = 0, peak = 0;
  for (double depth = 0.02; depth <= 1.6; depth += 0.02) {
    const double force = push_to(held, z, depth * mm);
    const double alone = push_to(springs, z_springs, depth * mm);
    EXPECT_GE(force, before * (1 - 2e-3)) << depth;  // ripple of the grid
    if (depth <= 0.5) {
      EXPECT_EQ(force, alone) << "up to its radius nothing changes";
    }
    peak = std::max(peak, alone);
    before = force;
  }
  EXPECT_LT(springs.last_result().force.z(), 1e-2 * peak) << "with the springs alone it pops through";
  EXPECT_GT(before, 1.5 * peak);
  EXPECT_LT(std::abs(held.last_result().energy.closure()), 1e-3);
}

// Proves: deep contact.
TEST(DeepContact, CostsNoWorkOnTheWayInAndOut) {
  Simulation simulation = ball_over(swept());
  double z = kRadius + 0.01 * mm;
  (void)push_to(simulation, z, 0);
  (void)push_to(simulation, z, 1.4 * mm);
  const double stored = simulation.last_result().energy.elastic;
  (void)push_to(simulation, z, -0.01 * mm);
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_LT(std::abs(energy.hand_work), 2e-3 * stored);
  EXPECT_EQ(energy.elastic, 0);
  EXPECT_LT(energy.released, 1e-3 * stored);
}

// Proves: deep contact.
TEST(DeepContact, YieldsWhereAWallBreaks) {
  const Box wall{Vec3(-1, -1, -0.75) * mm, Vec3(1, 1, 0) * mm};
  Simulation simulation = ball_over(swept(), wall);
  double z = kRadius + 0.01 * mm;
  double held = push_to(simulation, z, 0.8 * mm);
  EXPECT_GT(held, 0);
  EXPECT_EQ(push_to(simulation, z, 1.8 * mm), 0) << "beyond the wall there is no contact";
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_GT(energy.released, 0);
  EXPECT_GT(energy.hand_work, -1e-9) << "pushing through never gives the hand energy";
}

// The forces of other laws follow their formulas at any depth.
// Proves: deep contact.
TEST(DeepContact, ActsUnderNoLawButTheOneThatClaimsIt) {
  int others = 0;
  for (const test::NamedLaw& named : test::all_laws()) {
    if (!std::holds_alternative<SphereHead>(named.head.shape()) || named.law->tethers_deep_ball()) continue;
    ++others;
    const auto pushed = [&](bool deep_contact) {
      SimulationConfig config = swept(deep_contact);
      config.law = named.law;
      Simulation simulation = ball_over(config);
      double z = kRadius + 0.01 * mm;
      return push_to(simulation, z, 1.4 * kRadius);
    };
    EXPECT_EQ(pushed(true), pushed(false)) << named.name;
  }
  EXPECT_GE(others, 5);
  EXPECT_TRUE(FoundationLaw().tethers_deep_ball());
}

// A ball that spins about a horizontal axis is dragged along the surface by kappa f. The spring that holds the ball has
// the direction of the normal forces, without the drag.
// Proves: deep contact.
TEST(DeepContact, HoldsASpinningBallAlongItsNormalForceAndNotAlongItsDrag) {
  const auto pushed = [](bool deep_contact) {
    Simulation simulation = ball_over(swept(deep_contact), kBlock, Spindle{2000 * units::rad_per_s});
    Pose pose = {rotation_from_vector(Vec3(0, 0.5 * units::kPi, 0)), Vec3(0, 0, kRadius)};
    for (; pose.translation.z() > -0.4 * kRadius; pose.translation.z() -= 0.005 * mm)
      (void)simulation.step(pose, {}, 1e-3);
    return simulation.last_result().force;
  };
  const Vec3 springs = pushed(false), held = pushed(true) - springs;
  EXPECT_GT(springs.head<2>().norm(), 0.2 * springs.z()) << "there must be a drag beside the normal force";
  EXPECT_GT(held.z(), 0.2 * springs.z());
  // The normal force of a grid has a quadrature error.
  constexpr double kQuadrature = 0.01;
  EXPECT_LT(held.head<2>().norm(), kQuadrature * held.z());
}

TEST(DeepContact, DoesNotHoldBackACuttingBall) {
  // The ball stands at 1.4 R, then the spindle is switched on: the material that held the ball is cut away.
  Simulation simulation = ball_over(swept());
  double z = kRadius + 0.01 * mm;
  const double standing = push_to(simulation, z, 0.7 * mm);
  EXPECT_GT(standing, 0);
  SimulationConfig config = swept();
  config.removal = RemovalLaw::constant_energy;
  Simulation cutting = ball_over(config);
  z = kRadius + 0.01 * mm;
  (void)push_to(cutting, z, 0.7 * mm);
  cutting.spindle().set_speed(20000 * units::rad_per_s);
  for (int i = 0; i < 3000; ++i) (void)cutting.step(Pose::from_translation(Vec3(0, 0, z)), {}, 1e-3);
  EXPECT_GT(cutting.last_result().energy.cutting, 0);
  EXPECT_LT(cutting.last_result().force.z(), 0.1 * standing)
      << "little is left, except on the axis, where nothing slips";
  EXPECT_LT(std::abs(cutting.last_result().energy.closure()), 1e-3);
}

// Proves: deep contact.
RC_GTEST_PROP(DeepContactProperty, NeverGivesMoreEnergyThanItTook, ()) {
  DeepContact contact;
  Vec3 at = Vec3::Zero();
  double work = 0, scale = 1e-12;
  for (int i = 0; i < 80; ++i) {
    const Vec3 next = *test::arbitrary_vector(1 * mm);
    const Vec3 force = *test::arbitrary_vector(5);
    const auto outcome = contact.move(at, next, *test::number_between(0, 1), force, kRadius);
    work -= outcome.force.dot(next - at);
    work -= outcome.released;
    scale += std::abs(outcome.force.dot(next - at)) + outcome.released;
    RC_ASSERT(outcome.released >= 0);
    RC_ASSERT(outcome.stored >= 0);
    RC_ASSERT(std::abs(work - contact.stored()) <= 1e-9 * scale);
    at = next;
  }
}

}  // namespace
}  // namespace hapticut::deep_contact_test
