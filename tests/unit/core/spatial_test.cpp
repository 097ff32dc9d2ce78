// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/spatial.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::spatial_test {
namespace {

using test::RandomPoses;
using units::kPi;

TEST(RotationFromVector, RotatesAboutTheVectorByItsLength) {
  RandomPoses random(1);
  for (int n = 0; n < 200; ++n) {
    const Vec3 axis = random.direction();
    const double angle = random.between(0, 2 * kPi);
    const Mat3 expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_LT((rotation_from_vector(angle * axis) - expected).norm(), 1e-14);
  }
}

TEST(RotationFromVector, IsTheFirstOrderRotationForTinyAngles) {
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-9, 9e-7, 1.1e-6}) {
    const Mat3 rotation = rotation_from_vector(angle * Vec3(0, 0, 1));
    EXPECT_NEAR(rotation(1, 0), std::sin(angle), 1e-16 * angle + 1e-300);
    EXPECT_NEAR(rotation(0, 0), std::cos(angle), 1e-16);
    EXPECT_TRUE(is_rotation(rotation, 1e-15));
  }
}

// The vector survives the round trip. At exactly pi its sign is arbitrary. Near pi its accuracy is limited by the
// rounding of the matrix, whose antisymmetric part is as small as the distance from pi.
TEST(VectorFromRotation, UndoesRotationFromVectorUpTo180Degrees) {
  RandomPoses random(2);
  for (const double angle : {1e-12, 1e-8, 1e-6, 1e-3, 0.5, 1.5, 3.0, kPi - 1e-3, kPi - 1e-5, kPi - 1e-6})
    for (int n = 0; n < 50; ++n) {
      const Vec3 v = angle * random.direction();
      const Vec3 back = vector_from_rotation(rotation_from_vector(v));
      const double tolerance = 1e-14 + 1e-15 / std::max(kPi - angle, 1e-15);
      EXPECT_LT((back - v).norm(), std::max(tolerance * angle, 1e-16)) << "angle " << angle;
    }
}

TEST(VectorFromRotation, GivesARotationBackAt180DegreesAndBeyond) {
  RandomPoses random(3);
  for (const double angle : {kPi - 1e-7, kPi - 1e-8, kPi - 1e-12, kPi, kPi + 1e-8, 4.0, 6.0})
    for (int n = 0; n < 50; ++n) {
      const Mat3 rotation = rotation_from_vector(angle * random.direction());
      const Vec3 v = vector_from_rotation(rotation);
      EXPECT_LE(v.norm(), kPi + 1e-15);
      EXPECT_LT((rotation_from_vector(v) - rotation).norm(), 1e-8) << "angle " << angle;
    }
}

TEST(VectorFromRotation, FindsEveryAxisAt180Degrees) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.8, 0), Vec3(0, -0.6, 0.8)}) {
    const Mat3 half_rotation = 2 * axis * axis.transpose() - Mat3::Identity();
    const Vec3 v = vector_from_rotation(half_rotation);
    EXPECT_NEAR(v.norm(), kPi, 1e-12);
    EXPECT_NEAR(std::abs(v.normalized().dot(axis)), 1, 1e-12);
  }
}

TEST(Pose, InverseUndoesAndCompositionIsThatOfPoints) {
  RandomPoses random(4);
  for (int n = 0; n < 100; ++n) {
    const Pose a = {random.rotation(), random.vector(1)}, b = {random.rotation(), random.vector(1)};
    const Vec3 p = random.vector(1);
    EXPECT_LT((a.inverse() * (a * p) - p).norm(), 1e-14);
    EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-14);
  }
}

TEST(TwistBetween, TakesOnePoseToTheOther) {
  RandomPoses random(5);
  for (int n = 0; n < 100; ++n) {
    const Pose from = {random.rotation(), random.vector(1)};
    const Pose to = {rotation_from_vector(random.vector(3)) * from.rotation, random.vector(1)};
    const double dt = random.between(1e-4, 1);
    const Pose there = advance(from, twist_between(from, to, dt), dt);
    EXPECT_LT((there.rotation - to.rotation).norm(), 1e-13);
    EXPECT_LT((there.translation - to.translation).norm(), 1e-14);
  }
}

TEST(Transport, KeepsThePower) {
  RandomPoses random(6);
  for (int n = 0; n < 100; ++n) {
    const Wrench wrench_P = {random.vector(10), random.vector(1)};
    const Twist twist_P = {random.vector(1), random.vector(10)};
    const Vec3 p_PQ = random.vector(0.5);
    const Wrench wrench_Q = transport(wrench_P, -p_PQ);
    const Twist twist_Q = transport(twist_P, p_PQ);
    EXPECT_NEAR(wrench_Q.force.dot(twist_Q.linear) + wrench_Q.torque.dot(twist_Q.angular),
                wrench_P.force.dot(twist_P.linear) + wrench_P.torque.dot(twist_P.angular), 1e-13);
  }
}

TEST(Transport, MovesAForceWithItsLever) {
  const Wrench at_p = {Vec3(0, 0, 2), Vec3::Zero()};
  // P lies at x = 3 as seen from Q: a force along +z there has a torque about -y.
  EXPECT_EQ(transport(at_p, Vec3(3, 0, 0)).torque, Vec3(0, -6, 0));
}

TEST(Orthonormalized, FindsTheRotationOfANoisyMatrix) {
  RandomPoses random(7);
  for (int n = 0; n < 100; ++n) {
    const Mat3 meant = random.rotation();
    Mat3 noise;
    for (int i = 0; i < 9; ++i) noise(i) = random.between(-1e-3, 1e-3);
    const Mat3 found = orthonormalized(meant + noise);
    EXPECT_TRUE(is_rotation(found, 1e-14));
    EXPECT_LT((found - meant).norm(), 3.1e-3);
    // the nearest rotation: the remaining difference to the noisy matrix is symmetric in the frame of the rotation
    const Mat3 rest = found.transpose() * (meant + noise);
    EXPECT_LT((rest - rest.transpose()).norm(), 1e-14);
  }
}

TEST(IsRotation, KnowsRotationsFromOtherMatrices) {
  const Mat3 rotation = rotation_from_vector(Vec3(0.3, 0.2, -1));
  EXPECT_TRUE(is_rotation(rotation, 1e-14));
  EXPECT_FALSE(is_rotation(-rotation, 1e-3));        // a mirror
  EXPECT_FALSE(is_rotation(1.01 * rotation, 1e-3));  // scaled
  EXPECT_FALSE(is_rotation(Mat3::Zero(), 1e-3));     // nothing
  Mat3 sheared = rotation;
  sheared(0, 1) += 0.01;
  EXPECT_FALSE(is_rotation(sheared, 1e-3));
  EXPECT_FALSE(is_rotation(Mat3::Constant(std::numeric_limits<double>::quiet_NaN()), 1e-3));
}

}  // namespace
}  // namespace hapticut::spatial_test
