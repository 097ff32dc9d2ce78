// SPDX-License-Identifier: Apache-2.0
#include "hapticut/import/volume/volume_filters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "support/volumes.hpp"

namespace hapticut::volume_filters_test {
namespace {

using test::add_ball;
using test::count;
using test::volume_of;
using units::mm;

TEST(Resample, ReproducesALinearFieldInsideItsSamples) {
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
}  // namespace hapticut::volume_filters_test
