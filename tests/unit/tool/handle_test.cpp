// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/handle.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "hapticut/core/units.hpp"
#include "support/refusal.hpp"

namespace hapticut::handle_test {
namespace {

using units::kPi;
using units::mm;

constexpr double kRounding = 1e-15;  // [m] or [1]

TEST(RayHandle, PutsTheHeadOnTheStylusAxisAsAnLWithoutBendDoes) {
  const Pose ray = head_in_handle(RayHandle{9 * mm}), straight = head_in_handle(LHandle{7 * mm, 2 * mm, 0});
  EXPECT_EQ(ray.translation, Vec3(0, 0, -9 * mm));
  EXPECT_EQ(ray.rotation, Mat3::Identity());
  EXPECT_LT((straight.translation - ray.translation).norm(), kRounding);
  EXPECT_LT((straight.rotation - ray.rotation).norm(), kRounding);
}

TEST(LHandle, ARightAnglePointsTheHeadsAxisAlongTheHandlesX) {
  const Pose X_HT = head_in_handle(LHandle{7 * mm, 2 * mm, kPi / 2});
  EXPECT_LT((X_HT.rotation.col(2) - Vec3(1, 0, 0)).norm(), kRounding);
  EXPECT_LT((X_HT.rotation.col(1) - Vec3(0, 1, 0)).norm(), kRounding);
  EXPECT_LT((X_HT.translation - Vec3(-2, 0, -7) * mm).norm(), kRounding);
}

TEST(LHandle, TheElbowIsANecksLengthAboveTheHeadOnItsAxisAndALengthBelowTheHand) {
  for (const double bend : {-kPi, -1.0, 0.3, 2.0, kPi}) {
    const Pose X_HT = head_in_handle(LHandle{7 * mm, 2 * mm, bend});
    EXPECT_LT((X_HT * Vec3(0, 0, 2 * mm) - Vec3(0, 0, -7 * mm)).norm(), kRounding) << bend;
    EXPECT_TRUE(is_rotation(X_HT.rotation, 1e-14));
    EXPECT_NEAR(X_HT.rotation(2, 2), std::cos(bend), kRounding);
  }
}

// With a length of 0 by default the hand would be at the middle of the bur and feel no torque.
TEST(Handles, MustSayHowLongTheyAre) {
  const auto message = [](const Handle& handle) { return test::refusal([&] { (void)head_in_handle(handle); }); };
  EXPECT_EQ(message(RayHandle{}),
            "RayHandle::length [m] must be given: from Ho to To, along -z_H. 0.02 is 20 mm; 0 puts the hand at the "
            "head.");
  EXPECT_EQ(message(LHandle{}).find("LHandle::length [m] must be given"), 0U);
  EXPECT_EQ(message(LHandle{20 * mm}).find("LHandle::neck [m] must be given"), 0U);
  EXPECT_EQ(message(RayHandle{0}), "");
  EXPECT_EQ(message(LHandle{0, 0}), "");
}

TEST(Handles, RefuseNegativeLengthsAndBendsBeyond180Degrees) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1e-6, nan, infinity}) {
    EXPECT_THROW((void)head_in_handle(RayHandle{bad}), Error) << bad;
    EXPECT_THROW((void)head_in_handle(LHandle{bad, 0, 0}), Error) << bad;
    EXPECT_THROW((void)head_in_handle(LHandle{0, bad, 0}), Error) << bad;
  }
  for (const double bad : {3.2, -3.2, nan}) EXPECT_THROW((void)head_in_handle(LHandle{0, 0, bad}), Error) << bad;
}

// Proves: handles of the thesis.
TEST(ThesisHandleTorque, OfARayIsTheTorqueOfTheSpindleAboutTheStylusAndNothingElse) {
  const Vec3 torque = thesis_handle_torque(RayHandle{0.1}, Vec3(1, 2, 3), 0.02, 5);
  EXPECT_EQ(torque, Vec3(0, 0, 0.02));
}

// If the head is straight below the hand, the offset is along -z: pitch and roll are the lateral forces times its
// length. Proves: handles of the thesis.
TEST(ThesisHandleTorque, OfAnLIsItsOffsetTimesTheLateralForcesAndTheYawBySineOfTheBend) {
  const double zeta = 0.7, length = 0.1, bend = 0.5;
  const LHandle no_neck{length, 0, bend};
  const Vec3 torque = thesis_handle_torque(no_neck, Vec3(1, 2, 3), 0.02, zeta);
  EXPECT_NEAR(torque.x(), zeta * length * 2, 1e-15);
  EXPECT_NEAR(torque.y(), -zeta * length * 1, 1e-15);
  EXPECT_NEAR(torque.z(), -zeta * std::sin(bend) * 0.02, 1e-15);
  EXPECT_EQ(thesis_handle_torque(LHandle{0, 0, 1}, Vec3(1, 2, 3), 0.02, zeta), Vec3(0, 0, 0));
}

// The formulas of the thesis lose only the yaw: pitch and roll of a force at the head of an L are exact.
TEST(ThesisHandleTorque, AgreesWithTheFullWrenchInPitchAndRollForAScaleOfOne) {
  const LHandle handle{0.1, 0.02, 1.2};
  const Vec3 force(1, -2, 0.5), offset = head_in_handle(handle).translation;
  const Vec3 exact = transport(Wrench{force, Vec3::Zero()}, offset).torque;
  EXPECT_LT((thesis_handle_torque(handle, force, 0, 1) - exact).norm(), 1e-15);
}

}  // namespace
}  // namespace hapticut::handle_test
