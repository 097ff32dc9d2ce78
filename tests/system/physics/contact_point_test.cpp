// SPDX-License-Identifier: Apache-2.0
// Point, direction, area and pressure of the contact, against integrals over the cap of a ball and the end of a
// cylinder.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/static_contact.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::contact_point_test {
namespace {

using namespace test;
using units::kPi;
using units::mm;

constexpr double kDepth = 0.3 * mm;

Contact contact_of(const ToolHead& head, const Vec3& place, double voxel_size, double spin = 0,
                   const Mat3& R_WH = Mat3::Identity()) {
  const Vec3 phase(0.3, 0.1, 0.7);
  Simulation simulation(
      box_at_phase(half_space(kRadius, kDepth, voxel_size), voxel_size, phase, materials_of_stiffness({1})),
      Tool(head, RayHandle{0}, Spindle{spin * units::rad_per_s}), static_config());
  return simulation.step({R_WH, place}, {}, 1e-3).contact;
}

/// Integrals over the cap of a ball, of its springs w = R - r.
struct Cap {
  double lever = 0;   // [m] distance of the springs' mean position from the ball's centre
  double normal = 0;  // [N] sum of the normal forces
};
Cap cap() {
  constexpr int kSteps = 100000;
  const double h = kRadius - kDepth;
  double size = 0, moment = 0;
  for (int n = 0; n < kSteps; ++n) {
    const double r = h + kDepth * (n + 0.5) / kSteps, w = kRadius - r;
    size += w * r * r * (1 - h / r);
    moment += w * r * r * r * (1 - h * h / (r * r)) / 2;
  }
  return {moment / size, kStiffness * 2 * kPi * kDepth / kSteps * size};
}

TEST(ContactPoint, OfABallIsThatOfItsCap) {
  const double area = 2 * kPi * kRadius * kDepth;
  double last = 1;
  for (const double voxel : {0.1 * mm, 0.05 * mm}) {
    const Contact contact = contact_of(SphereHead{kRadius}, {0, 0, kRadius - kDepth}, voxel);
    const double lever = kRadius - kDepth - contact.point_W.z();
    EXPECT_NEAR(lever, cap().lever, 0.005 * kRadius);
    EXPECT_LT(contact.point_W.head<2>().norm(), 0.005 * kRadius);
    EXPECT_LT((contact.normal_W - Vec3::UnitZ()).norm(), 0.005);
    const double off = std::abs(contact.area / area - 1);
    EXPECT_LT(off, 0.03) << voxel;
    EXPECT_LT(off, last) << voxel;
    last = off;
    EXPECT_NEAR(contact.pressure * contact.area / cap().normal, 1, 0.01);
  }
}

TEST(ContactPoint, OfTheEndOfACylinderIsItsMiddleAndThePressureThatOfItsDepth) {
  const Mat3 tilted = rotation_from_vector(Vec3(kPi, 0, 0));  // from below, with the end up
  const FlatHead head{kRadius, 3 * mm, FlatRule::bottom_only};
  const Contact contact = contact_of(head, {0, 0, -kDepth}, 0.05 * mm);
  EXPECT_NEAR(contact.area / (kPi * kRadius * kRadius), 1, 0.03);
  EXPECT_NEAR(contact.pressure / (0.5 * kStiffness * kDepth * kDepth), 1, 0.03);
  EXPECT_LT(contact.point_W.head<2>().norm(), 0.01 * kRadius);
  EXPECT_LT((contact.normal_W - Vec3::UnitZ()).norm(), 1e-3);
  const Contact none = contact_of(head, {0, 0, 4 * mm}, 0.05 * mm, 0, tilted);
  EXPECT_EQ(none.voxels, 0);
  EXPECT_TRUE(none.point_W.isZero(0) && none.normal_W.isZero(0));
  EXPECT_EQ(none.area + none.pressure, 0);
}

TEST(ContactPoint, DirectionIsWithoutTheDragOfTheSpin) {
  const Vec3 place(0, 0, kRadius - kDepth);
  const Contact standing = contact_of(SphereHead{kRadius}, place, 0.05 * mm);
  // Rotated so that the axis is along x: the drag is sideways.
  const Contact turning =
      contact_of(SphereHead{kRadius}, place, 0.05 * mm, 100, rotation_from_vector(Vec3(0, kPi / 2, 0)));
  EXPECT_LT((turning.normal_W - standing.normal_W).norm(), 0.01);
  EXPECT_LT((turning.point_W - standing.point_W).norm(), 0.01 * kRadius);
}

TEST(ContactPoint, IsThereUnderOtherLawsToo) {
  SimulationConfig config;
  config.law = std::make_shared<ContactMechanicsLaw>(1e9);
  Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.05 * mm, presets::cortical_bone()),
                        Tool(SphereHead{kRadius}, RayHandle{0}, {}), config);
  const Contact contact = simulation.step(Pose::from_translation({0, 0, kRadius - kDepth}), {}, 1e-3).contact;
  EXPECT_LT((contact.normal_W - Vec3::UnitZ()).norm(), 0.02);
  EXPECT_LT(contact.point_W.head<2>().norm(), 0.02 * kRadius);
  EXPECT_NEAR(contact.area / (2 * kPi * kRadius * kDepth), 1, 0.1);
}

}  // namespace
}  // namespace hapticut::contact_point_test
