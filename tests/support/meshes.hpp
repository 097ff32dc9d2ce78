// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/mesh.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::test {

/// A ball of `rings` by 2 `rings` patches. Its triangles are counter-clockwise seen from outside.
inline TriangleMesh ball_mesh(const Vec3& center, double radius, int rings) {
  TriangleMesh mesh;
  const int around = 2 * rings;
  const auto vertex = [&](int ring, int n) {
    const double polar = units::kPi * ring / rings, azimuth = 2 * units::kPi * n / around;
    return Vec3(center + radius * Vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                                       std::cos(polar)));
  };
  mesh.vertices.push_back(vertex(0, 0));
  for (int ring = 1; ring < rings; ++ring)
    for (int n = 0; n < around; ++n) mesh.vertices.push_back(vertex(ring, n));
  mesh.vertices.push_back(vertex(rings, 0));
  const auto id = [&](int ring, int n) {
    if (ring == 0) return std::uint32_t(0);
    if (ring == rings) return std::uint32_t(mesh.vertices.size() - 1);
    return std::uint32_t(1 + (ring - 1) * around + n % around);
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int n = 0; n < around; ++n) {
      if (ring > 0) mesh.triangles.push_back({id(ring, n), id(ring + 1, n), id(ring, n + 1)});
      if (ring + 1 < rings) mesh.triangles.push_back({id(ring, n + 1), id(ring + 1, n), id(ring + 1, n + 1)});
    }
  return mesh;
}

/// A cube whose faces are `cells` by `cells` squares of two triangles each; each face has its own vertices.
inline TriangleMesh cube_mesh(const Vec3& min, double edge, int cells) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const auto first = std::uint32_t(mesh.vertices.size());
      for (int a = 0; a <= cells; ++a)
        for (int b = 0; b <= cells; ++b) {
          Vec3 p;
          p[axis] = side;
          p[(axis + 1) % 3] = double(a) / cells;
          p[(axis + 2) % 3] = double(b) / cells;
          mesh.vertices.push_back(min + edge * p);
        }
      for (int a = 0; a < cells; ++a)
        for (int b = 0; b < cells; ++b) {
          const auto at = [&](int i, int j) { return first + std::uint32_t((a + i) * (cells + 1) + b + j); };
          if (side == 1) {
            mesh.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
            mesh.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
          } else {
            mesh.triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
            mesh.triangles.push_back({at(0, 0), at(0, 1), at(1, 1)});
          }
        }
    }
  return mesh;
}

/// Two meshes as one, each with its own vertices.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = std::uint32_t(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
  return mesh;
}

}  // namespace hapticut::test
