// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/stiffness.hpp"

#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::stiffness_test {
namespace {

using units::kPi;
using units::mm;

TEST(Stiffness, C2ASphereIsStiffestAtTwoThirdsOfItsRadius) {
  EXPECT_NEAR(largest_contact_stiffness(SphereHead{2 * mm}) / closed_forms::largest_cap_stiffness(1, 2 * mm), 1, 0.01);
}

TEST(Stiffness, AFlatHeadOnItsBottomIsStiffestAtItsFullHeight) {
  const double radius = 1 * mm, height = 2 * mm;
  EXPECT_NEAR(
      largest_contact_stiffness(FlatHead{radius, height, FlatRule::bottom_only}) / (kPi * radius * radius * height), 1,
      0.01);
}

TEST(Stiffness, ALongNearestFlatIsStifferSidewaysThanAlongItsAxis) {
  // Along the axis C6 gives at most (4 pi/27) R^3; sideways the wall acts over the whole height.
  const double radius = 1 * mm;
  EXPECT_GT(largest_contact_stiffness(FlatHead{radius, 10 * mm}), closed_forms::largest_cap_stiffness(1, radius));
}

TEST(Stiffness, AccuracyAsksForAnEngagedLayerOfATenthOfTheRadius) {
  Material bone;
  bone.name = "bone";
  const double radius = 1 * mm, feed = 2 * mm;
  const AngularSpeed speed = 2000 * units::rad_per_s;
  const double k = stiffness_for_accuracy(SphereHead{radius}, bone, speed, feed);
  const double layer =
      closed_forms::engaged_layer({bone.specific_cutting_energy, bone.cutting_ratio, speed, feed}, k, radius);
  EXPECT_NEAR(layer / radius, 0.1, 1e-12);
  Material porous = bone;
  porous.relative_stiffness = 0.02;
  EXPECT_NEAR(stiffness_for_accuracy(SphereHead{radius}, porous, speed, feed) / k, 50, 1e-9) << "to be passed on";
  Material chips = bone;
  chips.size_length = 1e-4;
  EXPECT_GT(stiffness_for_accuracy(SphereHead{radius}, chips, speed, feed), 2 * k) << "thin chips press harder";
}

TEST(Stiffness, TheDeviceBoundKeepsTheContactBelowTheDevicesStiffness) {
  const ToolHead head = SphereHead{1 * mm};
  EXPECT_NEAR(stiffness_for_device(head, 700) * largest_contact_stiffness(head), 700, 1e-9);
}

TEST(Stiffness, RefusesAStandingSpindleAndAZeroFeed) {
  Material bone;
  bone.name = "bone";
  EXPECT_THROW((void)stiffness_for_accuracy(SphereHead{1 * mm}, bone, 0, 1 * mm), Error);
  EXPECT_THROW((void)stiffness_for_accuracy(SphereHead{1 * mm}, bone, 100 * units::rad_per_s, 0), Error);
  EXPECT_THROW((void)stiffness_for_accuracy(SphereHead{1 * mm}, bone, 100 * units::rad_per_s, 2), Error) << "mm/s";
  EXPECT_THROW((void)stiffness_for_device(SphereHead{1 * mm}, -1), Error);
}

}  // namespace
}  // namespace hapticut::stiffness_test
