// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hapticut/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/chip.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "support/named_material.hpp"

namespace hapticut::stiffness_test {
namespace {

using units::kPi;
using units::mm;

TEST(Stiffness, C2ASphereIsStiffestAtTwoThirdsOfItsRadius) {
  EXPECT_NEAR(max_contact_stiffness(SphereHead{2 * mm}) / closed_forms::max_cap_stiffness(1, 2 * mm), 1, 0.01);
}

TEST(Stiffness, AFlatHeadOnItsBottomIsStiffestAtItsFullHeight) {
  const double radius = 1 * mm, height = 2 * mm;
  EXPECT_NEAR(max_contact_stiffness(FlatHead{radius, height, FlatRule::bottom_only}) / (kPi * radius * radius * height),
              1, 0.01);
}

TEST(Stiffness, ALongNearestFlatIsStifferSidewaysThanAlongItsAxis) {
  // Along the axis C6 gives at most (4 pi/27) R^3; sideways the wall acts over the whole height.
  const double radius = 1 * mm;
  EXPECT_GT(max_contact_stiffness(FlatHead{radius, 10 * mm}), closed_forms::max_cap_stiffness(1, radius));
}

TEST(Stiffness, AccuracyAsksForAnEngagedLayerOfATenthOfTheRadius) {
  const Material bone = test::named("bone");
  const double radius = 1 * mm, feed = 2 * mm;
  const AngularSpeed speed = 2000 * units::rad_per_s;
  const double k = stiffness_for_accuracy(SphereHead{radius}, bone, speed, feed);
  const double layer =
      closed_forms::engaged_layer({bone.specific_cutting_energy, bone.cutting_ratio, speed, feed}, k, radius);
  EXPECT_NEAR(layer / radius, 0.1, 1e-12);
  Material porous = bone;
  porous.relative_stiffness = 0.02;
  EXPECT_NEAR(stiffness_for_accuracy(SphereHead{radius}, porous, speed, feed) / k, 50, 1e-9)
      << "inverse to the relative stiffness";
  Material chips = bone;
  chips.size_length = 1e-4;
  EXPECT_GT(stiffness_for_accuracy(SphereHead{radius}, chips, speed, feed), 2 * k) << "thin chips press harder";
}

TEST(Stiffness, TheDeviceBoundKeepsTheContactBelowTheDevicesStiffness) {
  const ToolHead head = SphereHead{1 * mm};
  EXPECT_NEAR(stiffness_for_device(head, 700) * max_contact_stiffness(head), 700, 1e-9);
}

TEST(Stiffness, RefusesAStandingSpindleAndAZeroFeed) {
  const Material bone = test::named("bone");
  EXPECT_THROW((void)stiffness_for_accuracy(SphereHead{1 * mm}, bone, 0, 1 * mm), Error);
  EXPECT_THROW((void)stiffness_for_accuracy(SphereHead{1 * mm}, bone, 100 * units::rad_per_s, 0), Error);
  EXPECT_THROW((void)stiffness_for_accuracy(SphereHead{1 * mm}, bone, 100 * units::rad_per_s, 2), Error) << "mm/s";
  EXPECT_THROW((void)stiffness_for_device(SphereHead{1 * mm}, -1), Error);
}

TEST(Stiffness, ByDefaultALayerIsAHundredthOfTheRadiusAndLessForAPointedHead) {
  const double round = stiffness_for_head(SphereHead{1 * mm});
  EXPECT_NEAR(round, 2e6 / std::pow(0.01 * mm, 2), 1e-6 * round);
  for (const ToolHead& blunt : {ToolHead(FlatHead{1 * mm, 4 * mm}), twist_drill_head(2 * mm, 4 * mm),
                                ToolHead(ConeHead{60 * units::deg, 1 * mm / std::tan(60 * units::deg)})})
    EXPECT_NEAR(stiffness_for_head(blunt), round, 1e-3 * round) << blunt.description();
  const double needle = stiffness_for_head(needle_head(2 * mm, 20.0 / 3 * mm));
  EXPECT_NEAR(needle, 25 * round, 0.01 * needle);
  EXPECT_NEAR(stiffness_for_head(needle_head(2 * mm, 40 * mm)), 100 * round, 0.01 * needle) << "the thinnest";
}

TEST(FoundationLaw, DampsSmoothlyAndNeverBeyondWhatCrushes) {
  constexpr float kCrushing = 2e-5F;  // [m]
  using Damping = FoundationLaw::Damping;
  for (const float x : {-3.0F, -0.01F, 0.0F, 0.01F, 2.0F}) {
    const auto at = [&](float there) { return Damping::of(there).factor; };
    EXPECT_NEAR((at(x + 1e-3F) - at(x - 1e-3F)) / 2e-3F, Damping::of(x).slope, 2e-3F) << x;
    EXPECT_GT(at(x), 0) << x;
  }
  EXPECT_EQ(Damping::of(3).crushing_depth(kCrushing), 0.5F * kCrushing) << "so k g_d w^2/2 is the strength";
  EXPECT_EQ(Damping::of(-3).crushing_depth(kCrushing), kCrushing);
}

// A lip that passes along a wall takes no chip; a lip that a resting hand presses does.
TEST(ChippingLips, CountWhereTheFeedGoesIntoTheSurface) {
  HeadMotion motion = {};
  motion.velocity = motion.ripple = Eigen::Vector3f::Zero();
  motion.tooth_rate = 600, motion.duration = 0.01F;
  const auto lips = [&](double speed) { return formulas::ChippingLips<double>(motion).at(speed); };
  EXPECT_FLOAT_EQ(float(lips(0)), 6.0F) << "of a head that only presses";
  motion.velocity = {2e-3F, 0, 0};
  EXPECT_FLOAT_EQ(float(lips(2e-3)), 6.0F);
  EXPECT_FLOAT_EQ(float(lips(-1e-3)), 6.0F);
  EXPECT_NEAR(lips(1e-5), 3, 0.01);
  EXPECT_LT(lips(0), 6e-3);
  motion.velocity.x() += 1, motion.ripple = {1, 0, 0};
  EXPECT_NEAR(lips(1e-5), 3, 0.01) << "the feed is without its ripple";
}

}  // namespace
}  // namespace hapticut::stiffness_test
