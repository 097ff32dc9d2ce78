// SPDX-License-Identifier: Apache-2.0
// The distance between the head and what is left of a material: Simulation::distance_to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/random_pose.hpp"
#include "experiments/setup/static_contact.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/contact/cut_voxel.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "support/named_material.hpp"

namespace hapticut::distance_test {
namespace {

using test::named;
using units::deg;
using units::mm;

constexpr double kVoxels[] = {0.4 * mm, 0.2 * mm, 0.1 * mm};
constexpr double kAccuracy = 0.2;  // [voxels] as the header says
constexpr double kFar = std::numeric_limits<double>::infinity();

Simulation with(Workpiece workpiece, const ToolHead& head) {
  return {std::move(workpiece), test::tool_of(head), test::static_config()};
}

/// A block whose upper face is z = 0.
Workpiece block(double voxel) { return build_block({Vec3(-3, -3, -2) * mm, Vec3(3, 3, 0) * mm}, voxel, named("clay")); }

/// The closed form of a distance, for a head above the plane z = 0.
struct AbovePlane {
  const char* name;
  ToolHead head;
  Mat3 R_WT;
  double lowest;  ///< [m] z of the head's lowest point, from To
};

void PrintTo(const AbovePlane& above, std::ostream* out) { *out << above.name; }

Mat3 tilted(double angle) { return Eigen::AngleAxisd(angle, Vec3(0.6, 0.8, 0)).toRotationMatrix(); }

std::vector<AbovePlane> above_plane() {
  const double R = 0.8 * mm, H = 2 * mm, a = 30 * deg;
  const ToolHead round_end = round_end_cylinder_head(2 * R, H);
  return {{"Ball", SphereHead{R}, Mat3::Identity(), -R},
          {"FlatUpright", FlatHead{R, H}, Mat3::Identity(), 0},
          {"FlatTilted", FlatHead{R, H}, tilted(25 * deg), -R * std::sin(25 * deg)},
          {"FlatLying", FlatHead{R, H}, tilted(90 * deg), -R},
          {"ConeUpright", ConeHead{a, H}, Mat3::Identity(), 0},
          {"ConeOnItsSide", ConeHead{a, H}, tilted(100 * deg),
           H * std::cos(100 * deg) - H * std::tan(a) * std::sin(100 * deg)},
          {"RoundEnd", round_end, Mat3::Identity(), round_end.bounding_box().min.z()}};
}

class Distance : public testing::TestWithParam<AbovePlane> {};

TEST_P(Distance, FromAPlaneIsTheClosedFormWithinAFifthOfAVoxel) {
  const AbovePlane& above = GetParam();
  for (const double voxel : kVoxels) {
    const Simulation simulation = with(block(voxel), above.head);
    double worst = 0;
    for (int n = 0; n < 40; ++n) {
      const double gap = (0.1 + 0.05 * n) * mm + kAccuracy * voxel;
      const Pose X_WT{above.R_WT, Vec3(0.017 * n * mm, -0.023 * n * mm, gap - above.lowest)};
      worst = std::max(worst, std::abs(simulation.distance_to(1, X_WT) - gap));
    }
    EXPECT_LT(worst / voxel, kAccuracy) << voxel / mm << " mm";
    RecordProperty("worst_in_voxels_at_" + std::to_string(int(std::lround(voxel / mm * 10))),
                   std::to_string(worst / voxel));
  }
}

INSTANTIATE_TEST_SUITE_P(Heads, Distance, testing::ValuesIn(above_plane()),
                         [](const auto& above) { return std::string(above.param.name); });

TEST(Distance, OfABallFromABallAndFromATiltedPlaneConvergesWithTheVoxelSize) {
  test::RandomPoses random(21);
  double last = kFar;
  for (const double voxel : kVoxels) {
    const Simulation from_ball = with(build_sphere(Vec3::Zero(), 2 * mm, voxel, named("clay")), SphereHead{0.7 * mm});
    double worst = 0;
    for (int n = 0; n < 200; ++n) {
      const double gap = random.between(kAccuracy * voxel, 4 * mm);
      const Vec3 center = (2.7 * mm + gap) * random.direction();
      worst = std::max(worst, std::abs(from_ball.distance_to(1, Pose::from_translation(center)) - gap));
    }
    for (int n = 0; n < 20; ++n) {
      const Vec3 normal = random.direction();
      const BodyDescription half = {{Vec3::Constant(-3 * mm), Vec3::Constant(3 * mm)},
                                    [&](const Vec3& p) { return std::max(normal.dot(p), p.norm() - 2.9 * mm); },
                                    [](const Vec3&) { return MaterialId(1); }};
      const Simulation from_plane = with(build_body(half, voxel, MaterialTable({named("clay")})), SphereHead{0.7 * mm});
      for (int m = 0; m < 10; ++m) {
        const double gap = random.between(kAccuracy * voxel, 1.5 * mm);
        const Vec3 center = (0.7 * mm + gap) * normal + 0.5 * mm * random.direction().cross(normal);
        worst = std::max(worst, std::abs(from_plane.distance_to(1, Pose::from_translation(center)) - gap));
      }
    }
    EXPECT_LT(worst, kAccuracy * voxel) << voxel / mm << " mm";
    EXPECT_LT(worst, 0.75 * last) << "a smaller voxel has a smaller error";
    last = worst;
  }
}

/// [m] The smallest gap of all voxels of a material below a ball, voxel by voxel.
double smallest_gap(const Simulation& simulation, MaterialId material, const Vec3& center, double radius) {
  const Workpiece& workpiece = simulation.workpiece();
  const double size = workpiece.voxel_size();
  double smallest = kFar;
  for_each_voxel(workpiece.bounds(), [&](const VoxelIndex& at) {
    const MaterialId id = workpiece.material_at(at);
    if (id == kEmpty || (material != kEmpty && id != material)) return;
    const Vec3 from = workpiece.frame().center(at) - center;
    const Vec3 n_V = workpiece.frame().X_WV.rotation.transpose() * from / from.norm();
    const VoxelSection<double> section(n_V.cwiseAbs().maxCoeff(), VoxelSection<double>::kMinStandingWidth);
    const double height = section.height_of(workpiece.fill_at(at));
    smallest = std::min(smallest, from.norm() - radius - size * (height - section.span() / 2));
  });
  return std::max(0.0, smallest);
}

TEST(Distance, IsThatOfTheNearestOfAllVoxelsOfTheMaterial) {
  constexpr double kRadius = 0.8 * mm;
  const Simulation simulation = with(build_molar(0.4 * mm), SphereHead{kRadius});
  test::RandomPoses random(22);
  int touching = 0;
  for (int n = 0; n < 40; ++n) {
    const Vec3 center = Vec3(0, 0, -2) * mm + random.vector(14 * mm);
    for (const MaterialId material : {kEmpty, kMolarEnamel, kMolarDentin, kMolarPulp}) {
      const double distance = simulation.distance_to(material, Pose::from_translation(center));
      EXPECT_NEAR(distance, smallest_gap(simulation, material, center, kRadius), 1e-12) << n << " " << int(material);
      touching += distance == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(touching, 20);
}

TEST(Distance, OfABallIsZeroExactlyWhereTheContactBegins) {
  const Simulation simulation = with(build_molar(0.3 * mm), SphereHead{0.8 * mm});
  test::RandomPoses random(23);
  int touching = 0;
  constexpr int kPoses = 400;
  for (int n = 0; n < kPoses; ++n) {
    const Pose X_WH{random.rotation(), Vec3(0, 0, 2) * mm + random.vector(9 * mm)};
    const bool touches = simulation.touches(X_WH);
    EXPECT_EQ(simulation.distance_to(kEmpty, X_WH) == 0, touches) << n;
    touching += touches ? 1 : 0;
  }
  EXPECT_GT(touching, kPoses / 10);
  EXPECT_LT(touching, kPoses * 9 / 10);
}

TEST(Distance, OfEachHeadIsSmallWhereItBeginsToTouch) {
  // At an edge or a point of a head, the contact begins up to this much before the head's surface is there.
  constexpr double kAtEdges = 1.5;  // [voxels]
  const double voxel = 0.2 * mm;
  test::RandomPoses random(24);
  for (const HeadShape& shape : head_shapes()) {
    const Simulation simulation = with(build_sphere(Vec3::Zero(), 3 * mm, voxel, named("clay")), shape.usual());
    for (int n = 0; n < 60; ++n) {
      const Pose X_WH{random.rotation(), random.vector(9 * mm)};
      const double distance = simulation.distance_to(1, X_WH);
      if (distance > kAtEdges * voxel) {
        EXPECT_FALSE(simulation.touches(X_WH)) << shape.name << " " << distance / voxel;
      }
      if (distance == 0) {
        EXPECT_TRUE(simulation.touches(X_WH)) << shape.name;
      }
    }
  }
}

TEST(Distance, LooksThroughOtherMaterialsUntilNothingIsLeft) {
  const double voxel = 0.2 * mm;
  Workpiece slab = build_layered_slab({Vec3(-2, -2, -3) * mm, Vec3(2, 2, 0) * mm}, voxel,
                                      {{named("enamel"), 1 * mm}, {named("dentin"), 1 * mm}, {named("pulp"), 1 * mm}});
  Simulation simulation = with(std::move(slab), SphereHead{0.5 * mm});
  const Pose X_WH = Pose::from_translation(Vec3(0.03, 0.02, 0.8) * mm);
  for (const auto& [material, distance] :
       {std::pair{kEmpty, 0.3 * mm}, {MaterialId(1), 0.3 * mm}, {MaterialId(2), 1.3 * mm}, {MaterialId(3), 2.3 * mm}})
    EXPECT_NEAR(simulation.distance_to(material, X_WH), distance, kAccuracy * voxel) << int(material);
  EXPECT_EQ(simulation.distance_to(4, X_WH), kFar) << "there is no such material";
  EXPECT_EQ(simulation.distance_to(3, X_WH, 2.2 * mm), kFar) << "beyond the limit";
  EXPECT_NEAR(simulation.distance_to(3, X_WH, 2.4 * mm), 2.3 * mm, kAccuracy * voxel);
  EXPECT_EQ(simulation.distance_to(1, Pose::from_translation(Vec3(0, 0, -0.5) * mm)), 0) << "inside";
  EXPECT_NEAR(simulation.distance_to(1, Pose::from_translation(Vec3(0, 0, 2))), 2 - 0.5 * mm, kAccuracy * voxel)
      << "from afar";

  simulation.reserve_blocks(4096);
  for_each_block_origin(simulation.first_bounds(), [&](const VoxelIndex& origin) {
    BlockVoxels pulp{origin, {}};
    const BlockView block = simulation.workpiece().block(origin);
    for (int n = 0; n < kBlockVoxels; ++n)
      if (block.material_of(n) == 3) pulp.voxels.add(n);
    if (!pulp.voxels.empty()) {
      ASSERT_TRUE(simulation.remove_voxels(pulp));
    }
  });
  EXPECT_EQ(simulation.distance_to(3, X_WH), kFar) << "all of it was removed";
  EXPECT_NEAR(simulation.distance_to(2, X_WH), 1.3 * mm, kAccuracy * voxel);
}

TEST(Distance, GrowsAsMaterialIsCutAndStepsStayAsTheyAre) {
  SimulationConfig config;
  Simulation asked(test::plain_block(), test::tool_of(SphereHead{test::kRadius}, test::kSpin), config);
  Simulation plain(test::plain_block(), test::tool_of(SphereHead{test::kRadius}, test::kSpin), config);
  const Pose high = Pose::from_translation(Vec3(0, 0, 1.5) * mm);
  const double before = asked.distance_to(1, high);
  EXPECT_NEAR(before, 0.5 * mm, kAccuracy * test::kVoxel);
  for (int n = 0; n < 300; ++n) {
    const Pose X_WH = Pose::from_translation(Vec3(0, 0, test::kRadius - test::kFeed * n * test::kTick));
    const Twist down{Vec3(0, 0, -test::kFeed), Vec3::Zero()};
    const StepResult& result = asked.step(X_WH, down, test::kTick);
    (void)asked.distance_to(1, high);
    const StepResult& same = plain.step(X_WH, down, test::kTick);
    ASSERT_EQ(result.force, same.force);
    ASSERT_EQ(result.removed_volume, same.removed_volume);
  }
  EXPECT_GT(asked.distance_to(1, high), before + 0.02 * mm) << "the ball has cut a dent";
  EXPECT_EQ(asked.workpiece().hash(), plain.workpiece().hash());
}

TEST(Distance, AtABorderOfTwoMaterialsIsWithinAVoxel) {
  constexpr double kTooSmall = 0.75, kTooLarge = 0.4, kR = 0.8 * mm;  // [voxels] as the header says; radius
  test::RandomPoses random(23);
  for (const double voxel : kVoxels) {
    double low = kFar, high = -kFar;  // [voxels]
    for (int n = 0; n < 30; ++n) {
      const Vec3 normal = n < 3 ? Vec3(Vec3::Unit(n)) : random.direction();
      const double at = random.between(-0.5 * mm, 0.5 * mm);
      const BodyDescription ball = {{Vec3::Constant(-3 * mm), Vec3::Constant(3 * mm)},
                                    [](const Vec3& p) { return p.norm() - 2.9 * mm; },
                                    [=](const Vec3& p) { return MaterialId(normal.dot(p) < at ? 1 : 2); }};
      const Simulation simulation =
          with(build_body(ball, voxel, MaterialTable({named("pulp"), named("dentin")})), SphereHead{kR});
      for (int m = 0; m < 10; ++m) {
        const double gap = random.between(0.3 * mm, 0.9 * mm);
        const Vec3 along = 0.2 * mm * random.direction().cross(normal);
        const Pose X_WH = Pose::from_translation(along + (at + kR + gap) * normal);
        const double error = (simulation.distance_to(1, X_WH) - gap) / voxel;
        low = std::min(low, error), high = std::max(high, error);
      }
    }
    EXPECT_GT(low, -kTooSmall) << voxel;
    EXPECT_LT(high, kTooLarge) << voxel;
    EXPECT_LT(low, -0.5) << "the bound above is not far from the truth";
  }
}

TEST(Distance, OfAPoseThatIsNoneIsNotANumber) {
  const Simulation simulation = with(block(0.4 * mm), SphereHead{0.8 * mm});
  Pose mirrored;
  mirrored.rotation(0, 0) = -1;
  EXPECT_TRUE(std::isnan(simulation.distance_to(1, mirrored)));
  EXPECT_TRUE(std::isnan(simulation.distance_to(1, Pose::from_translation(Vec3(0, 0, kFar)))));
  EXPECT_TRUE(std::isnan(simulation.distance_to(1, Pose{}, std::nan(""))));
}

}  // namespace
}  // namespace hapticut::distance_test
