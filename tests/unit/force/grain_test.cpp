// SPDX-License-Identifier: Apache-2.0
// The grain of a material: its mean, its variation, and that it stays in its place.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/grain.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::grain_test {
namespace {

using units::mm;

constexpr MaterialId kBone = 1, kEven = 2;

Grain grain_of(double variation, double length, const GridFrame& frame, std::uint32_t seed = 1) {
  Material bone = presets::trabecular_bone();
  bone.grain = variation, bone.grain_length = length;
  Grain grain;
  grain.set(contact_materials(MaterialTable({bone, presets::pulp()}), 1e12), frame, seed);
  return grain;
}

struct Statistics {
  double mean = 0, variation = 0, of_neighbours = 0;  // [1] the last is a correlation
};

/// Over one voxel of each of 40 x 40 x 40 cells, inside it.
Statistics over_cells(const Grain& grain, int voxels_per_cell) {
  constexpr int kCells = 40;
  const auto at = [&](int i, int j, int k) {
    const auto inside = [&](int cell) { return voxels_per_cell * cell + voxels_per_cell / 2; };
    return double(grain.at(kBone, {inside(i), inside(j), inside(k)}));
  };
  double sum = 0, squares = 0, products = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j)
      for (int k = 0; k < kCells; ++k) {
        const double g = at(i, j, k);
        sum += g, squares += g * g;
        products += (g - 1) * ((at(i + 1, j, k) + at(i, j + 1, k) + at(i, j, k + 1)) / 3 - 1);
      }
  const double count = std::pow(kCells, 3), mean = sum / count, variance = squares / count - mean * mean;
  return {mean, std::sqrt(variance) / mean, products / count / variance};
}

TEST(Grain, HasTheMean1AndTheVariationOfTheMaterialInIndependentCells) {
  for (const double variation : {0.05, 0.12, 0.4, 1.0}) {
    const Statistics s = over_cells(grain_of(variation, 0.4 * mm, {0.1 * mm, {}}), 4);
    const double error = 1 / std::sqrt(64000.0);  // of a mean over independent cells
    EXPECT_NEAR(s.mean, 1, 4 * variation * error) << variation;
    EXPECT_NEAR(s.variation, variation, 10 * variation * error) << variation;
    EXPECT_NEAR(s.of_neighbours, 0, 4 * error) << variation;
  }
}

TEST(Grain, HasLogNormalClassesOfEqualProbability) {
  for (const double variation : {0.12, 0.4}) {
    const Grain::Classes classes = Grain::classes_of(variation);
    double sum = 0, squares = 0, cubes = 0;
    for (const float g : classes) {
      EXPECT_GT(g, 0);
      sum += double(g) / Grain::kClasses;
      squares += std::pow(double(g) - 1, 2) / Grain::kClasses;
      cubes += std::pow(double(g) - 1, 3) / Grain::kClasses;
    }
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_NEAR(std::sqrt(squares), variation, 1e-6);
    // Skewness of a log-normal number: (v^2 + 3) v; classes of a finite width lose a part of its tail.
    const double skewness = cubes / std::pow(variation, 3), whole = (variation * variation + 3) * variation;
    EXPECT_GT(skewness, 0.5 * whole);
    EXPECT_LT(skewness, whole);
  }
}

TEST(Grain, IsTheSameAtAPlaceForVoxelsOfEachSizeAndInATurnedGrid) {
  const Pose turned = {rotation_from_vector({0.3, -0.2, 0.7}), {1.3 * mm, -2 * mm, 40 * mm}};
  const GridFrame frames[] = {{0.1 * mm, {}}, {0.1 * mm, turned}};
  for (const GridFrame& frame : frames) {
    GridFrame halved = frame;
    halved.voxel_size /= 2;
    // Voxel (0,0,0) of the finer grid is a corner's voxel of that of the coarser.
    halved.X_WV.translation -= frame.X_WV.rotation * Vec3::Constant(0.025 * mm);
    const Grain coarse = grain_of(0.4, 0.43 * mm, frame), fine = grain_of(0.4, 0.43 * mm, halved);
    int same = 0, all = 0;
    for (int i = -30; i < 30; ++i)
      for (int j = -30; j < 30; ++j) {
        ++all;
        same += coarse.at(kBone, {i, j, 7}) == fine.at(kBone, {2 * i, 2 * j, 14}) ? 1 : 0;
      }
    // A voxel of a quarter of the cell has its small corner in another cell 1 - (1 - 0.025/0.43)^3 of the time.
    EXPECT_GT(same, 0.75 * all);
    EXPECT_EQ(coarse.at(kBone, {3, 4, 5}), grain_of(0.4, 0.43 * mm, frame).at(kBone, {3, 4, 5}));
  }
}

TEST(Grain, IsTheSameForTheVoxelsOfABlock) {
  const Grain grain = grain_of(0.4, 0.23 * mm, {0.1 * mm, {Mat3::Identity(), {1.3 * mm, -2 * mm, 40 * mm}}});
  Grain::OfBlock in_block;
  for (const VoxelIndex& origin : {VoxelIndex{0, 0, 0}, VoxelIndex{-8, 0, 0}, VoxelIndex{-8, 16, -24}})
    for (const MaterialId id : {kBone, kEven}) {
      in_block.enter(grain, id, origin);
      for (int step = 0; step < 2 * kBlockVoxels; ++step) {
        const int offset = step * 7 % kBlockVoxels;
        ASSERT_EQ(in_block.at(offset), grain.at(id, voxel_at(origin, offset))) << offset;
      }
    }
}

TEST(Grain, PutsACentreOnAFaceIntoTheCellAbove) {
  const Grain grain = grain_of(1, 0.2 * mm, {0.1 * mm, {}});  // even voxels have their centres on faces
  for (int x = -3000; x < 3000; x += 2) ASSERT_EQ(grain.at(kBone, {x, 0, 0}), grain.at(kBone, {x + 1, 0, 0})) << x;
}

TEST(Grain, HasCellsOfAtLeastTwoVoxelsThatVaryLess) {
  const Statistics s = over_cells(grain_of(0.4, 0.1 * mm, {0.2 * mm, {}}), 2);
  EXPECT_NEAR(s.variation, 0.4 / 4, 0.002);
}

TEST(Grain, DiffersBetweenSeedsAndIsAbsentInAnEvenMaterial) {
  const GridFrame frame = {0.1 * mm, {}};
  const Grain one = grain_of(0.4, 0.4 * mm, frame, 1), two = grain_of(0.4, 0.4 * mm, frame, 2);
  int same = 0;
  for (int i = 0; i < 1000; ++i) same += one.at(kBone, {4 * i, 0, 0}) == two.at(kBone, {4 * i, 0, 0}) ? 1 : 0;
  EXPECT_NEAR(same, 1000.0 / Grain::kClasses, 40);
  EXPECT_TRUE(one.has(kBone));
  EXPECT_FALSE(one.has(kEven));
  EXPECT_EQ(one.at(kEven, {1, 2, 3}), 1);
  EXPECT_FALSE(grain_of(0, 1 * mm, frame).any());
  EXPECT_FALSE(grain_of(0.4, 0, frame).any());
}

}  // namespace
}  // namespace hapticut::grain_test
