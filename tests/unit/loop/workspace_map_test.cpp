// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/workspace_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hapticut/core/errors.hpp"

namespace hapticut::workspace_map_test {
namespace {

constexpr double kRounding = 1e-12;  // error of a few products of numbers of size 1

Pose pose(const Vec3& rotation, const Vec3& at) { return {rotation_from_vector(rotation), at}; }

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_LT((a.rotation - b.rotation).norm(), kRounding);
  EXPECT_LT((a.translation - b.translation).norm(), kRounding);
}

WorkspaceMapOptions tilted(double scale = 0.5) {
  WorkspaceMapOptions options;
  options.X_WB = pose({0.4, -1.1, 0.3}, {0.02, 0.01, -0.05});
  options.scale = scale;
  options.X_SH = pose({0, 0.2, 0}, {0, 0.01, -0.08});
  return options;
}

const Pose kStylus = pose({0.1, 0.7, -0.3}, {0.03, -0.02, 0.04});
const Pose kElsewhere = pose({-0.6, 0.2, 0.9}, {-0.05, 0.06, 0.01});

TEST(WorkspaceMap, IsThePoseOfTheBaseWhenNothingIsScaledOrClutched) {
  const WorkspaceMapOptions options = tilted(1);
  expect_same(WorkspaceMap(options).to_world(kStylus), options.X_WB * kStylus * options.X_SH);
}

TEST(WorkspaceMap, ScalesTranslationsAndNeitherTurnsNorTheLeverOfTheTool) {
  const WorkspaceMapOptions options = tilted(0.25);
  const WorkspaceMap map(options);
  const Pose X_WH = map.to_world(kStylus);
  EXPECT_LT((X_WH.rotation - (options.X_WB * kStylus * options.X_SH).rotation).norm(), kRounding);
  const Vec3 p_WS = (X_WH * options.X_SH.inverse()).translation;
  EXPECT_LT((p_WS - (options.X_WB.translation + 0.25 * (options.X_WB.rotation * kStylus.translation))).norm(),
            kRounding);
}

TEST(WorkspaceMap, AClutchUsedManyTimesMovesNothing) {
  WorkspaceMap map(tilted());
  for (int n = 0; n < 1000; ++n) {
    const Pose before = map.to_world(kStylus);
    map.disengage(kStylus);
    expect_same(map.to_world(kElsewhere), before);
    map.engage(kElsewhere);
    expect_same(map.to_world(kElsewhere), before);
    const Pose there = map.to_world(kElsewhere);
    map.disengage(kElsewhere);
    map.engage(kStylus);
    expect_same(map.to_world(kStylus), there);
  }
  EXPECT_TRUE(is_rotation(map.to_world(kStylus).rotation, kRounding));
}

TEST(WorkspaceMap, AfterAClutchTheToolFollowsTheHandAsBefore) {
  WorkspaceMap map(tilted());
  map.disengage(kStylus);
  map.engage(kElsewhere);
  const Pose before = map.to_world(kElsewhere);
  const Vec3 step(1e-3, -2e-3, 0.5e-3), rotation(0.02, 0.01, -0.03);
  const Pose moved{rotation_from_vector(rotation) * kElsewhere.rotation, kElsewhere.translation + step};
  const Pose after = map.to_world(moved);
  const Mat3& R_WB = tilted().X_WB.rotation;
  EXPECT_LT((vector_from_rotation(after.rotation * before.rotation.transpose()) - R_WB * rotation).norm(), 1e-10);
  const Vec3 p_before = (before * tilted().X_SH.inverse()).translation;
  const Vec3 p_after = (after * tilted().X_SH.inverse()).translation;
  EXPECT_LT((p_after - p_before - 0.5 * (R_WB * step)).norm(), kRounding);
}

TEST(WorkspaceMap, GivesTheHandNothingWhileTheClutchIsOpen) {
  WorkspaceMap map(tilted());
  map.disengage(kStylus);
  EXPECT_FALSE(map.engaged());
  EXPECT_TRUE(map.to_device(kStylus, {Vec3(1, 2, 3), Vec3(4, 5, 6)}).force.isZero(0));
  EXPECT_TRUE(map.to_world(kStylus, Twist{Vec3(1, 2, 3), Vec3(4, 5, 6)}).linear.isZero(0));
}

TEST(WorkspaceMap, AnotherScaleMovesNothingAndNonsenseIsRefused) {
  WorkspaceMap map(tilted());
  const Pose before = map.to_world(kStylus);
  EXPECT_TRUE(map.set_scale(0.1, kStylus));
  expect_same(map.to_world(kStylus), before);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_FALSE(map.set_scale(bad, kStylus));
  EXPECT_EQ(map.scale(), 0.1);
  WorkspaceMapOptions options;
  options.scale = 0;
  EXPECT_THROW(WorkspaceMap{options}, Error);
  options.scale = 1;
  options.X_WB.rotation *= 2;
  EXPECT_THROW(WorkspaceMap{options}, Error);
}

TEST(WorkspaceMap, PlacesTheToolAtTheGivenPose) {
  WorkspaceMap map(tilted());
  const Pose wanted = pose({1, 0, 0}, {0.1, 0.2, 0.3});
  map.place(kStylus, wanted);
  expect_same(map.to_world(kStylus), wanted);
}

TEST(WorkspaceMap, PreservesPowerWhenTheForceScaleIsTheScale) {
  WorkspaceMapOptions options = tilted(0.3);
  options.force_scale = 0.3;
  WorkspaceMap map(options);
  map.disengage(kStylus);
  map.engage(kElsewhere);
  const Twist hand{Vec3(0.1, -0.2, 0.05), Vec3(1, 2, -0.5)};
  // Rotations are not scaled, so the power of force and of torque is checked separately.
  const Wrench force{Vec3(1, 2, -1), Vec3::Zero()};
  const Wrench torque{Vec3::Zero(), Vec3(0.1, -0.2, 0.3)};
  const auto power = [](const Wrench& w, const Twist& v) { return w.force.dot(v.linear) + w.torque.dot(v.angular); };
  for (const Wrench& tool : {force, torque}) {
    const Twist v_W = map.to_world(kElsewhere, hand);
    EXPECT_NEAR(power(map.to_device(kElsewhere, tool), hand), power(tool, v_W), kRounding);
  }
  EXPECT_NEAR(map.felt_stiffness(1000), 0.09 * 1000, kRounding);
}

TEST(WorkspaceMap, AToolOnADeviceOfThreeDegreesKeepsItsOrientation) {
  WorkspaceMapOptions options = tilted(1);
  options.orientation = false;
  const WorkspaceMap map(options);
  EXPECT_LT((map.to_world(kStylus).rotation - map.to_world(kElsewhere).rotation).norm(), kRounding);
  EXPECT_TRUE(map.to_world(kStylus, Twist{Vec3::Zero(), Vec3(1, 2, 3)}).angular.isZero(0));
}

}  // namespace
}  // namespace hapticut::workspace_map_test
