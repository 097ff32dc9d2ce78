// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

#include "hapticut/core/mesh.hpp"

namespace hapticut::test {

/// Enclosed volume by the divergence theorem, positive for counter-clockwise triangles seen from outside. [m^3]
inline double signed_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  return sum / 6;
}

/// [m^2]
inline double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
  return sum / 2;
}

/// Whether each edge is passed as often in one direction as in the other.
inline bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : mesh.triangles)
    for (int n = 0; n < 3; ++n) {
      const auto a = t[std::size_t(n)], b = t[std::size_t((n + 1) % 3)];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  for (const auto& [edge, sum] : balance)
    if (sum != 0) return false;
  return !mesh.triangles.empty();
}

}  // namespace hapticut::test
