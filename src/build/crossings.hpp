// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "build/winding_number.hpp"

/// @file
/// Triangles against cubes and against segments.
namespace hapticut {

/// Whether a triangle touches a cube, by the separating axes of the cube, of the triangle and of their edges.
inline bool touches_cube(const WindingNumber::Triangle& triangle, const Vec3& center, double half) {
  const std::array<Vec3, 3> v = {triangle[0] - center, triangle[1] - center, triangle[2] - center};
  const auto separated = [&](const Vec3& axis) {
    const double a = axis.dot(v[0]), b = axis.dot(v[1]), c = axis.dot(v[2]);
    const double reach = half * axis.cwiseAbs().sum() * (1 + 1e-9);
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
  };
  const std::array<Vec3, 3> edges = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  for (int axis = 0; axis < 3; ++axis) {
    if (separated(Vec3::Unit(axis))) return false;
    for (const Vec3& edge : edges)
      if (separated(Vec3::Unit(axis).cross(edge))) return false;
  }
  return !separated(edges[0].cross(edges[1]));
}

/// Counts how often segments from a fixed point cross triangles from the outside to the inside.
class Crossings {
 public:
  using Triangle = WindingNumber::Triangle;

  Crossings(const Vec3& from, const Triangle* const* begin, const Triangle* const* end) : from_(from) {
    for (; begin != end; ++begin) {
      const Triangle& t = **begin;
      const Vec3 a = t[0] - from, b = t[1] - from, c = t[2] - from;
      const Vec3 normal = (b - a).cross(c - a);
      faces_.push_back({normal, normal.dot(a), a.cross(b), b.cross(c), c.cross(a)});
    }
  }

  [[nodiscard]] int to(const Vec3& point) const {
    const Vec3 d = point - from_;
    int count = 0;
    for (const Face& face : faces_) {
      const bool from_outside = face.height < 0;
      if (from_outside == (face.normal.dot(d) - face.height > 0)) continue;  // both ends on one side
      const bool left = face.ab.dot(d) > 0;
      if (left != (face.bc.dot(d) > 0) || left != (face.ca.dot(d) > 0)) continue;
      count += from_outside ? 1 : -1;
    }
    return count;
  }

 private:
  struct Face {
    Vec3 normal;
    double height;  // height of the plane above the fixed point, along the normal and times its length
    Vec3 ab, bc, ca;
  };
  Vec3 from_;
  std::vector<Face> faces_;
};

}  // namespace hapticut
