// SPDX-License-Identifier: Apache-2.0
#include "workpiece/orient.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace hapticut {
namespace {

/// One side of a triangle, seen from its smaller vertex.
struct Side {
  std::uint64_t vertices;  // both, the smaller one first
  std::uint32_t triangle;
  bool upwards;  // the triangle goes from the smaller to the larger one
};

/// A way from a triangle to its neighbour across a side that has no third.
struct Neighbour {
  std::uint32_t triangle;
  bool alike;  // both turn the same way
};

std::vector<Side> sides_of(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t n = 0; n < 3; ++n) {
      const std::uint32_t a = mesh.triangles[t][n], b = mesh.triangles[t][(n + 1) % 3];
      sides.push_back({std::uint64_t(std::min(a, b)) << 32U | std::max(a, b), std::uint32_t(t), a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.vertices < b.vertices; });
  return sides;
}

double six_volumes(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
}

}  // namespace

void orient_alike(TriangleMesh& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
  bool all_alike = true;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].vertices == sides[begin].vertices) ++end;
    if (end - begin != 2) continue;
    const Side &a = sides[begin], &b = sides[begin + 1];
    const bool alike = a.upwards != b.upwards;
    all_alike &= alike;
    neighbours[a.triangle].push_back({b.triangle, alike});
    neighbours[b.triangle].push_back({a.triangle, alike});
  }
  if (all_alike) return;

  enum : std::uint8_t { kUnseen, kKept, kTurned };
  std::vector<std::uint8_t> state(mesh.triangles.size(), kUnseen);
  for (std::uint32_t first = 0; first < state.size(); ++first) {
    if (state[first] != kUnseen) continue;
    std::vector<std::uint32_t> piece = {first};
    state[first] = kKept;
    bool possible = true;
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (const Neighbour& next : neighbours[piece[n]]) {
        const std::uint8_t wanted = (state[piece[n]] == kKept) == next.alike ? kKept : kTurned;
        if (state[next.triangle] == kUnseen) {
          state[next.triangle] = wanted;
          piece.push_back(next.triangle);
        }
        possible &= state[next.triangle] == wanted;
      }
    if (!possible) continue;  // a surface with one side only
    // Most triangles stay as they are; where that does not tell, the piece encloses something.
    std::size_t turned = 0;
    double volume = 0;
    for (const std::uint32_t t : piece) {
      turned += state[t] == kTurned ? 1 : 0;
      volume += state[t] == kTurned ? -six_volumes(mesh, t) : six_volumes(mesh, t);
    }
    const bool other = 2 * turned == piece.size() ? volume < 0 : 2 * turned > piece.size();
    for (const std::uint32_t t : piece)
      if ((state[t] == kTurned) != other) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
}

}  // namespace hapticut
