// SPDX-License-Identifier: Apache-2.0
#include "hapticut/contact/cut_voxel.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "hapticut/core/spatial.hpp"
#include "support/generators.hpp"

namespace hapticut::cut_voxel_test {
namespace {

using test::arbitrary_rotation;
using test::number_between;

constexpr double kNarrowest = VoxelSection<double>::kMinWidth;

double width(double max_component) {
  return std::max(std::sqrt(std::max(0.0, 1 - max_component * max_component)), kNarrowest);
}

/// Section A(v) of a voxel, the convolution of two boxes, from its definition.
double section(double max_component, double v) {
  const double p = max_component, q = width(max_component);
  const auto ramp = [&](double from) { return std::max(0.0, v - from); };
  return (ramp(0) - ramp(p) - ramp(q) + ramp(p + q)) / (p * q);
}

RC_GTEST_PROP(VoxelSection, ThePartBelowItsHeightIsTheFill, ()) {
  const double max_component = *number_between(0.57736, 1), fill = *number_between(0, 1);
  const double height = VoxelSection<double>(max_component).height_of(fill);
  constexpr int kSteps = 4000;
  double sum = 0;
  for (int n = 0; n < kSteps; ++n) sum += section(max_component, height * (n + 0.5) / kSteps) * height / kSteps;
  RC_ASSERT(std::abs(sum - fill) < 1e-5);
}

RC_GTEST_PROP(VoxelSection, IntegralsAreThoseOfTheSection, ()) {
  const double max_component = *number_between(0.57736, 1), fill = *number_between(0.001, 1);
  const VoxelSection<double> voxel(max_component);
  const double height = voxel.height_of(fill), depth = *number_between(0.001, 2),
               threshold = *number_between(0, 1) * depth;
  constexpr int kSteps = 20000;
  struct {
    double depth, volume, energy, cutting;
  } expected = {};
  const double from = std::max(0.0, height - depth);
  for (int n = 0; n < kSteps; ++n) {
    const double v = from + (height - from) * (n + 0.5) / kSteps, w = v - (height - depth);
    const double part = section(max_component, v) * (height - from) / kSteps;
    expected.depth += w * part;
    expected.volume += part;
    expected.energy += w * w / 2 * part;
    if (w > threshold) expected.cutting += w * part;
  }
  const double cutting = voxel.cutting(height, threshold, CutDepth<double>::of(depth, threshold).beyond(depth));
  RC_ASSERT(std::abs(voxel.depth(height, depth) / expected.depth - 1) < 1e-5);
  RC_ASSERT(std::abs(voxel.volume(height, depth) / expected.volume - 1) < 1e-5);
  RC_ASSERT(std::abs(voxel.energy(height, depth) / expected.energy - 1) < 1e-5);
  RC_ASSERT(std::abs(cutting - expected.cutting) < 1e-3 * expected.depth);  // the threshold lies within a step
}

RC_GTEST_PROP(VoxelSection, TheMeanDepthIsThatOfACubeThatAPlaneCuts, ()) {
  const Vec3 n = (*arbitrary_rotation()).col(0);
  const double fill = *number_between(0.02, 1), center = *number_between(-0.6, 0.6);  // [voxel edges]
  constexpr int kParts = 16;
  std::vector<double> depths;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j < kParts; ++j)
      for (int k = 0; k < kParts; ++k)
        depths.push_back(center + n.dot((Vec3(i, j, k).array() + 0.5).matrix() / kParts - Vec3::Constant(0.5)) * -1);
  std::sort(depths.begin(), depths.end());  // the filled part is the shallowest
  const auto left = std::size_t(std::lround(fill * double(depths.size())));
  if (left == 0) return;
  double expected = 0;
  for (std::size_t n_th = 0; n_th < left; ++n_th) expected += std::max(0.0, depths[n_th]) / double(depths.size());

