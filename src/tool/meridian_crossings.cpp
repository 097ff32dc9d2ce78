// SPDX-License-Identifier: Apache-2.0
// Where two edges of a meridian meet.
#include <algorithm>
#include <cmath>
#include <vector>

#include "hapticut/core/units.hpp"
#include "tool/meridian.hpp"

namespace hapticut::detail {
namespace {

using units::kPi;

/// Whether a point on the edge's line or circle lies on the edge.
bool contains(const MeridianEdge& e, const Vec2& p, double tolerance) {
  if (e.straight()) {
    const double along = e.start_tangent.dot(p - e.from);
    return along >= -tolerance && along <= (e.to - e.from).norm() + tolerance;
  }
  const double angle = e.angle_of(p), slack = tolerance / e.radius();
  return angle <= std::abs(e.sweep) + slack || angle >= 2 * kPi - slack;
}

/// Points of a line at a distance `radius` from a centre.
std::vector<Vec2> on_line(const MeridianEdge& line, const Vec2& center, double radius) {
  const Vec2 foot = line.from + line.start_tangent.dot(center - line.from) * line.start_tangent;
  const double square = radius * radius - (foot - center).squaredNorm();
  if (square < 0) return {};
  const double half = std::sqrt(square);
  return {foot - half * line.start_tangent, foot + half * line.start_tangent};
}

std::vector<Vec2> candidates(const MeridianEdge& a, const MeridianEdge& b, double tolerance) {
  std::vector<Vec2> points = {a.from, a.to, b.from, b.to};  // for edges that overlap
  std::erase_if(points, [&](const Vec2& p) {
    const auto off = [&](const MeridianEdge& e) {
      return e.straight() ? std::abs(cross(e.start_tangent, p - e.from)) : std::abs((p - e.center).norm() - e.radius());
    };
    return off(a) > tolerance || off(b) > tolerance;
  });
  const auto add = [&](const std::vector<Vec2>& more) { points.insert(points.end(), more.begin(), more.end()); };
  if (a.straight() && b.straight()) {
    const double sine = cross(a.start_tangent, b.start_tangent);
    if (std::abs(sine) > 1e-12)
      points.emplace_back(a.from + cross(b.from - a.from, b.start_tangent) / sine * a.start_tangent);
  } else if (a.straight()) {
    add(on_line(a, b.center, b.radius()));
  } else if (b.straight()) {
    add(on_line(b, a.center, a.radius()));
  } else {
    const Vec2 between = b.center - a.center;
    const double distance = between.norm();
    if (distance > tolerance) {
      const double to_chord =
          (distance * distance + a.radius() * a.radius() - b.radius() * b.radius()) / (2 * distance);
      const double square = a.radius() * a.radius() - to_chord * to_chord;
      if (square >= 0) {
        const Vec2 middle = a.center + to_chord / distance * between, across = left_of(between / distance);
        add({middle - std::sqrt(square) * across, middle + std::sqrt(square) * across});
      }
    }
  }
  return points;
}

}  // namespace

std::vector<Vec2> crossings(const MeridianEdge& a, const MeridianEdge& b, double tolerance) {
  std::vector<Vec2> points = candidates(a, b, tolerance);
  std::erase_if(points, [&](const Vec2& p) { return !contains(a, p, tolerance) || !contains(b, p, tolerance); });
  return points;
}

}  // namespace hapticut::detail
