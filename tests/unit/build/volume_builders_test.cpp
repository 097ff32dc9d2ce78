// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/volume_builders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/refusal.hpp"
#include "support/volumes.hpp"
#include "support/workpieces.hpp"

namespace hapticut::volume_builders_test {
namespace {

using test::named;
using units::kPi;
using units::mm;

/// A volume of zeros whose axes are those of W.
template <class Value>
Volume<Value> volume_of(std::array<int, 3> dims, const Vec3& spacing) {
  return test::volume_of<Value>(dims, spacing, {});
}

/// A volume whose grey value at each sample is a function of its position in its own frame.
template <class Function>
GreyVolume grey_field(std::array<int, 3> dims, const Vec3& spacing, const Function& value) {
  auto volume = volume_of<float>(dims, spacing);
  test::for_each_sample(volume, [&](int i, int j, int k) {
    volume.at(i, j, k) = float(value(Vec3(i, j, k).cwiseProduct(spacing).eval()));
  });
  return volume;
}

LabelVolume random_labels(std::array<int, 3> dims, int labels) {
  auto volume = volume_of<std::uint16_t>(dims, Vec3::Constant(0.2 * mm));
  std::mt19937 random(42);
  for (auto& value : volume.values) value = std::uint16_t(random() % unsigned(labels));
  return volume;
}

/// Sum of filled volumes and the centre of all filled parts, in W.
struct Moments {
  double volume = 0;
  Vec3 center = Vec3::Zero();
};
Moments moments_of(const Workpiece& workpiece) {
  Moments m;
  const double h = workpiece.voxel_size();
  for_each_voxel(workpiece.bounds(), [&](const VoxelIndex& at) {
    const double part = workpiece.fill_at(at) * h * h * h;
    if (part == 0) return;
    const Vec3 p_VC = h * (Vec3(at[0], at[1], at[2]) + test::centroid_of(workpiece, at));
    m.volume += part;
    m.center += part * (workpiece.frame().X_WV * p_VC);
  });
  m.center /= m.volume;
  return m;
}

TEST(BuildFromLabels, MapsIsotropicSamplesOneToOne) {
  const LabelVolume volume = random_labels({19, 11, 26}, 3);
  const Workpiece workpiece = build_from_labels(volume, {{{1}, named("a")}, {{2}, named("b")}});
  std::array<std::int64_t, 3> count{};
  test::for_each_sample(volume, [&](int i, int j, int k) {
    const auto label = volume.at(i, j, k);
    ++count[label];
    ASSERT_EQ(workpiece.material_at({i, j, k}), label);
    ASSERT_EQ(workpiece.fill_at({i, j, k}), label != 0 ? 1 : 0);
  });
  for (const MaterialAmount& amount : workpiece.amounts()) {
    EXPECT_EQ(amount.voxels, count[amount.material]);
    EXPECT_NEAR(amount.volume / (double(count[amount.material]) * 8e-12), 1, 1e-12);
  }
}

TEST(BuildFromLabels, KeepsThePoseOfTheVolumeAndItsCornerAtAnotherVoxelSize) {
  LabelVolume volume = random_labels({8, 8, 8}, 2);
  volume.X_WG = {rotation_from_vector({0.3, -1.1, 0.7}), Vec3(5, -3, 2) * mm};
  const Workpiece same = build_from_labels(volume, {{{1}, named("a")}});
  EXPECT_TRUE(same.frame().center({3, 4, 5}).isApprox(volume.position(3, 4, 5), 1e-12));
  const Workpiece workpiece =  // random labels are thin
      build_from_labels(volume, {{{1}, named("a")}}, {.voxel_size = 0.05 * mm, .warn = [](const std::string&) {}});
  const Vec3 corner = volume.X_WG * Vec3::Constant(-0.1 * mm).eval();
  const Vec3 found = workpiece.frame().X_WV * Vec3::Constant(-0.025 * mm).eval();
  EXPECT_LT((found - corner).norm(), 1e-15);
}

TEST(BuildFromLabels, KeepsVolumesAtOtherVoxelSizesAndSpacings) {
  auto volume = volume_of<std::uint16_t>({60, 60, 30}, Vec3(0.1, 0.1, 0.2) * mm);
  test::for_each_sample(volume, [&](int i, int j, int k) {
    const double r = (volume.position(i, j, k) - Vec3(3, 3, 3) * mm).norm();
    volume.at(i, j, k) = r < 1.5 * mm ? 7 : r < 2.5 * mm ? 9 : 0;
  });
  const double core = 4 * kPi / 3 * 3.375e-9, whole = 4 * kPi / 3 * 15.625e-9;
  for (const double voxel : {0.05, 0.1, 0.15, 0.3}) {
    const Workpiece workpiece =
        build_from_labels(volume, {{{9}, named("shell")}, {{7}, named("core")}}, {.voxel_size = voxel * mm});
    const auto amounts = workpiece.amounts();
    // A voxel has one material, so the inner boundary is a staircase; the outer boundary is antialiased.
    EXPECT_NEAR(amounts[1].volume / core, 1, 0.02) << voxel;
    EXPECT_NEAR((amounts[0].volume + amounts[1].volume) / whole, 1, 0.006) << voxel;
  }
}

TEST(BuildFromLabels, CropsToSamplesAndKeepsIndices) {
  const LabelVolume volume = random_labels({20, 20, 20}, 2);
  const IndexBox crop = {{3, 4, 5}, {12, 11, 10}};
  const Workpiece workpiece = build_from_labels(volume, {{{1}, named("a")}}, {.crop_samples = crop});
  test::for_each_sample(volume, [&](int i, int j, int k) {
    const bool kept = i >= 3 && i <= 12 && j >= 4 && j <= 11 && k >= 5 && k <= 10;
    ASSERT_EQ(workpiece.material_at({i, j, k}), kept ? volume.at(i, j, k) : 0);
  });
}

TEST(BuildFromLabels, CropsToABoxOfTheWorld) {
  auto volume = volume_of<std::uint16_t>({20, 20, 20}, Vec3::Constant(0.5 * mm));
  std::fill(volume.values.begin(), volume.values.end(), 1);
  volume.X_WG = Pose::from_translation(Vec3(0.25, 0.25, 0.25) * mm);  // the lower corner is the origin
  const Workpiece workpiece = build_from_labels(
      volume, {{{1}, named("a")}}, {.voxel_size = 0.25 * mm, .crop = Box{Vec3(1, 2, 3) * mm, Vec3(4, 4, 40) * mm}});
  EXPECT_NEAR(workpiece.amounts()[0].volume, 3 * 2 * 7 * 1e-9, 1e-15);
}

TEST(BuildFromLabels, RefusesLabelsThatNoMaterialClaims) {
  const LabelVolume volume = random_labels({6, 6, 6}, 4);
  test::expect_refused([&] { (void)build_from_labels(volume, {{{1}, named("a")}}); }, {"2, 3"});
  EXPECT_NO_THROW((void)build_from_labels(volume, {{{1}, named("a")}}, {}, UnclaimedLabels::leave_out));
  EXPECT_THROW((void)build_from_labels(volume, {{{1, 2}, named("a")}, {{2, 3}, named("b")}}), Error);
}

TEST(BuildFromLabels, RefusesVolumesThatAreNotConsistent) {
  LabelVolume volume = random_labels({6, 6, 6}, 2);
  const std::vector<LabelMaterial> materials = {{{1}, named("a")}};
  EXPECT_THROW((void)build_from_labels(volume, materials, {.voxel_size = -1}), Error);
  EXPECT_THROW((void)build_from_labels(volume, materials, {.voxel_size = 1e-12}), Error);  // 10^15 voxels
  EXPECT_THROW((void)build_from_labels(volume, materials, {.crop_samples = IndexBox{{9, 9, 9}, {12, 12, 12}}}), Error);
  EXPECT_THROW((void)build_from_labels(volume, materials, {.crop = Box{Vec3(1, 1, 1), Vec3(2, 2, 2)}}), Error);
  volume.values.pop_back();
  EXPECT_THROW((void)build_from_labels(volume, materials), Error);
  EXPECT_THROW((void)build_from_labels(LabelVolume{}, materials), Error);
}

TEST(BuildFromGrey, FillsVoxelsCutByAFlatFaceExactly) {
  const double face = 1.234 * mm;
  const GreyVolume volume =
      grey_field({8, 8, 8}, Vec3(0.3, 0.4, 0.5) * mm, [&](const Vec3& p) { return 1000 * (face - p.z()) / mm; });
  const Workpiece workpiece =
      build_from_grey(volume, {{0, std::numeric_limits<double>::infinity(), named("a")}}, {.voxel_size = 0.2 * mm});
  const double bottom = -0.25 * mm;  // the lower faces of the first samples
  for (int k = 0; k < 12; ++k) {
    const double fill = std::clamp((face - bottom - k * 0.2 * mm) / (0.2 * mm), 0.0, 1.0);
    ASSERT_NEAR(workpiece.fill_at({5, 5, k}), fill, 1e-4) << k;
    if (fill == 0 || fill == 1) continue;
    EXPECT_NEAR(workpiece.centroid_at({5, 5, k}).steps[2] / 1024.0, (fill - 1) / 2, 0.02);  // within a subsample
  }
}

TEST(BuildFromGrey, ConvergesToTheVolumeAndCenterOfABall) {
  const Vec3 center = Vec3(4.1, 3.9, 4.05) * mm;
  // Grey values fall linearly across the surface, as after the blur of a scanner. Interpolation of a curved field
  // between samples 0.2 mm apart displaces the surface by about spacing^2 / (8 R) = 2 um, 0.2 % of the volume.
  const GreyVolume volume = grey_field({41, 41, 28}, Vec3(0.2, 0.2, 0.3) * mm,
                                       [&](const Vec3& p) { return 500 - 300 * ((p - center).norm() / mm - 3); });
  const double exact = 4 * kPi / 3 * 27e-9;
  for (const double voxel : {0.1, 0.2, 0.4}) {
    const Moments m = moments_of(build_from_grey(volume, {{500, 1e9, named("a")}}, {.voxel_size = voxel * mm}));
    EXPECT_NEAR(m.volume / exact, 1, 4e-3) << voxel;
    EXPECT_LT((m.center - center).norm(), 0.005 * mm) << voxel;
  }
}

TEST(BuildFromGrey, WithoutAntialiasingCountsTheSamplesInRange) {
  std::mt19937 random(7);
  auto volume = volume_of<float>({17, 23, 12}, Vec3::Constant(1 * mm));
  for (float& value : volume.values) value = float(int(random() % 2000U) - 1000);
  const auto expected = std::count_if(volume.values.begin(), volume.values.end(), [](float v) { return v >= 226; });
  const Workpiece workpiece = build_from_grey(volume, {{226, 1e9, named("a")}}, {.antialias = false});
  EXPECT_EQ(workpiece.solid_voxels(), expected);
  EXPECT_EQ(workpiece.amounts()[0].voxels, expected);
}

TEST(BuildFromGrey, GivesEachRangeItsMaterial) {
  const GreyVolume volume =
      grey_field({10, 10, 50}, Vec3::Constant(0.1 * mm), [](const Vec3& p) { return 1000 * p.z() / mm; });
  // Ranges out of order, with a gap from 2000 to 2500.
  const Workpiece workpiece =
      build_from_grey(volume, {{2500, 4000, named("hard")}, {500, 1250, named("soft")}, {1250, 2000, named("middle")}});
  const auto amounts = workpiece.amounts();
  EXPECT_NEAR(amounts[0].volume, 1.5e-9, 1e-12);
  // The boundary between two materials is rounded to a voxel; the boundaries to empty are not.
  EXPECT_NEAR(amounts[1].volume, 0.75e-9, 0.06e-9);
  EXPECT_NEAR(amounts[1].volume + amounts[2].volume, 1.5e-9, 1e-12);
}

TEST(BuildFromGrey, RefusesRangesThatOverlapOrAreEmpty) {
  const GreyVolume volume = grey_field({4, 4, 4}, Vec3::Constant(1 * mm), [](const Vec3&) { return 100; });
  EXPECT_THROW((void)build_from_grey(volume, {{0, 100, named("a")}, {50, 200, named("b")}}), Error);
  EXPECT_THROW((void)build_from_grey(volume, {{100, 100, named("a")}}), Error);
  EXPECT_THROW((void)build_from_grey(volume, std::vector<GreyRange>{}), Error);
}

TEST(BuildFromGrey, RefusesValuesThatAreNotFinite) {
  GreyVolume volume = grey_field({4, 4, 4}, Vec3::Constant(1 * mm), [](const Vec3&) { return 100; });
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    volume.at(2, 1, 3) = bad;
    EXPECT_THROW((void)build_from_grey(volume, {{0, 200, named("a")}}), Error);
  }
}

TEST(Grade, IsNowhereFurtherFromLinearThanHalfAStep) {
  Material soft = named("bone"), hard = named("hard bone");
  soft.relative_stiffness = 0.1;
  hard.relative_stiffness = 1.3;
  hard.density = 1900;
  const Grade grade{.low = 200, .high = 1800, .at_low = soft, .at_high = hard, .steps = 50};
  const GreyVolume volume =
      grey_field({4, 4, 200}, Vec3::Constant(0.1 * mm), [](const Vec3& p) { return 100 * p.z() / mm; });
  const Workpiece workpiece = build_from_grey(volume, grade, {.antialias = false});
  const double max_error = 1.2 / (2 * 50) * (1 + 1e-6);
  int solid = 0;
  for (int k = 0; k < 200; ++k) {
    const MaterialId id = workpiece.material_at({1, 2, k});
    const double grey = volume.at(1, 2, k);
    ASSERT_EQ(id != kEmpty, grey >= 200) << grey;
    if (id == kEmpty) continue;
    ++solid;
    const double exact = 0.1 + 1.2 * std::min((grey - 200) / 1600, 1.0);
    ASSERT_NEAR(workpiece.materials()[id].relative_stiffness, exact, max_error) << grey;
  }
  EXPECT_EQ(solid, 180);
  EXPECT_EQ(workpiece.materials().size(), 50);
}

TEST(Grade, TakesTheMeanGreyValueOfTheFilledPart) {
  Material soft = named("bone"), hard = named("hard");
  hard.relative_stiffness = 2;
  const GreyVolume volume =
      grey_field({4, 4, 30}, Vec3::Constant(0.1 * mm), [](const Vec3& p) { return 1000 * p.z() / mm; });
  const Workpiece workpiece = build_from_grey(
      volume, Grade{.low = 0, .high = 3000, .at_low = soft, .at_high = hard, .steps = 150}, {.voxel_size = 0.2 * mm});
  // Voxel 7 reaches from z = 1.35 to 1.55 mm: mean 1450, piece 72 of 20 grey values each.
  EXPECT_EQ(workpiece.material_at({1, 1, 7}), MaterialId(1450 / 20 + 1));
}

// If u and h_s were each linear, the middle would be 18 % harder than the hard end.
TEST(Grade, CutsLinearlyBetweenItsEnds) {
  for (const auto kind : {CutterKind::carbide_bur, CutterKind::coarse_diamond, CutterKind::twist_drill}) {
    Material soft = presets::trabecular_bone(kind), hard = presets::cortical_bone(kind);
    soft.edge_length = 2e-6, hard.edge_length = 30e-6;
    const auto work = [](const Material& m, double feed) {  // [W/m^2] u V of C35, with 4000 lips per second
      return m.specific_cutting_energy * (feed + std::sqrt(m.size_length * 4000 * feed) + m.edge_length * 4000);
    };
    const std::vector<Material> pieces =
        materials_of({.low = 0, .high = 1, .at_low = soft, .at_high = hard, .steps = 8});
    for (const double feed : {0.1 * mm, 2 * mm, 50 * mm})
      for (std::size_t n = 0; n < 8; ++n) {
        const double t = (double(n) + 0.5) / 8, linear = (1 - t) * work(soft, feed) + t * work(hard, feed);
        EXPECT_NEAR(work(pieces[n], feed) / linear, 1, 1e-12) << n;
      }
  }
}

TEST(Grade, IsForTheCutterOfItsEnds) {
  const auto kind = CutterKind::twist_drill;
  const Material bone = presets::cortical_bone(kind), pulp = presets::pulp(), other = presets::cortical_bone();
  EXPECT_EQ(materials_of({.low = 0, .high = 1, .at_low = pulp, .at_high = bone, .steps = 2})[1].cutter, kind);
  EXPECT_EQ(materials_of({.low = 0, .high = 1, .at_low = bone, .at_high = pulp, .steps = 2})[0].cutter, kind);
  EXPECT_EQ(materials_of({.low = 0, .high = 1, .at_low = pulp, .at_high = pulp, .steps = 2})[0].cutter, std::nullopt);
  EXPECT_THROW((void)materials_of({.low = 0, .high = 1, .at_low = other, .at_high = bone}), Error);
}

TEST(Grade, RefusesInvalidGrades) {
  const Material a = named("a");
  EXPECT_THROW((void)materials_of({.low = 5, .high = 5, .at_low = a, .at_high = a}), Error);
  EXPECT_THROW((void)materials_of({.low = 0, .high = 5, .at_low = a, .at_high = a, .steps = 201}), Error);
  EXPECT_THROW((void)materials_of({.low = 0, .high = 5, .at_low = a, .at_high = Material{}}), Error);
}

}  // namespace
}  // namespace hapticut::volume_builders_test