  const VoxelSection<double> voxel(n.cwiseAbs().maxCoeff());
  const double height = voxel.height_of(double(left) / double(depths.size()));
  const double top = center + height - voxel.span() / 2;
  const double found = top > 0 ? voxel.depth(height, top) : 0;
  // Measured with 16 parts per edge: at most 0.006, along <111>; 0.002 in a plane of the grid.
  RC_ASSERT(std::abs(found - expected) < 0.008);
}

RC_GTEST_PROP(VoxelSection, SinglePrecisionIsEnoughForThinLayers, ()) {
  const double max_component = *number_between(0.57736, 1), fill = *number_between(0.001, 1);
  const double depth = std::pow(10, *number_between(-3, 0));
  const VoxelSection<double> exact(max_component);
  const VoxelSection<float> single{float(max_component)};
  const double height = exact.height_of(fill);
  const float rounded = single.height_of(float(fill));
  RC_ASSERT(std::abs(double(single.depth(rounded, float(depth))) / exact.depth(height, depth) - 1) < 2e-3);
  RC_ASSERT(std::abs(double(single.energy(rounded, float(depth))) / exact.energy(height, depth) - 1) < 4e-3);
}

/// 0, and numbers with sizes from 1e-30 to 1e6.
std::vector<double> sizes() {
  std::vector<double> all = {0};
  for (int n = 0; n <= 20000; ++n) all.push_back(std::pow(10.0, -30 + 36.0 * n / 20000));
  for (int n = 0; n <= 8000; ++n) all.push_back(n * 0.01);
  return all;
}

TEST(TanhQuotient, IsAsExactAsPromised) {
  for (const double y : sizes()) {
    const auto t = formulas::TanhQuotient<double>::of(y * y);
    const double exact = y < 1e-4 ? 1 - y * y / 3 : std::tanh(y) / y;
    EXPECT_LE(std::abs(t.p / t.q / exact - 1), 2.4e-7) << y;
    const double deficit = y < 1e-2 ? 1.0 / 3 - 2.0 / 15 * y * y : (1 - exact) / (y * y);
    EXPECT_LE(std::abs(t.r / t.q / deficit - 1), 3e-6) << y;
  }
}

TEST(MeanOfDecay, IsAsExactAsPromised) {
  for (const double x : sizes()) {
    const double exact = x == 0 ? 1.0 : -std::expm1(-x) / x;
    EXPECT_LE(std::abs(double(formulas::mean_of_decay(float(x))) / exact - 1), 4e-7) << x;
  }
}

RC_GTEST_PROP(LayerRecession, IsThatOfItsEquation, ()) {
  const double rate = std::pow(10, *number_between(0, 4)), speed = *number_between(0, 5);
  const double threshold = *number_between(0, 1), top = threshold + *number_between(0.01, 1),
               duration = *number_between(0.01, 1);
  const bool at_end = *rc::gen::arbitrary<bool>();
  if (rate * duration * (top + threshold) > 2000) return;  // the integration below would need more steps
  constexpr int kSteps = 20000;
  const double before = std::min(duration / 2, (top - threshold) / std::max(speed, 1e-300));
  const double h = (before + (at_end ? before : duration / 2)) / kSteps;
  const auto slope = [&](double t) { return speed - (t > threshold ? rate * (t * t - threshold * threshold) : 0); };
  double t = top - speed * before, removed = 0;
  for (int n = 0; n < kSteps; ++n) {
    const double k1 = slope(t), k2 = slope(t + h / 2 * k1), k3 = slope(t + h / 2 * k2), k4 = slope(t + h * k3);
    const double next = t + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    removed += speed * h - (next - t);
    t = next;
  }
  const auto found =
      LayerRecession<double>::of(top, CutDepth<double>::of(top, threshold), rate, speed, duration, at_end);
  RC_ASSERT(std::abs(found.relative * rate * (top * top - threshold * threshold) * duration / removed - 1) < 1e-4);
  const auto single = LayerRecession<float>::of(float(top), CutDepth<float>::of(float(top), float(threshold)),
                                                float(rate), float(speed), float(duration), at_end);
  RC_ASSERT(std::abs(double(single.relative) / found.relative - 1) < 1e-4);
}

}  // namespace
}  // namespace hapticut::cut_voxel_test
