// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/mesh_of_revolution.hpp"
#include "tool/meridian.hpp"

namespace hapticut {
namespace {

using detail::Vec2;
using units::kPi;

constexpr double kMaxChordAngle = kPi / 8;  // [rad] from one chord of an arc to the next

/// Points along the meridian. Chords deviate from their arcs by at most as much as the facets from the largest circle.
std::vector<Vec2> points_of(const detail::Meridian& meridian, int sides) {
  const double sagitta = meridian.radius() * (1 - std::cos(kPi / sides));
  std::vector<Vec2> points = {meridian.edges().front().from};
  for (const detail::MeridianEdge& e : meridian.edges()) {
    int parts = 1;
    if (!e.straight()) {
      const double angle = std::min(2 * std::acos(std::max(0.0, 1 - sagitta / e.radius())), kMaxChordAngle);
      parts = int(std::ceil(std::abs(e.sweep) / angle));
    }
    for (int n = 1; n < parts; ++n) points.push_back(e.at_angle(std::abs(e.sweep) * n / parts));
    points.push_back(e.to);
  }
  points.back().x() = 0;
  return points;
}

}  // namespace

TriangleMesh mesh_of_revolution(const Profile& profile, int sides) {
  require_between(sides, 3, 10000, "mesh_of_revolution sides");
  const std::vector<Vec2> points = points_of(detail::Meridian(profile), sides);
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, points.front().y());
  for (std::size_t ring = 1; ring + 1 < points.size(); ++ring)
    for (int n = 0; n < sides; ++n) {
      const double angle = 2 * kPi * n / sides;
      mesh.vertices.emplace_back(points[ring].x() * std::cos(angle), points[ring].x() * std::sin(angle),
                                 points[ring].y());
    }
  mesh.vertices.emplace_back(0, 0, points.back().y());

  const auto last = std::uint32_t(mesh.vertices.size() - 1);
  const std::size_t rings = points.size() - 2;
  const auto at = [&](std::size_t ring, int n) {
    return std::uint32_t(1 + ring * std::size_t(sides) + std::size_t(n % sides));
  };
  for (int n = 0; n < sides; ++n) {
    mesh.triangles.push_back({0, at(0, n + 1), at(0, n)});
    for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, n), at(ring, n + 1), at(ring + 1, n + 1)});
      mesh.triangles.push_back({at(ring, n), at(ring + 1, n + 1), at(ring + 1, n)});
    }
    mesh.triangles.push_back({at(rings - 1, n), at(rings - 1, n + 1), last});
  }
  return mesh;
}

}  // namespace hapticut
