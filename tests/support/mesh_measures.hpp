// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
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

/// How often triangles use the edges of a mesh.
struct EdgeCount {
  bool balanced = true;        ///< each equally often in both directions
  std::size_t twice = 0;       ///< once in each direction
  std::size_t more_often = 0;  ///< twice in each direction: two bodies touch along it
};

inline EdgeCount count_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t n = 0; n < 3; ++n) {
      const auto a = t[n], b = t[(n + 1) % 3];
      auto& [there, back] = edges[{std::min(a, b), std::max(a, b)}];
      ++(a < b ? there : back);
    }
  EdgeCount count;
  for (const auto& [edge, passed] : edges) {
    count.balanced = count.balanced && passed.first == passed.second && edge.first != edge.second;
    ++(passed.first == 1 ? count.twice : count.more_often);
  }
  return count;
}

/// Whether each edge is used equally often in both directions.
inline bool is_closed(const TriangleMesh& mesh) { return !mesh.triangles.empty() && count_edges(mesh).balanced; }

}  // namespace hapticut::test
