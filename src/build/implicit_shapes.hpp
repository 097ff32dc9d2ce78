// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/spatial.hpp"

/// @file
/// Signed distances of simple shapes, and their rounded union. Negative inside. All functions change by at most one per
/// unit of length, because the gradient of a blend is a weighted mean of the gradients of its parts.
namespace hapticut::implicit {

/// Union of a and b with a seam rounded over a width `blend` >= 0; equals min(a, b) where they differ by more than
/// that.
[[nodiscard]] inline double join(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - (blend > 0 ? overlap * overlap / (4 * blend) : 0.0);
}

[[nodiscard]] inline double ball(const Vec3& p, const Vec3& center, double radius) {
  return (p - center).norm() - radius;
}

/// A box whose edges and corners are rounded by `radius`; `half` is half its size, rounding included.
[[nodiscard]] inline double rounded_box(const Vec3& p, const Vec3& center, const Vec3& half, double radius) {
  const Vec3 q = (p - center).cwiseAbs() - half + Vec3::Constant(radius);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

/// The convex hull of two balls.
class RoundCone {
 public:
  RoundCone() = default;
  /// @pre the balls do not contain each other: |b - a| > |radius_a - radius_b|
  RoundCone(const Vec3& a, double radius_a, const Vec3& b, double radius_b)
      : a_(a), length_((b - a).norm()), radius_a_(radius_a), radius_b_(radius_b) {
    axis_ = (b - a) / length_;
    sine_ = (radius_a - radius_b) / length_;
    cosine_ = std::sqrt(1 - sine_ * sine_);
  }

  [[nodiscard]] double operator()(const Vec3& p) const {
    const Vec3 from_a = p - a_;
    const double along = from_a.dot(axis_);
    const double aside = std::sqrt(std::max(from_a.squaredNorm() - along * along, 0.0));
    // Position of the point along the nearest generatrix.
    const double foot = along * cosine_ - aside * sine_;
    if (foot <= 0) return std::hypot(along, aside) - radius_a_;
    if (foot >= length_ * cosine_) return std::hypot(along - length_, aside) - radius_b_;
    return along * sine_ + aside * cosine_ - radius_a_;
  }

 private:
  Vec3 a_ = Vec3::Zero();
  Vec3 axis_ = Vec3::UnitZ();
  double length_ = 0;
  double radius_a_ = 0;
  double radius_b_ = 0;
  double sine_ = 0;
  double cosine_ = 1;
};

}  // namespace hapticut::implicit
