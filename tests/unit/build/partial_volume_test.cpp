// SPDX-License-Identifier: Apache-2.0
// Grey values at the border of a body, where a scanner has mixed both sides.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/core/units.hpp"
#include "support/volumes.hpp"
#include "support/workpieces.hpp"

namespace hapticut::partial_volume_test {
namespace {

using test::named;
using units::kPi;
using units::mm;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Vec3 kMiddle = Vec3(7.03, 6.98, 7.01) * mm;

/// A ball with the value 1, blurred by a Gaussian: the convolution in closed form.
double blurred_ball(double r, double radius, double sigma) {
  const double s = std::sqrt(2.0) * sigma, near = (r - radius) / s, far = (r + radius) / s;
  return (std::erf(far) - std::erf(near)) / 2 -
         sigma / (r * std::sqrt(2 * kPi)) * (std::exp(-near * near) - std::exp(-far * far));
}

/// A ball of layers, which are listed from the outside to the inside.
struct Ball {
  struct Layer {
    double radius, grey;
  };
  double around;  ///< grey value
  std::vector<Layer> layers;
};

GreyVolume scan(const Ball& ball, double spacing, double sigma, double noise = 0) {
  const int n = int(14 * mm / spacing);
  auto volume = test::volume_of<float>({n, n, n}, Vec3::Constant(spacing), {});
  std::mt19937 random(3);
  std::normal_distribution<double> grain(0, 1);
  test::for_each_sample(volume, [&](int i, int j, int k) {
    const double r = (volume.position(i, j, k) - kMiddle).norm();
    double grey = ball.around, before = grey;
    for (const Ball::Layer& layer : ball.layers) {
      grey += (layer.grey - before) * blurred_ball(r, layer.radius, sigma);
      before = layer.grey;
    }
    volume.at(i, j, k) = float(grey + noise * grain(random));
  });
  return volume;
}

constexpr double kAir = -1000, kMarrow = 0, kSoft = 450, kHard = 1600;
constexpr double kBone = (kAir + kHard) / 2, kCortical = (kSoft + kHard) / 2;  // half-way, where the blurred edges are
std::vector<GreyRange> bone_from(double grey) {
  return {{grey, kCortical, named("trabecular")}, {kCortical, kInfinity, named("cortical")}};
}
const std::vector<GreyRange> kRanges = bone_from(kBone);
constexpr MaterialId kTrabecularId = 1, kCorticalId = 2;

double ball_volume(double r) { return 4 * kPi / 3 * r * r * r; }

/// Number of voxels of a material with a centre between two distances from the middle.
int voxels_between(const Workpiece& workpiece, double from, double to, MaterialId material) {
  int count = 0;
  for_each_voxel(workpiece.bounds(), [&](const VoxelIndex& at) {
    const double r = (workpiece.frame().center(at) - kMiddle).norm();
    count += r >= from && r < to && workpiece.material_at(at) == material ? 1 : 0;
  });
  return count;
}

// A cortical shell of four samples over trabecular bone.
class PartialVolumeOfAShell : public testing::TestWithParam<std::tuple<double, double, double>> {};

TEST_P(PartialVolumeOfAShell, IsThatOfTheShell) {
  const auto [spacing_mm, sigma, noise] = GetParam();
  const double spacing = spacing_mm * mm, outer = 6 * mm, inner = outer - 4 * spacing;
  const GreyVolume volume = scan({kAir, {{outer, kHard}, {inner, kSoft}}}, spacing, sigma * spacing, noise);
  const auto amounts = build_from_grey(volume, kRanges).amounts();
  const auto by_threshold = build_from_grey(volume, kRanges, {.partial_volume = false}).amounts();
  const double core = ball_volume(inner), shell = ball_volume(outer) - core;
  constexpr double kShell = 0.02, kCore = 0.06;  // a voxel at their blurred boundary has only one material
  EXPECT_NEAR(amounts[0].volume / core, 1, kCore);
  EXPECT_NEAR(amounts[1].volume / shell, 1, kShell);
  EXPECT_LT(by_threshold[1].volume / shell, 0.9);
  EXPECT_DOUBLE_EQ(amounts[0].volume + amounts[1].volume, by_threshold[0].volume + by_threshold[1].volume);
}

INSTANTIATE_TEST_SUITE_P(SpacingBlurNoise, PartialVolumeOfAShell,
                         testing::Combine(testing::Values(0.15, 0.3, 0.6), testing::Values(0.5, 0.8),
                                          testing::Values(0.0, 60.0)));

TEST(PartialVolume, ChangesNeitherFillNorCentroid) {
  const GreyVolume volume = scan({kAir, {{6 * mm, kHard}, {5 * mm, kSoft}}}, 0.6 * mm, 0.3 * mm);
  const Workpiece on = build_from_grey(volume, kRanges, {.voxel_size = 0.25 * mm});
  const Workpiece off = build_from_grey(volume, kRanges, {.voxel_size = 0.25 * mm, .partial_volume = false});
  for_each_voxel(off.bounds(), [&](const VoxelIndex& at) {
    ASSERT_EQ(on.fill_at(at), off.fill_at(at));
    ASSERT_EQ(on.centroid_at(at).steps, off.centroid_at(at).steps);
  });
}

TEST(PartialVolume, SwitchedOffLeavesEachSampleTheMaterialOfItsValue) {
  const GreyVolume volume = scan({kAir, {{6 * mm, kHard}, {5 * mm, kSoft}}}, 0.6 * mm, 0.3 * mm);
  const Workpiece off = build_from_grey(volume, kRanges, {.antialias = false, .partial_volume = false});
  test::for_each_sample(volume, [&](int i, int j, int k) {
    const double grey = double(volume.at(i, j, k));
    ASSERT_EQ(off.material_at({i, j, k}), grey < kBone ? kEmpty : grey < kCortical ? kTrabecularId : kCorticalId);
  });
}

TEST(PartialVolume, IsAppliedInBlocksWithinOneRangeToo) {
  // The blur of about two samples puts a whole cell of samples into the trabecular range. A sample spans 24 voxels.
  const GreyVolume volume = scan({kAir, {{5.45 * mm, kHard}}}, 0.6 * mm, 1.1 * mm);
  const VolumeBuildOptions fine{.voxel_size = 0.025 * mm, .crop = Box{Vec3(6.5, 6.5, 9) * mm, Vec3(7.5, 7.5, 14) * mm}};
  EXPECT_EQ(build_from_grey(volume, kRanges, fine).amounts()[0].voxels, 0);
}

TEST(PartialVolume, LeavesTrabecularBoneThatIsOpenToTheAir) {
  const GreyVolume volume = scan({kAir, {{6 * mm, kSoft}}}, 0.3 * mm, 0.2 * mm, 60);
  const Workpiece bone = build_from_grey(volume, bone_from(-275));
  EXPECT_EQ(bone.amounts()[1].voxels, 0);
  EXPECT_NEAR(bone.amounts()[0].volume / ball_volume(6 * mm), 1, 0.01);
}

TEST(PartialVolume, LeavesALayerOfTrabecularBoneThatTheScanResolves) {
  constexpr double kSpacing = 0.3 * mm, kLayer = 3 * kSpacing;
  const GreyVolume volume = scan({kAir, {{6 * mm, kSoft}, {6 * mm - kLayer, kHard}}}, kSpacing, 0.5 * kSpacing);
  const auto amounts = build_from_grey(volume, bone_from(-275)).amounts();
  EXPECT_NEAR(amounts[1].volume / ball_volume(6 * mm - kLayer), 1, 0.02);
}

TEST(PartialVolume, AtAHoleIsTheMaterialAroundIt) {
  const auto wall = [&](double grey) {
    const GreyVolume volume = scan({kHard, {{6 * mm, grey}, {2 * mm, kMarrow}}}, 0.3 * mm, 0.2 * mm);
    return build_from_grey(volume, bone_from(kMarrow + 150));
  };
  EXPECT_EQ(voxels_between(wall(kSoft), 0, 5 * mm, kCorticalId), 0);
  EXPECT_EQ(voxels_between(wall(kHard), 0, 5 * mm, kTrabecularId), 0);
}

TEST(PartialVolume, LeavesTheBordersInsideATooth) {
  constexpr double kPulp = 50, kDentin = 1500, kEnamel = 2600, kJunction = 5 * mm, kChamber = 2 * mm;
  const std::vector<GreyRange> ranges = {{750, 2050, named("dentin")}, {2050, kInfinity, named("enamel")}};
  const GreyVolume volume =
      scan({kAir, {{6 * mm, kEnamel}, {kJunction, kDentin}, {kChamber, kPulp}}}, 0.2 * mm, 0.15 * mm);
  const Workpiece on = build_from_grey(volume, ranges),
                  off = build_from_grey(volume, ranges, {.partial_volume = false});
  constexpr MaterialId kDentinId = 1, kEnamelId = 2;
  EXPECT_GT(voxels_between(off, 5.7 * mm, 7 * mm, kDentinId), 1000);
  EXPECT_EQ(voxels_between(on, 5.7 * mm, 7 * mm, kDentinId), 0);
  EXPECT_EQ(voxels_between(on, 0, 5.5 * mm, kEnamelId), voxels_between(off, 0, 5.5 * mm, kEnamelId));
  EXPECT_EQ(voxels_between(on, 0, 5.5 * mm, kDentinId), voxels_between(off, 0, 5.5 * mm, kDentinId));
}

TEST(PartialVolume, OfAGradeIsOfTheGradeBehindIt) {
  const GreyVolume volume = scan({kAir, {{6 * mm, kHard}}}, 0.3 * mm, 0.2 * mm);
  const Grade grade{.low = kBone, .high = kHard, .at_low = named("soft"), .at_high = named("hard"), .steps = 10};
  const auto softer = [&](bool on) {
    double volume_softer = 0;
    for (const MaterialAmount& amount : build_from_grey(volume, grade, {.partial_volume = on}).amounts())
      if (amount.material < 8) volume_softer += amount.volume;
    return volume_softer / ball_volume(6 * mm);
  };
  EXPECT_GT(softer(false), 0.05);
  EXPECT_LT(softer(true), 0.001);
}

TEST(PartialVolume, DoesNotAffectLabels) {
  auto volume = test::volume_of<std::uint16_t>({20, 20, 20}, LabelVolume{}.spacing, {});
  for (std::size_t n = 0; n < volume.size(); ++n) volume.values[n] = std::uint16_t(n / 7 % 3);
  const std::vector<LabelMaterial> materials = {{{1}, named("a")}, {{2}, named("b")}};
  const auto amounts = [&](bool partial_volume) {
    return build_from_labels(
               volume, materials,
               {.voxel_size = 0.7 * mm, .partial_volume = partial_volume, .warn = [](const std::string&) {}})
        .amounts();
  };
  const auto on = amounts(true), off = amounts(false);
  for (std::size_t n = 0; n < 2; ++n) EXPECT_EQ(on[n].volume, off[n].volume);
}

}  // namespace
}  // namespace hapticut::partial_volume_test
