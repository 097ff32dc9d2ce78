// SPDX-License-Identifier: Apache-2.0
#include "workpiece/coverage.hpp"

#include <cmath>
#include <limits>

namespace hapticut {
namespace {

constexpr double kAgreement = 0.01;  // [voxel edges] by which the 15 values may miss the polynomial
constexpr double kMostBend = 0.05;   // [voxel edges] of the parabola's height: radii of curvature below 2.5 voxels

/// A function in one voxel, coordinates -0.5 ... 0.5 along each axis: trilinear through the corners plus, along each
/// axis, bend * (1 - 4 x^2), which vanishes at the corners.
struct VoxelPolynomial {
  double corner[2][2][2];
  Vec3 bend;
};

Coverage count_lattice(const VoxelPolynomial& f, int subsamples) {
  int inside = 0;
  Vec3 sum = Vec3::Zero();
  const auto offset_of = [&](int n) { return (n + 0.5) / subsamples - 0.5; };
  const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
  for (int a = 0; a < subsamples; ++a) {
    const double x = offset_of(a);
    double edge[2][2];
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) edge[j][k] = mix(f.corner[0][j][k], f.corner[1][j][k], x + 0.5);
    const double bend_x = f.bend.x() * (1 - 4 * x * x) + f.bend.z();
    for (int b = 0; b < subsamples; ++b) {
      const double y = offset_of(b);
      const double low = mix(edge[0][0], edge[1][0], y + 0.5);
      const double high = mix(edge[0][1], edge[1][1], y + 0.5);
      const double constant = (low + high) / 2 + bend_x + f.bend.y() * (1 - 4 * y * y);
      const double slope = high - low;
      const double curve = -4 * f.bend.z();
      int row = 0;
      double row_sum = 0;
      for (int c = 0; c < subsamples; ++c) {
        const double z = offset_of(c);
        const bool filled = constant + z * (slope + z * curve) < 0;
        row += filled;
        row_sum += filled ? z : 0;
      }
      inside += row;
      sum += Vec3(row * x, row * y, row_sum);
    }
  }
  if (inside == 0) return {0, Vec3::Zero()};
  return {double(inside) / (subsamples * subsamples * subsamples), sum / inside};
}

}  // namespace

Coverage sample_coverage(const std::function<double(const Vec3&)>& distance, const Vec3& center, double voxel_size,
                         int subsamples) {
  int inside = 0;
  Vec3 sum = Vec3::Zero();
  for (int a = 0; a < subsamples; ++a)
    for (int b = 0; b < subsamples; ++b)
      for (int c = 0; c < subsamples; ++c) {
        const Vec3 offset = (Vec3(a, b, c).array() + 0.5) / subsamples - 0.5;
        if (distance(center + voxel_size * offset) >= 0) continue;
        ++inside;
        sum += offset;
      }
  if (inside == 0) return {0, Vec3::Zero()};
  return {double(inside) / (subsamples * subsamples * subsamples), sum / inside};
}

BlockCoverage::BlockCoverage(const std::function<double(const Vec3&)>& distance, const GridFrame& frame,
                             const VoxelIndex& origin, int subsamples)
    : distance_(distance), frame_(frame), origin_(origin), subsamples_(subsamples) {
  values_.fill(std::numeric_limits<double>::quiet_NaN());
}

double BlockCoverage::value(int i, int j, int k) {
  const int node = (i * kNodes + j) * kNodes + k;
  double& known = values_[std::size_t(node)];
  if (std::isnan(known)) {
    const Vec3 voxels(origin_[0] + (i - 1) / 2.0, origin_[1] + (j - 1) / 2.0, origin_[2] + (k - 1) / 2.0);
    known = distance_(frame_.X_WV * (frame_.voxel_size * voxels));
  }
  return known;
}

Coverage BlockCoverage::coverage(int x, int y, int z) {
  const int i = 2 * x + 1, j = 2 * y + 1, k = 2 * z + 1;
  VoxelPolynomial f{};
  double mean = 0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c) {
        f.corner[a][b][c] = value(i - 1 + 2 * a, j - 1 + 2 * b, k - 1 + 2 * c);
        mean += f.corner[a][b][c] / 8;
      }
  // On a face the parabolas along its two own axes add up; in the centre all three do.
  const double centre = value(i, j, k) - mean;
  double face[3][2];  // value in the middle of a face less the mean of its corners
  for (int side = 0; side < 2; ++side) {
    const int step = 2 * side - 1;
    double corners[3] = {0, 0, 0};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        corners[0] += f.corner[side][a][b] / 4;
        corners[1] += f.corner[a][side][b] / 4;
        corners[2] += f.corner[a][b][side] / 4;
      }
    face[0][side] = value(i + step, j, k) - corners[0];
    face[1][side] = value(i, j + step, k) - corners[1];
    face[2][side] = value(i, j, k + step) - corners[2];
  }
  const double agreement = kAgreement * frame_.voxel_size;
  bool smooth = true;
  double faces = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double both = (face[axis][0] + face[axis][1]) / 2;
    faces += both;
    f.bend[axis] = centre - both;
    smooth &= std::abs(face[axis][0] - face[axis][1]) <= agreement;
    smooth &= std::abs(f.bend[axis]) <= kMostBend * frame_.voxel_size;
  }
  smooth &= std::abs(2 * centre - faces) <= agreement;
  if (smooth) return count_lattice(f, subsamples_);
  return sample_coverage(distance_, frame_.center({origin_[0] + x, origin_[1] + y, origin_[2] + z}), frame_.voxel_size,
                         subsamples_);
}

}  // namespace hapticut
