// SPDX-License-Identifier: Apache-2.0
// Dry friction alone: the cone, and refused constants. The work of a drag, C17, is an experiment of `hapticut
// validate`.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hapticut/core/units.hpp"
#include "hapticut/force/limit_surface.hpp"
#include "support/generators.hpp"
#include "support/refusal.hpp"

namespace hapticut::friction_test {
namespace {

using test::arbitrary_vector;
using test::number_between;
using units::mm;

/// Result of a contact at one point.
struct AtPoint {
  Vec3 force;
  double dissipated;
  Mat3 stiffness;
};
AtPoint move_point(LimitSurface& anchor, const Vec3& normal, const Vec3& move, const DryFriction& friction,
                   double share = 1, double lead = 0) {
  const auto outcome = anchor.move(SpreadFriction::at_point(normal, friction), {move, Vec3::Zero()}, share, lead);
  EXPECT_EQ(outcome.wrench.torque, Vec3(0, 0, 0));
  return {outcome.wrench.force, outcome.dissipated, outcome.stiffness.topLeftCorner<3, 3>()};
}

// Proves: friction cone; slipping.
RC_GTEST_PROP(LimitSurface, NeverLeavesTheConeAndNeverDissipatesLessThanNothing, ()) {
  DryFriction friction;
  friction.dynamic_friction = *number_between(0, 0.8);
  friction.static_friction = friction.dynamic_friction + *number_between(0, 0.5);
  friction.tangential_stiffness = *number_between(10, 5000);
  LimitSurface contact;
  double work = 0, dissipated = 0, scale = 1e-9;
  for (int i = 0; i < 100; ++i) {
    const Vec3 normal = *rc::gen::inRange(0, 20) == 0 ? Vec3(0, 0, 0) : *arbitrary_vector(5);
    const Vec3 move = *arbitrary_vector(0.5 * mm);
    const double fraction = *number_between(0, 1);
    const auto outcome = move_point(contact, normal, move, friction, fraction);
    RC_ASSERT(outcome.force.norm() <= friction.static_friction * fraction * normal.norm() * (1 + 1e-9));
    RC_ASSERT(std::abs(outcome.force.dot(normal)) <= 1e-9 * (1 + normal.squaredNorm()));
    RC_ASSERT(outcome.dissipated >= 0);
    work -= outcome.force.dot(move);
    dissipated += outcome.dissipated;
    scale += std::abs(outcome.force.dot(move));
  }
  RC_ASSERT(std::abs(work - dissipated - contact.stored()) < 1e-9 * scale);
}

TEST(LimitSurface, HasNoAnchorWithoutContact) {
  LimitSurface contact;
  (void)move_point(contact, Vec3(0, 0, 1), Vec3(1e-4, 0, 0), DryFriction{0.3, 0.3, 1000});
  const double stored = contact.stored();
  EXPECT_GT(stored, 0);
  const auto outcome = move_point(contact, Vec3::Zero(), Vec3(1e-4, 0, 0), DryFriction{0.3, 0.3, 1000});
  EXPECT_FALSE(contact.anchored());
  EXPECT_EQ(outcome.force, Vec3(0, 0, 0));
  EXPECT_EQ(outcome.dissipated, stored);
}

// Proves: hand-over to the spin.
TEST(DryFrictionFraction, GoesSmoothlyFromOneAtRestToZeroAtFullSpin) {
  const double radius = 1 * mm, full = kFullSpinSpeed / radius;
  EXPECT_EQ(dry_friction_fraction(0, radius), 1);
  EXPECT_EQ(dry_friction_fraction(full, radius), 0);
  EXPECT_EQ(dry_friction_fraction(-2 * full, radius), 0);
  double before = 1;
  for (double spin = 0; spin <= full; spin += full / 1000) {
    const double fraction = dry_friction_fraction(spin, radius);
    EXPECT_LE(fraction, before);
    EXPECT_LT(before - fraction, 2e-3) << "no step";
    before = fraction;
  }
}

// Proves: constants of friction.
TEST(DryFrictionInput, IsRefusedWithItsValueAndTheCure) {
  const auto expect = [](const DryFriction& friction, const char* words) {
    test::expect_refused([&] { validate(friction); }, {words});
  };
  EXPECT_NO_THROW(validate(DryFriction{0.3, 0.3, 1000}));
  EXPECT_NO_THROW(validate(DryFriction{0.3, 0.3, 0})) << "as stiff as the contact";
  expect({0.3, 0.4, 1000}, "dynamic_friction = 0.4; must not exceed static_friction = 0.3");
  expect({-0.1, 0, 1000}, "static_friction");
  expect({0.3, -0.1, 1000}, "dynamic_friction");
  expect({0.3, 0.3, -1}, "tangential_stiffness");
  expect({std::nan(""), 0.3, 1000}, "nan");
}

/// Condition of implicit steps: the force at the end of a step is the slope of a convex function of the end position,
/// so a step has exactly one solution. `stiffness` is the slope of this force.
RC_GTEST_PROP(LimitSurface, AtTheEndOfAStepOpposesEveryFurtherMotion, ()) {
  const DryFriction friction{*number_between(0.2, 1), *number_between(0, 0.2), *number_between(100, 1e6)};
  const Vec3 normal = *number_between(0.1, 5) * (Vec3(0, 0, 1) + 0.3 * *arbitrary_vector(1)).normalized();
  LimitSurface before;
  for (int n = 0; n < 3; ++n) (void)move_point(before, normal, *arbitrary_vector(1 * mm), friction, 1, 0.5);
  const auto move = [&](const Vec3& displacement) {
    LimitSurface anchor = before;
    return move_point(anchor, normal, displacement, friction, 1, 0.5);
  };
  const Vec3 a = *arbitrary_vector(1 * mm), b = *arbitrary_vector(1 * mm);
  RC_ASSERT((move(a).force - move(b).force).dot(a - b) <= 1e-12);

  const Mat3 stiffness = move(a).stiffness;
  const Vec3 direction = (*arbitrary_vector(1) + Vec3(1e-3, 0, 0)).normalized();
  const double h = 1e-9;
  const Vec3 slope = -(move(a + h * direction).force - move(a - h * direction).force) / (2 * h);
  RC_ASSERT((stiffness - stiffness.transpose()).norm() <= 1e-9 * stiffness.norm());
  RC_ASSERT(direction.dot(stiffness * direction) >= -1e-9 * stiffness.norm());
  const bool sticks_and_slides = (move(a + h * direction).stiffness - move(a - h * direction).stiffness).norm() >
                                 1e-3 * friction.tangential_stiffness;  // the force has a kink in between
  if (!sticks_and_slides) RC_ASSERT((stiffness * direction - slope).norm() <= 1e-4 * friction.tangential_stiffness);
}

}  // namespace
}  // namespace hapticut::friction_test
