// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/cut_voxel.hpp"

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

double width(double largest) { return std::max(std::sqrt(std::max(0.0, 1 - largest * largest)), kNarrowest); }

/// A(v) of two boxes, from its definition.
double section(double largest, double v) {
  const double p = largest, q = width(largest);
  const auto ramp = [&](double from) { return std::max(0.0, v - from); };
  return (ramp(0) - ramp(p) - ramp(q) + ramp(p + q)) / (p * q);
}

RC_GTEST_PROP(VoxelSection, ThePartBelowItsHeightIsTheFill, ()) {
  const double largest = *number_between(0.57736, 1), fill = *number_between(0, 1);
  const double height = VoxelSection<double>(largest).height_of(fill);
  constexpr int kSteps = 4000;
  double sum = 0;
  for (int n = 0; n < kSteps; ++n) sum += section(largest, height * (n + 0.5) / kSteps) * height / kSteps;
  RC_ASSERT(std::abs(sum - fill) < 1e-5);
}

RC_GTEST_PROP(VoxelSection, IntegralsAreThoseOfTheSection, ()) {
  const double largest = *number_between(0.57736, 1), fill = *number_between(0.001, 1);
  const VoxelSection<double> voxel(largest);
  const double height = voxel.height_of(fill), depth = *number_between(0.001, 2), least = *number_between(0, 1) * depth;
  constexpr int kSteps = 20000;
  DepthIntegrals<double> expected = {};
  const double from = std::max(0.0, height - depth);
  for (int n = 0; n < kSteps; ++n) {
    const double v = from + (height - from) * (n + 0.5) / kSteps, w = v - (height - depth);
    const double part = section(largest, v) * (height - from) / kSteps;
    expected.depth += w * part;
    expected.volume += part;
    expected.energy += w * w / 2 * part;
    if (w > least) expected.cutting += w * part;
  }
  const DepthIntegrals<double> found = voxel.integrals(height, depth, CutDepth<double>::of(depth, least));
  RC_ASSERT(std::abs(found.depth / expected.depth - 1) < 1e-5);
  RC_ASSERT(std::abs(found.volume / expected.volume - 1) < 1e-5);
  RC_ASSERT(std::abs(found.energy / expected.energy - 1) < 1e-5);
  RC_ASSERT(std::abs(found.cutting - expected.cutting) < 1e-3 * expected.depth);  // its edge lies within a step
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
  std::sort(depths.begin(), depths.end());  // what is left is the shallowest part
  const auto left = std::size_t(std::lround(fill * double(depths.size())));
  if (left == 0) return;
  double expected = 0;
  for (std::size_t n_th = 0; n_th < left; ++n_th) expected += std::max(0.0, depths[n_th]) / double(depths.size());

  const VoxelSection<double> voxel(n.cwiseAbs().maxCoeff());
  const double height = voxel.height_of(double(left) / double(depths.size()));
  const double top = center + height - voxel.span() / 2;
  const double found = top > 0 ? voxel.integrals(height, top).depth : 0;
  // Measured: 0.006 at most, along <111>; 0.002 in a plane of the grid, where the cubes are of sixteen parts an edge.
  RC_ASSERT(std::abs(found - expected) < 0.008);
}

RC_GTEST_PROP(VoxelSection, SinglePrecisionIsEnoughForThinLayers, ()) {
  const double largest = *number_between(0.57736, 1), fill = *number_between(0.001, 1);
  const double depth = std::pow(10, *number_between(-3, 0)), least = *number_between(0, 0.9) * depth;
  const VoxelSection<double> exact(largest);
  const VoxelSection<float> single{float(largest)};
  const DepthIntegrals<double> a = exact.integrals(exact.height_of(fill), depth, CutDepth<double>::of(depth, least));
  const DepthIntegrals<float> b =
      single.integrals(single.height_of(float(fill)), float(depth), CutDepth<float>::of(float(depth), float(least)));
  RC_ASSERT(std::abs(double(b.depth) / a.depth - 1) < 2e-3);
  RC_ASSERT(std::abs(double(b.energy) / a.energy - 1) < 4e-3);
}

RC_GTEST_PROP(LayerRecession, IsThatOfItsEquation, ()) {
  const double rate = std::pow(10, *number_between(0, 4)), speed = *number_between(0, 5);
  const double least = *number_between(0, 1), top = least + *number_between(0.01, 1),
               duration = *number_between(0.01, 1);
  const bool at_end = *rc::gen::arbitrary<bool>();
  if (rate * duration * (top + least) > 2000) return;  // the integration below would need more steps
  constexpr int kSteps = 20000;
  const double before = std::min(duration / 2, (top - least) / std::max(speed, 1e-300));
  const double h = (before + (at_end ? before : duration / 2)) / kSteps;
  const auto slope = [&](double t) { return speed - (t > least ? rate * (t * t - least * least) : 0); };
  double t = top - speed * before, gone = 0;
  for (int n = 0; n < kSteps; ++n) {
    const double k1 = slope(t), k2 = slope(t + h / 2 * k1), k3 = slope(t + h / 2 * k2), k4 = slope(t + h * k3);
    const double next = t + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    gone += speed * h - (next - t);
    t = next;
  }
  const auto found = LayerRecession<double>::of(top, CutDepth<double>::of(top, least), rate, speed, duration, at_end);
  RC_ASSERT(std::abs(found.share * rate * (top * top - least * least) * duration / gone - 1) < 1e-4);
  const auto single = LayerRecession<float>::of(float(top), CutDepth<float>::of(float(top), float(least)), float(rate),
                                                float(speed), float(duration), at_end);
  RC_ASSERT(std::abs(double(single.share) / found.share - 1) < 1e-4);
}

}  // namespace
}  // namespace hapticut::cut_voxel_test
