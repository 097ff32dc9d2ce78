// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/volume_operations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>

#include "hapticut/core/units.hpp"
#include "support/refusal.hpp"
#include "support/volumes.hpp"

namespace hapticut::volume_operations_test {
namespace {

using test::add_ball;
using test::count;
using test::volume_of;
using units::mm;

TEST(Crop, KeepsEverySampleWhereItWas) {
  auto volume = volume_of<float>({7, 8, 9}, Vec3(0.1, 0.2, 0.3) * mm);
  std::iota(volume.values.begin(), volume.values.end(), 0.0F);
  const GreyVolume part = crop_to_samples(volume, {{2, 3, -5}, {4, 99, 6}});
  EXPECT_EQ(part.dims, (std::array<int, 3>{3, 5, 7}));
  EXPECT_EQ(part.at(1, 2, 4), volume.at(3, 5, 4));
  EXPECT_LT((part.position(1, 2, 4) - volume.position(3, 5, 4)).norm(), 1e-15);
  EXPECT_THROW((void)crop_to_samples(volume, {{7, 0, 0}, {9, 1, 1}}), Error);
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

TEST(CropToABox, KeepsWhatAWorkpieceInTheBoxNeeds) {
  auto volume = volume_of<float>({20, 20, 20}, Vec3(0.1, 0.2, 0.3) * mm);
  std::iota(volume.values.begin(), volume.values.end(), 0.0F);
  volume.X_WG.rotation = Mat3::Identity();
  const Vec3 low = volume.position(5, 6, 7), high = volume.position(8, 6, 9), inside = Vec3::Constant(0.03 * mm);
  const GreyVolume part = crop_to_box(volume, {low + inside, high + inside});
  EXPECT_EQ(part.dims, (std::array<int, 3>{9, 6, 8}));  // two more samples on each side
  EXPECT_EQ(part.at(2, 2, 2), volume.at(5, 6, 7));
  EXPECT_LT((part.position(2, 2, 2) - low).norm(), 1e-15);
  EXPECT_EQ(crop_to_box(volume, {low - Vec3::Ones(), high + Vec3::Ones()}).dims, volume.dims);
  test::expect_refused(
      [&] {
        (void)crop_to_box(volume, {high + Vec3::Ones(), high + 2 * Vec3::Ones()});
      },
      {"lies outside the volume, which reaches from (2.95, "});
}

TEST(CropToABox, RotatesTheBoxIntoTheGridOfTheVolume) {
  auto volume = volume_of<std::uint16_t>({40, 40, 40}, Vec3::Constant(0.1 * mm));
  add_ball(volume, {2, 2, 2}, 0.5, 1);
  const Vec3 center = volume.position(20, 20, 20), half = Vec3::Constant(0.5 * mm);
  const LabelVolume part = crop_to_box(volume, {center - half, center + half});
  EXPECT_EQ(count(part, 1), count(volume, 1));
  EXPECT_LT(part.size(), volume.size() / 4);
}

TEST(BoxOfVolume, ReachesHalfASpacingBeyondTheSamples) {
  auto volume = volume_of<float>({4, 5, 6}, Vec3(0.1, 0.2, 0.3) * mm);
  const Box rotated = box_of_volume(volume);
  for (const int i : {0, 3})
    for (const int k : {0, 5}) {
      const Vec3 p = volume.position(i, 4, k);
      EXPECT_TRUE((p.array() > rotated.min.array()).all() && (p.array() < rotated.max.array()).all());
    }
  volume.X_WG = Pose::from_translation(Vec3(1, 2, 3) * mm);
  const Box box = box_of_volume(volume);
  EXPECT_LT((box.min - Vec3(0.95, 1.9, 2.85) * mm).norm(), 1e-15);
  EXPECT_LT((box.max - Vec3(1.35, 2.9, 4.65) * mm).norm(), 1e-15);
}

TEST(GreyRange, IgnoresSamplesThatAreNotNumbers) {
  auto volume = volume_of<float>({3, 1, 2}, Vec3::Constant(1 * mm));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  volume.values = {nan, 0, nan, 5, -2, nan};
  EXPECT_EQ(grey_range(volume), (std::array<double, 2>{-2, 5}));
  EXPECT_EQ(count_from(volume, 0), 2U);
  EXPECT_TRUE(count_labels(volume).empty());
  volume.values.assign(6, nan);
  EXPECT_THROW((void)grey_range(volume), Error);
}

TEST(CountLabels, CountsValuesThatMayBeLabels) {
  auto grey = volume_of<float>({3, 1, 2}, Vec3::Constant(1 * mm));
  grey.values = {0, 3, 3, 65535, 0, 0};
  const std::map<int, std::size_t> expected = {{0, 3}, {3, 2}, {65535, 1}};
  EXPECT_EQ(count_labels(grey), expected);
  EXPECT_TRUE(count_labels(grey, 2).empty());
  for (const float none : {-1.0F, 0.5F, 65536.0F}) {
    grey.values[4] = none;
    EXPECT_TRUE(count_labels(grey).empty()) << none;
  }
  auto labels = volume_of<std::uint16_t>({3, 1, 2}, Vec3::Constant(1 * mm));
  labels.values = {0, 3, 3, 65535, 0, 0};
  EXPECT_EQ(count_labels(labels), expected);
  EXPECT_THROW((void)unused_label(labels), Error);
  labels.values[3] = 65534;
  EXPECT_EQ(unused_label(labels), 65535);
}

TEST(KeepLargestComponent, DropsSpecksAndBodiesThatShareOnlyAnEdge) {
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

TEST(KeepLargestComponent, OfGreyValuesLeavesSamplesBelowTheThreshold) {
  auto volume = volume_of<float>({9, 3, 3}, Vec3::Constant(1 * mm));
  volume.values.assign(volume.size(), -5);
  for (const int i : {0, 1, 2, 5, 8}) volume.at(i, 1, 1) = 300;
  volume.at(6, 1, 1) = 250;
  volume.at(4, 1, 1) = 100;
  const GreyVolume kept = keep_largest_component(volume, 250);
  EXPECT_EQ(count_from(kept, 250), 3U);
  EXPECT_EQ(kept.at(4, 1, 1), 100);
  EXPECT_EQ(kept.at(5, 1, 1), -5);
  EXPECT_THROW((void)keep_largest_component(volume, 301), Error);
}

/// Flood fill over faces from the samples `from`, through empty or through filled samples.  @return the reached samples
std::vector<bool> reached(const LabelVolume& volume, const std::vector<VoxelIndex>& from, bool empty) {
  std::vector<bool> seen(volume.size(), false);
  std::vector<VoxelIndex> stack = from;
  while (!stack.empty()) {
    const VoxelIndex at = stack.back();
    stack.pop_back();
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) inside &= at[axis] >= 0 && at[axis] < volume.dims[axis];
    if (!inside || (volume.at(at[0], at[1], at[2]) == 0) != empty || seen[volume.offset(at[0], at[1], at[2])]) continue;
    seen[volume.offset(at[0], at[1], at[2])] = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        stack.push_back(at);
        stack.back()[axis] += step;
      }
  }
  return seen;
}

TEST(Components, EqualThoseOfASearchSampleBySample) {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    auto volume = volume_of<std::uint16_t>({1 + int(random() % 12), 1 + int(random() % 12), 1 + int(random() % 12)},
                                           Vec3::Constant(0.1 * mm));
    const unsigned tenths = 2 + unsigned(random() % 9);  // approximate fraction of empty samples
    for (std::uint16_t& value : volume.values) value = random() % 11 < tenths ? 0 : 1;
    if (count(volume, 1) == 0) continue;
    std::vector<VoxelIndex> border;
    std::vector<bool> largest;
    std::int64_t size = 0;
    test::for_each_sample(volume, [&](int i, int j, int k) {
      if (i == 0 || j == 0 || k == 0 || i + 1 == volume.dims[0] || j + 1 == volume.dims[1] || k + 1 == volume.dims[2])
        border.push_back({i, j, k});
      const std::vector<bool> body = reached(volume, {{i, j, k}}, false);
      const std::int64_t samples = std::count(body.begin(), body.end(), true);
      if (samples <= size) return;
      size = samples;
      largest = body;
    });
    const std::vector<bool> open = reached(volume, border, true);
    const LabelVolume kept = keep_largest_component(volume), filled = fill_cavities(volume, 7);
    for (std::size_t n = 0; n < volume.size(); ++n) {
      ASSERT_EQ(kept.values[n], largest[n] ? 1 : 0) << round;
      ASSERT_EQ(filled.values[n], volume.values[n] != 0 ? 1 : open[n] ? 0 : 7) << round;
    }
  }
}

}  // namespace
}  // namespace hapticut::volume_operations_test
