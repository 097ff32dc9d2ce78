// SPDX-License-Identifier: Apache-2.0
#include "settings/curves.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::settings {
namespace {

constexpr double kAngleStep = 0.5 * units::deg;
constexpr double kMaxPoints = 1e7;  // points of a curve; `drill` refuses as many steps

/// @param turns  [1] number of turns of the curve
/// @param cause  the settings that cause the length
void require_points(double turns, const Sentence& cause) {
  const double points = turns * 2 * units::kPi / kAngleStep;
  if (!(points <= kMaxPoints))
    throw Error("the path would have " + format_number(points) + " points; at most " + format_number(kMaxPoints) +
                " are possible. Change " + cause + ".");
}

/// A point of a curve around an axis.
struct Station {
  double angle;   // [rad]
  double radius;  // [m]
  double depth;   // [m]
};

/// Adds the points from one station to the next, without the first.
void add_arc(const Pose& frame, const Station& from, const Station& to, std::vector<Vec3>& points) {
  const int steps = std::max(1, int(std::ceil(std::abs(to.angle - from.angle) / kAngleStep - 1e-9)));
  for (int i = 1; i <= steps; ++i) {
    const double s = double(i) / steps;
    const double angle = std::lerp(from.angle, to.angle, s), radius = std::lerp(from.radius, to.radius, s);
    points.push_back(frame *
                     Vec3(radius * std::cos(angle), radius * std::sin(angle), -std::lerp(from.depth, to.depth, s)));
  }
}

std::vector<Vec3> polyline(const CurvePlane& plane, const std::vector<Station>& stations) {
  const Pose frame = plane.frame();
  std::vector<Vec3> points;
  add_arc(frame, stations.front(), stations.front(), points);
  for (std::size_t i = 1; i < stations.size(); ++i) add_arc(frame, stations[i - 1], stations[i], points);
  return points;
}

}  // namespace

Pose CurvePlane::frame() const {
  const Vec3 z = axis.normalized();
  const Vec3 hint = std::abs(z.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 x = (hint - hint.dot(z) * z).normalized();
  Pose pose;
  pose.rotation << x, z.cross(x), z;
  pose.translation = center;
  return pose;
}

std::vector<Vec3> circle(const CurvePlane& plane, double radius, double turns, double start_angle) {
  require_points(std::abs(turns), "path.turns"_name);
  return polyline(plane, {{start_angle, radius, 0}, {start_angle + 2 * units::kPi * turns, radius, 0}});
}

std::vector<Vec3> spiral(const CurvePlane& plane, double start_radius, double end_radius, double pitch, double depth) {
  const double turns = std::hypot(end_radius - start_radius, depth) / pitch;
  require_points(turns, "path.depth_mm"_name + " or " + "path.pitch_mm"_name);
  return polyline(plane, {{0, start_radius, 0}, {2 * units::kPi * turns, end_radius, depth}});
}

std::vector<Vec3> cavity(const CurvePlane& plane, const CavityShape& shape) {
  const double widest = std::max(shape.top_radius, shape.bottom_radius);
  require_points((shape.depth / shape.layer + 1) * (widest / shape.pitch + 2),
                 "path.depth_mm"_name + ", " + "path.layer_mm"_name + " or " + "path.pitch_mm"_name);
  const int layers = std::max(1, int(std::ceil(shape.depth / shape.layer - 1e-9)));
  std::vector<Station> stations;
  double angle = 0;
  for (int i = 0; i < layers; ++i) {
    const double depth = shape.depth * (i + 1) / layers;
    const double radius =
        layers == 1 ? shape.top_radius : std::lerp(shape.top_radius, shape.bottom_radius, double(i) / (layers - 1));
    const double winding = 2 * units::kPi * std::ceil(radius / shape.pitch - 1e-9);
    const double wall = 2 * units::kPi;
    if (i % 2 == 0) {
      stations.push_back({angle, 0, depth});
      stations.push_back({angle += winding, radius, depth});
      stations.push_back({angle += wall, radius, depth});
    } else {
      stations.push_back({angle, radius, depth});
      stations.push_back({angle += wall, radius, depth});
      stations.push_back({angle += winding, 0, depth});
    }
  }
  return polyline(plane, stations);
}

}  // namespace hapticut::settings
