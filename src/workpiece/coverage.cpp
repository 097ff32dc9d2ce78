// SPDX-License-Identifier: Apache-2.0
#include "workpiece/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hapticut {
namespace {

constexpr double kAgreement = 0.01;  // [voxel edges] allowed deviation of the 15 values from the polynomial
// [voxel edges] height of the parabola: exceeded by radii of curvature below 2.5 voxels
constexpr double kMaxBend = 0.05;

/// A function in one voxel, coordinates -0.5 ... 0.5 along each axis: trilinear through the corners plus, along each
/// axis, bend * (1 - 4 x^2), which vanishes at the corners.
struct VoxelPolynomial {
  double corner[2][2][2];
  Vec3 bend;
};

constexpr double kRounding = 1e-9;  // [1] rounding error over a voxel

/// @param moment  [voxel edges] integral of the position over the filled part, over the volume of a voxel
Coverage coverage_of(double fill, const Vec3& moment) {
  if (fill < kRounding) return {0, Vec3::Zero()};
  if (fill > 1 - kRounding) return {1, Vec3::Zero()};
  return {fill, moment / fill};
}

/// The part of a row.
struct Covered {
  double length;  // [voxel edges]
  double moment;  // [voxel edges^2] integral of z over the part
};

/// The part of the row -0.5 <= z <= 0.5 in which c + z (s + z q) is negative.
Covered covered_part(double c, double s, double q) {
  double ends[4] = {-0.5, 0.5, 0.5, 0.5};
  int parts = 1;
  const double discriminant = s * s - 4 * q * c;
  if (discriminant > 0) {
    // Avoids the difference of two nearly equal numbers, and works for q = 0.
    const double t = -0.5 * (s + std::copysign(std::sqrt(discriminant), s));
    double first = c / t, second = q != 0 ? t / q : std::numeric_limits<double>::infinity();
    if (first > second) std::swap(first, second);
    for (const double root : {first, second})
      if (root > -0.5 && root < 0.5) ends[parts++] = root;
    ends[parts] = 0.5;
  }
  Covered covered{0, 0};
  for (int n = 0; n < parts; ++n) {
    const double length = ends[n + 1] - ends[n], middle = (ends[n] + ends[n + 1]) / 2;
    if (c + middle * (s + middle * q) >= 0) continue;
    covered.length += length;
    covered.moment += length * middle;
  }
  return covered;
}

/// Permutes the axes x -> y -> z -> x of a polynomial `times` times: after one permutation x is the last axis, after
/// two y is.
VoxelPolynomial permuted(const VoxelPolynomial& f, int times) {
  VoxelPolynomial g = f;
  for (; times > 0; --times) {
    const VoxelPolynomial before = g;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k) g.corner[j][k][i] = before.corner[i][j][k];
    g.bend = Vec3(before.bend.y(), before.bend.z(), before.bend.x());
  }
  return g;
}

/// Integrates exactly along rows in z, and by the midpoint rule over `rows`^2 rows. Exact for a plane parallel to z.
Coverage add_rows(const VoxelPolynomial& f, int rows) {
  double volume = 0;
  Vec3 moment = Vec3::Zero();
  const auto offset_of = [&](int n) { return (n + 0.5) / rows - 0.5; };
  const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
  for (int a = 0; a < rows; ++a) {
    const double x = offset_of(a);
    double edge[2][2];
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) edge[j][k] = mix(f.corner[0][j][k], f.corner[1][j][k], x + 0.5);
    const double bend_x = f.bend.x() * (1 - 4 * x * x) + f.bend.z();
    for (int b = 0; b < rows; ++b) {
      const double y = offset_of(b);
      const double low = mix(edge[0][0], edge[1][0], y + 0.5);
      const double high = mix(edge[0][1], edge[1][1], y + 0.5);
      const Covered row =
          covered_part((low + high) / 2 + bend_x + f.bend.y() * (1 - 4 * y * y), high - low, -4 * f.bend.z());
      volume += row.length;
      moment += Vec3(row.length * x, row.length * y, row.moment);
    }
  }
  return coverage_of(volume / (rows * rows), moment / (rows * rows));
}

/// Integrates with rows along the axis along which the function changes fastest.
Coverage integrate(const VoxelPolynomial& f, int rows) {
  Vec3 slope = Vec3::Zero();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      slope.x() += f.corner[1][i][j] - f.corner[0][i][j];
      slope.y() += f.corner[i][1][j] - f.corner[i][0][j];
      slope.z() += f.corner[i][j][1] - f.corner[i][j][0];
    }
  int axis = 2;
  slope.cwiseAbs().maxCoeff(&axis);
  Coverage coverage = add_rows(permuted(f, (axis + 1) % 3), rows);
  const Vec3 o = coverage.offset;
  if (axis == 1) coverage.offset = Vec3(o.y(), o.z(), o.x());
  if (axis == 0) coverage.offset = Vec3(o.z(), o.x(), o.y());
  return coverage;
}

}  // namespace

Coverage sample_coverage(const std::function<double(const Vec3&)>& distance, const Vec3& center, double voxel_size,
                         int subsamples) {
  if (subsamples == 1) return {distance(center) < 0 ? 1.0 : 0.0, Vec3::Zero()};
  double volume = 0;
  Vec3 moment = Vec3::Zero();
  const double cell = voxel_size / subsamples;
  for (int a = 0; a < subsamples; ++a)
    for (int b = 0; b < subsamples; ++b)
      for (int c = 0; c < subsamples; ++c) {
        const Vec3 offset = (Vec3(a, b, c).array() + 0.5) / subsamples - 0.5;
        const double weight = std::clamp(0.5 - distance(center + voxel_size * offset) / cell, 0.0, 1.0);
        volume += weight;
        moment += weight * offset;
      }
  const double all = double(subsamples) * subsamples * subsamples;
  return coverage_of(volume / all, moment / all);
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
  if (subsamples_ == 1) return {value(i, j, k) < 0 ? 1.0 : 0.0, Vec3::Zero()};
  VoxelPolynomial f{};
  double mean = 0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c) {
        f.corner[a][b][c] = value(i - 1 + 2 * a, j - 1 + 2 * b, k - 1 + 2 * c);
        mean += f.corner[a][b][c] / 8;
      }
  // In the middle of a face the parabolas along the two axes of the face add up; in the centre all three do.
  const double centre = value(i, j, k) - mean;
  double face[3][2];  // value in the middle of a face minus the mean of its corners
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
    smooth &= std::abs(f.bend[axis]) <= kMaxBend * frame_.voxel_size;
  }
  smooth &= std::abs(2 * centre - faces) <= agreement;
  if (smooth) return integrate(f, subsamples_);
  return sample_coverage(distance_, frame_.center({origin_[0] + x, origin_[1] + y, origin_[2] + z}), frame_.voxel_size,
                         subsamples_);
}

}  // namespace hapticut
