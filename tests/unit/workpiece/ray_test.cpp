// SPDX-License-Identifier: Apache-2.0
// Rays through a workpiece: Workpiece::first_hit.
#include "hapticut/workpiece/ray.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/workpieces.hpp"

namespace hapticut::ray_test {
namespace {

using test::named;
using units::mm;

constexpr double kVoxels[] = {0.4 * mm, 0.2 * mm, 0.1 * mm};

/// A half space within a ball of 3 mm, with its face at a distance from the origin.
Workpiece half_space(const Vec3& normal, double at, double voxel) {
  const BodyDescription body = {{Vec3::Constant(-3 * mm), Vec3::Constant(3 * mm)},
                                [=](const Vec3& p) { return std::max(normal.dot(p) - at, p.norm() - 2.9 * mm); },
                                [](const Vec3&) { return MaterialId(1); }};
  return build_body(body, voxel, MaterialTable({named("clay")}));
}

constexpr double kAtPlane = 0.15;            // [voxels] as the header says
constexpr double kNormal = 20 * units::deg;  // the slope of a trilinear fill; independent of the voxel size

TEST(Ray, MeetsAPlaneWithinItsAccuracyAtAnyVoxelSize) {
  test::RandomPoses random(11);
  for (const double voxel : kVoxels) {
    double worst = 0, worst_angle = 0;
    for (int n = 0; n < 60; ++n) {
      const Vec3 normal = n < 6 ? Vec3(Vec3::Unit(n % 3) * (n < 3 ? 1 : -1)) : random.direction();
      const double at = random.between(-0.5 * mm, 0.5 * mm);
      const Workpiece workpiece = half_space(normal, at, voxel);
      const Vec3 foot = at * normal;
      for (int m = 0; m < 10; ++m) {
        Vec3 direction = -normal + 0.5 * random.direction();
        direction.normalize();
        const Vec3 target = foot + 0.3 * mm * random.direction().cross(normal), origin = target - 2.5 * mm * direction;
        const std::optional<RayHit> hit = workpiece.first_hit(origin, 7 * direction);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->material, 1);
        EXPECT_LT((hit->point_W - (origin + hit->distance * direction)).norm(), 1e-9 * mm);
        worst = std::max(worst, std::abs(normal.dot(hit->point_W) - at) / voxel);
        worst_angle = std::max(worst_angle, std::acos(std::min(1.0, normal.dot(hit->normal_W))));
      }
    }
    EXPECT_LT(worst, kAtPlane) << voxel;
    EXPECT_GT(worst, 0.02) << "the accuracy above is not far from the truth";
    EXPECT_LT(worst_angle, kNormal) << voxel;
    RecordProperty("worst_in_voxels_at_" + std::to_string(int(voxel / mm * 10)), std::to_string(worst));
  }
}

TEST(Ray, MeetsABallTheMoreExactlyTheSmallerTheVoxels) {
  test::RandomPoses random(12);
  for (const double voxel : kVoxels) {
    const Workpiece ball = build_sphere(Vec3::Zero(), 2 * mm, voxel, named("clay"));
    double worst = 0;
    for (int n = 0; n < 300; ++n) {
      const Vec3 direction = random.direction();
      const std::optional<RayHit> hit = ball.first_hit(-5 * mm * direction, direction);
      ASSERT_TRUE(hit);
      worst = std::max(worst, std::abs(hit->point_W.norm() - 2 * mm));
    }
    EXPECT_LT(worst, kAtPlane * voxel + voxel * voxel / (2 * 2 * mm)) << "with the curvature within a voxel";
  }
}

TEST(Ray, FindsOneMaterialBehindOthers) {
  for (const double voxel : kVoxels) {
    const Workpiece slab =
        build_layered_slab({Vec3(-2, -2, -3) * mm, Vec3(2, 2, 0) * mm}, voxel,
                           {{named("enamel"), 0.77 * mm}, {named("dentin"), 1 * mm}, {named("pulp"), 1 * mm}});
    const Vec3 above(0.1 * mm, 0.13 * mm, 2 * mm), down(0, 0, -1);
    const double kAtBorder = 0.5 * voxel + 1e-9;  // each voxel has one material
    EXPECT_NEAR(slab.first_hit(above, down)->distance, 2 * mm, kAtPlane * voxel);
    EXPECT_EQ(slab.first_hit(above, down)->material, slab.materials().id_of("enamel"));
    for (const auto& [name, depth] : {std::pair{"enamel", 0.0}, {"dentin", 0.77 * mm}, {"pulp", 1.77 * mm}}) {
      const MaterialId id = slab.materials().id_of(name);
      const std::optional<RayHit> hit = slab.first_hit(above, down, std::numeric_limits<double>::infinity(), id);
      ASSERT_TRUE(hit) << name;
      EXPECT_EQ(hit->material, id);
      EXPECT_NEAR(hit->distance, 2 * mm + depth, kAtBorder) << name;
      EXPECT_GT(hit->normal_W.z(), 0.99) << name;
    }
  }
}

TEST(Ray, MeetsNothingBeyondItsLengthOrBesideTheWorkpiece) {
  const Workpiece block = build_block({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.2 * mm, named("clay"));
  const Vec3 above(2 * mm, 2 * mm, 6 * mm), down(0, 0, -1);
  EXPECT_FALSE(block.first_hit(above, down, 1.9 * mm));
  EXPECT_TRUE(block.first_hit(above, down, 2.1 * mm));
  EXPECT_FALSE(block.first_hit(above, -down));
  EXPECT_FALSE(block.first_hit(above, Vec3(1, 0, 0)));
  EXPECT_FALSE(block.first_hit(above, down, 10 * mm, 2)) << "there is no such material";
  EXPECT_TRUE(block.first_hit(above + Vec3(0, 0, 5), down)) << "from far away";
  EXPECT_FALSE(block.first_hit(above, Vec3::Zero()));
  EXPECT_FALSE(block.first_hit(above, down, -1));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(block.first_hit(above, down, nan));
  EXPECT_FALSE(block.first_hit(Vec3(0, nan, 0), down));
  EXPECT_FALSE(block.first_hit(above, Vec3(0, 0, -infinity)));
}

TEST(Ray, BeginsInsideWithADistanceOfZero) {
  const Workpiece block = build_block({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.2 * mm, named("clay"));
  const std::optional<RayHit> hit = block.first_hit(Vec3(2, 2, 2) * mm, Vec3(0, 1, 0));
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->distance, 0);
  EXPECT_EQ(hit->point_W, Vec3(Vec3(2, 2, 2) * mm));
  EXPECT_EQ(hit->normal_W, Vec3(Vec3::Zero()));
  EXPECT_EQ(hit->material, 1);
}

TEST(Ray, GoesIntoAHoleThatWasCut) {
  Workpiece block = build_block({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.2 * mm, named("clay"));
  block.reserve_blocks(64);
  for (int i = 8; i < 12; ++i)
    for (int j = 8; j < 12; ++j)
      for (int k = 5; k < 20; ++k) ASSERT_TRUE(test::cut_voxel(block, {i, j, k}));
  const double depth = block.first_hit(Vec3(2 * mm, 2 * mm, 6 * mm), Vec3(0, 0, -1))->distance;
  EXPECT_NEAR(depth, 5 * mm, 1e-9) << "the floor of the hole is at 1 mm";
  EXPECT_NEAR(block.first_hit(Vec3(2 * mm, 2 * mm, 3 * mm), Vec3(1, 0, 0))->distance, 0.4 * mm, 1e-9) << "its wall";
}

/// The fill between the centres of voxels.
double trilinear(const Workpiece& workpiece, const Vec3& p_W) {
  const Vec3 u = workpiece.frame().X_WV.inverse() * p_W / workpiece.voxel_size();
  double sum = 0;
  for (int n = 0; n < 8; ++n) {
    VoxelIndex at;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const int bit = n >> axis & 1;
      const double low = std::floor(u[axis]);
      at[std::size_t(axis)] = int(low) + bit;
      weight *= bit != 0 ? u[axis] - low : 1 - (u[axis] - low);
    }
    sum += weight * workpiece.fill_at(at);
  }
  return sum;
}

TEST(Ray, IsNeverBehindTheFirstOfSmallStepsAndNeverInTheAir) {
  test::RandomPoses random(13);
  const Workpiece ball = build_sphere(Vec3(0.3, -0.2, 0.1) * mm, 2 * mm, 0.3 * mm, named("clay"));
  constexpr double kStep = 2e-6;  // [m]
  int hits = 0;
  for (int n = 0; n < 200; ++n) {
    const Vec3 origin = 4 * mm * random.direction(), direction = (random.vector(2 * mm) - origin).normalized();
    double stepped = -1;
    for (double t = 0; t < 8 * mm && stepped < 0; t += kStep)
      if (trilinear(ball, origin + t * direction) >= 0.5) stepped = t;
    const std::optional<RayHit> hit = ball.first_hit(origin, direction);
    if (!hit) {
      EXPECT_LT(stepped, 0);
      continue;
    }
    ++hits;
    EXPECT_NEAR(trilinear(ball, hit->point_W), 0.5, 1e-6);
    if (stepped >= 0) {
      EXPECT_LE(hit->distance, stepped + 1e-12);
    }
    for (double t = 0; t < hit->distance - 1e-9; t += 10 * kStep)
      ASSERT_LT(trilinear(ball, origin + t * direction), 0.5) << "the first place, not a later one";
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace hapticut::ray_test
