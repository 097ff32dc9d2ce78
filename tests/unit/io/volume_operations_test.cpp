// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/volume/volume_operations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hapticut/core/units.hpp"

namespace hapticut::volume_operations_test {
namespace {

using units::mm;

template <class Value>
Volume<Value> volume_of(std::array<int, 3> dims, const Vec3& spacing) {
  Volume<Value> volume;
  volume.dims = dims;
  volume.spacing = spacing;
  volume.X_WG = {rotation_from_vector({0.2, 0.9, -0.4}), Vec3(3, -2, 8) * mm};
  volume.values.resize(volume.size());
  return volume;
}

/// Sets all samples whose index is within a distance of a point, counted in millimetres of the grid's axes.
void add_ball(LabelVolume& volume, const Vec3& center_mm, double radius_mm, std::uint16_t label) {
  for (int k = 0; k < volume.dims[2]; ++k)
    for (int j = 0; j < volume.dims[1]; ++j)
      for (int i = 0; i < volume.dims[0]; ++i)
        if ((Vec3(i, j, k).cwiseProduct(volume.spacing) / mm - center_mm).norm() <= radius_mm)
          volume.at(i, j, k) = label;
}

std::int64_t count(const LabelVolume& volume, std::uint16_t label) {
  return std::count(volume.values.begin(), volume.values.end(), label);
}

TEST(Crop, KeepsEverySampleWhereItWas) {
  auto volume = volume_of<float>({7, 8, 9}, Vec3(0.1, 0.2, 0.3) * mm);
  std::iota(volume.values.begin(), volume.values.end(), 0.0F);
  const GreyVolume part = crop(volume, {{2, 3, -5}, {4, 99, 6}});
  EXPECT_EQ(part.dims, (std::array<int, 3>{3, 5, 7}));
  EXPECT_EQ(part.at(1, 2, 4), volume.at(3, 5, 4));
  EXPECT_LT((part.position(1, 2, 4) - volume.position(3, 5, 4)).norm(), 1e-15);
  EXPECT_THROW((void)crop(volume, {{7, 0, 0}, {9, 1, 1}}), Error);
}

TEST(BoxAround, FindsLabelsAndGrowsByTheMargin) {
  auto volume = volume_of<std::uint16_t>({20, 20, 20}, Vec3(0.1, 0.2, 0.3) * mm);
  volume.at(5, 6, 7) = 3;
  volume.at(8, 6, 9) = 3;
  volume.at(15, 1, 19) = 4;
  const IndexBox box = box_around(volume, {3});
  EXPECT_EQ(box.min, (VoxelIndex{5, 6, 7}));
  EXPECT_EQ(box.max, (VoxelIndex{8, 6, 9}));
  const IndexBox wide = box_around(volume, {3}, 0.6 * mm);
  EXPECT_EQ(wide.min, (VoxelIndex{0, 3, 5}));
  EXPECT_EQ(wide.max, (VoxelIndex{14, 9, 11}));
  EXPECT_EQ(box_around(volume).max, (VoxelIndex{15, 6, 19}));
  EXPECT_THROW((void)box_around(volume, {9}), Error);
}

TEST(BoxAround, FindsGreyValues) {
  auto volume = volume_of<float>({20, 20, 20}, Vec3::Constant(1 * mm));
  volume.at(3, 4, 5) = 226;
  volume.at(13, 4, 5) = 225.9F;
  EXPECT_EQ(box_around(volume, 226).max, (VoxelIndex{3, 4, 5}));
  EXPECT_EQ(count(label_range(volume, 226, 300, 8), 8), 1);
}

TEST(WithSpacing, LeavesTheFirstSampleInPlace) {
  const auto volume = volume_of<float>({2, 2, 2}, Vec3::Constant(1 * mm));
  const GreyVolume fine = with_spacing(volume, Vec3::Constant(0.034 * mm));
  EXPECT_TRUE(fine.X_WG.translation.isApprox(volume.X_WG.translation));
  EXPECT_THROW((void)with_spacing(volume, Vec3::Zero()), Error);
}

TEST(Resample, ReproducesALinearFieldWhereverItHasSamples) {
  auto volume = volume_of<float>({20, 16, 12}, Vec3(0.2, 0.25, 0.4) * mm);
  const auto field = [](const Vec3& p_W) { return 5 + 1000 * Vec3(1, -2, 3).dot(p_W) / mm / 1000; };
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 16; ++j)
      for (int i = 0; i < 20; ++i) volume.at(i, j, k) = float(field(volume.position(i, j, k)));
  for (const double size : {0.1, 0.3, 0.6}) {
    const GreyVolume cubic = resample(volume, size * mm);
    int compared = 0;
    for (int k = 0; k < cubic.dims[2]; ++k)
      for (int j = 0; j < cubic.dims[1]; ++j)
        for (int i = 0; i < cubic.dims[0]; ++i) {
          const Vec3 p_W = cubic.position(i, j, k);
          const Vec3 place = (volume.X_WG.inverse() * p_W).cwiseQuotient(volume.spacing);
          // Near the border means and interpolation see less than a full neighbourhood.
          const Vec3 margin = Vec3::Constant(size * mm).cwiseQuotient(volume.spacing) + Vec3::Ones();
          if ((place - margin).minCoeff() < 0 || (place + margin - Vec3(19, 15, 11)).maxCoeff() > 0) continue;
          ASSERT_NEAR(cubic.at(i, j, k), field(p_W), 1e-4) << size;
          ++compared;
        }
    EXPECT_GT(compared, 20) << size;
  }
}

TEST(Resample, KeepsTheVolumeOfALabel) {
  auto volume = volume_of<std::uint16_t>({40, 40, 20}, Vec3(0.1, 0.1, 0.2) * mm);
  add_ball(volume, {2, 2, 2}, 1.5, 7);
  add_ball(volume, {2, 2, 2}, 0.8, 9);
  for (const auto interpolation : {LabelInterpolation::nearest, LabelInterpolation::smooth})
    for (const double size : {0.05, 0.1}) {
      const LabelVolume cubic = resample(volume, size * mm, interpolation);
      for (const std::uint16_t label : {std::uint16_t(7), std::uint16_t(9)}) {
        const double before = double(count(volume, label)) * 0.002,
                     after = double(count(cubic, label)) * std::pow(size, 3);
        EXPECT_NEAR(after / before, 1, 0.03) << size << " label " << label;
      }
      EXPECT_EQ(count(cubic, 7) + count(cubic, 9) + count(cubic, 0), std::int64_t(cubic.size()));
    }
}

TEST(Resample, RefusesMoreSamplesThanFit) {
  const auto volume = volume_of<float>({20, 20, 20}, Vec3::Constant(1 * mm));
  EXPECT_THROW((void)resample(volume, 1e-9), Error);
  EXPECT_THROW((void)resample(volume, 0), Error);
}

TEST(KeepLargestComponent, DropsSpecksAndWhatTouchesByAnEdgeOnly) {
  auto volume = volume_of<std::uint16_t>({30, 30, 30}, Vec3::Constant(0.1 * mm));
  add_ball(volume, {1, 1, 1}, 0.601, 1);
  add_ball(volume, {1, 1, 1}, 0.3, 2);  // another label of the same body
  const std::int64_t body = count(volume, 1) + count(volume, 2);
  add_ball(volume, {2.3, 2.3, 2.3}, 0.2, 2);
  volume.at(17, 11, 10) = 5;  // shares an edge with sample (16, 10, 10) of the body
  const LabelVolume kept = keep_largest_component(volume);
  EXPECT_EQ(count(kept, 1) + count(kept, 2), body);
  EXPECT_EQ(count(kept, 5), 0);
  EXPECT_THROW((void)keep_largest_component(volume_of<std::uint16_t>({3, 3, 3}, Vec3::Constant(1 * mm))), Error);
}

TEST(FillCavities, FillsWhatIsEnclosedAndNothingElse) {
  auto volume = volume_of<std::uint16_t>({30, 30, 30}, Vec3::Constant(0.1 * mm));
  add_ball(volume, {1.5, 1.5, 1.5}, 1.2, 1);
  add_ball(volume, {1.2, 1.5, 1.5}, 0.4, 0);
  add_ball(volume, {2.2, 1.5, 1.5}, 0.3, 0);
  const std::int64_t body = count(volume, 1);
  auto opened = volume;
  for (int i = 0; i < 10; ++i) opened.at(i, 15, 15) = 0;  // a canal from the first cavity to the outside
  const LabelVolume both = fill_cavities(volume, 6), one = fill_cavities(opened, 6);
  EXPECT_EQ(count(both, 1), body);
  EXPECT_GT(count(both, 6), 300);
  EXPECT_EQ(both.at(12, 15, 15), 6);
  EXPECT_EQ(both.at(22, 15, 15), 6);
  EXPECT_EQ(both.at(0, 0, 0), 0);
  EXPECT_EQ(one.at(12, 15, 15), 0);
  EXPECT_EQ(one.at(22, 15, 15), 6);
}

TEST(CloseGaps, ClosesSlitsNarrowerThanTheBall) {
  // Two plates 0.5 mm apart and two plates 1.2 mm apart, with anisotropic samples.
  auto volume = volume_of<std::uint16_t>({60, 30, 20}, Vec3(0.1, 0.2, 0.3) * mm);
  const auto plate = [&](int from, int to) {
    for (int k = 2; k < 18; ++k)
      for (int j = 2; j < 28; ++j)
        for (int i = from; i <= to; ++i) volume.at(i, j, k) = 1;
  };
  plate(5, 10);
  plate(16, 21);  // a gap of 5 samples, 0.5 mm
  plate(34, 39);  // a gap of 12 samples, 1.2 mm
  const LabelVolume closed = close_gaps(volume, 0.4 * mm, 2);
  EXPECT_EQ(closed.at(13, 15, 10), 2);
  EXPECT_EQ(closed.at(27, 15, 10), 0);
  EXPECT_EQ(count(closed, 1), count(volume, 1));
  EXPECT_EQ(closed.at(3, 15, 10), 0);  // the outside stays
  EXPECT_EQ(closed.at(40, 15, 10), 0);
}

TEST(CloseGaps, LeavesAConvexBodyAloneAlsoAtTheBorder) {
  auto volume = volume_of<std::uint16_t>({24, 24, 24}, Vec3::Constant(0.1 * mm));
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 3; i < 20; ++i) volume.at(i, j, k) = 4;
  EXPECT_EQ(close_gaps(volume, 0.5 * mm, 2).values, volume.values);
}

TEST(CloseGaps, RefusesWhatIsNoRadius) {
  auto volume = volume_of<std::uint16_t>({4, 4, 4}, Vec3::Constant(0.1 * mm));
  EXPECT_THROW((void)close_gaps(volume, 0.1 * mm, 2), Error);  // no body
  volume.at(1, 1, 1) = 1;
  EXPECT_THROW((void)close_gaps(volume, 0, 2), Error);
  EXPECT_THROW((void)close_gaps(volume, 1, 2), Error);  // a metre
}

}  // namespace
}  // namespace hapticut::volume_operations_test
