// SPDX-License-Identifier: Apache-2.0
#include "import/mesh/meridian_fit.hpp"

#include <cmath>
#include <optional>

#include "hapticut/core/units.hpp"

namespace hapticut::detail {
namespace {

using units::deg;
using units::kPi;

constexpr std::size_t kMinArc = 4;      // segments
constexpr double kMaxAngle = 35 * deg;  // from one segment of an arc to the next

/// [rad] Change of direction at b.
double angle_at(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::atan2(cross(b - a, c - b), (b - a).dot(c - b));
}

bool line_fits(const std::vector<Vec2>& points, std::size_t from, std::size_t to, double tolerance) {
  const Vec2 along = (points[to] - points[from]).normalized();
  double reached = 0;
  for (std::size_t n = from + 1; n < to; ++n) {
    const Vec2 v = points[n] - points[from];
    if (std::abs(cross(along, v)) > tolerance || along.dot(v) < reached - tolerance) return false;
    reached = along.dot(v);
  }
  return true;
}

/// Signed radius of the arc from one point to another that fits the points between them best; nothing if none fits.
std::optional<double> fit_arc(const std::vector<Vec2>& points, std::size_t from, std::size_t to, double tolerance) {
  if (to - from < kMinArc) return {};
  double total = 0;
  for (std::size_t n = from + 1; n < to; ++n) {
    const double angle = angle_at(points[n - 1], points[n], points[n + 1]);
    if (std::abs(angle) > kMaxAngle) return {};
    total += angle;
  }
  if (std::abs(total) > kPi) return {};
  // Centres on the bisector of the chord, at a signed height h to its left: |p - m|^2 - 2 h (p - m).left = half^2.
  const Vec2 chord = points[to] - points[from], middle = (points[from] + points[to]) / 2;
  const double half = chord.norm() / 2;
  const Vec2 left = left_of(chord / (2 * half));
  double product = 0, squares = 0;
  for (std::size_t n = from + 1; n < to; ++n) {
    const Vec2 v = points[n] - middle;
    const double side = 2 * v.dot(left);
    product += side * (v.squaredNorm() - half * half);
    squares += side * side;
  }
  if (!(squares > 0)) return {};
  const double height = product / squares, sign = total > 0 ? 1 : -1;
  if (sign * height < -tolerance) return {};  // more than half a circle
  const Vec2 center = middle + (sign * height > 0 ? height : 0) * left;
  const double radius = std::hypot(half, sign * height > 0 ? height : 0);
  for (std::size_t n = from + 1; n < to; ++n)
    if (std::abs((points[n] - center).norm() - radius) > tolerance) return {};
  return sign * radius;
}

}  // namespace

std::vector<ProfileEdge> fit_lines_and_arcs(const std::vector<Vec2>& points, double tolerance) {
  std::vector<ProfileEdge> edges;
  for (std::size_t from = 0; from + 1 < points.size();) {
    std::size_t line = from + 1;
    while (line + 1 < points.size() && line_fits(points, from, line + 1, tolerance)) ++line;
    std::size_t arc = from;
    double radius = 0;
    for (std::size_t to = from + kMinArc; to < points.size(); ++to) {
      const std::optional<double> fitted = fit_arc(points, from, to, tolerance);
      if (!fitted && to > arc + kMinArc && to > from + 2 * kMinArc) break;
      if (!fitted) continue;
      arc = to;
      radius = *fitted;
    }
    const bool is_arc = arc > line;
    from = is_arc ? arc : line;
    edges.push_back({points[from].x(), points[from].y(), is_arc ? radius : 0});
  }
  return edges;
}

}  // namespace hapticut::detail
