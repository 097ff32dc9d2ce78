// SPDX-License-Identifier: Apache-2.0
#include "build/pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "build/repeated_faces.hpp"

namespace hapticut {
namespace {

/// One side of a triangle, seen from its smaller place.
struct SideOfTriangle {
  std::uint32_t from, to;  // places, the smaller one first
  std::uint32_t opposite;  // place of the third corner
  std::uint32_t triangle;
  bool upwards;  // the triangle goes from the smaller to the larger one

  [[nodiscard]] bool is_at(const SideOfTriangle& other) const { return from == other.from && to == other.to; }
};

std::vector<SideOfTriangle> sides_of_triangles(const TriangleMesh& mesh, const std::vector<std::uint32_t>& places) {
  std::vector<SideOfTriangle> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t n = 0; n < 3; ++n) {
      const std::uint32_t a = places[mesh.triangles[t][n]], b = places[mesh.triangles[t][(n + 1) % 3]],
                          c = places[mesh.triangles[t][(n + 2) % 3]];
      sides.push_back({std::min(a, b), std::max(a, b), c, t, a < b});
    }
  std::ranges::sort(
      sides, {}, [](const SideOfTriangle& s) { return std::tuple(s.from, s.to, s.opposite, s.triangle, s.upwards); });
  return sides;
}

/// Whether the triangles at a side are two faces, each there equally often and always the same way round.
bool are_two_faces(const SideOfTriangle* begin, std::size_t count) {
  if (count % 2 != 0) return false;
  for (std::size_t n = 0; n < count; ++n) {
    const SideOfTriangle& first = begin[n < count / 2 ? 0 : count / 2];
    if (begin[n].opposite != first.opposite || begin[n].upwards != first.upwards) return false;
  }
  return count == 2 || begin[0].opposite != begin[count / 2].opposite;
}

double six_volumes_of(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
}

/// Whether a triangle runs along a side from its first to its second end.
bool runs_along(const TriangleMesh& mesh, const Connections& connections, std::uint32_t t,
                const Connections::LooseSide& side) {
  for (std::size_t n = 0; n < 3; ++n)
    if (connections.places[mesh.triangles[t][n]] == side.from &&
        connections.places[mesh.triangles[t][(n + 1) % 3]] == side.to)
      return true;
  return false;
}

/// Numbers the connected components.  @return the number of each triangle's component
std::vector<std::uint32_t> components_in(const Connections& connections) {
  constexpr auto kNone = std::uint32_t(-1);
  std::vector<std::uint32_t> component(connections.neighbours.size(), kNone), queue;
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < component.size(); ++first) {
    if (component[first] != kNone) continue;
    component[first] = count;
    queue = {first};
    for (std::size_t n = 0; n < queue.size(); ++n)
      for (const NeighbourTriangle& next : connections.neighbours[queue[n]])
        if (component[next.triangle] == kNone) {
          component[next.triangle] = count;
          queue.push_back(next.triangle);
        }
    ++count;
  }
  return component;
}

/// A component that is open at a side.
struct OpenEnd {
  std::uint32_t component;
  bool upwards;
  [[nodiscard]] bool operator==(const OpenEnd&) const = default;
};

using OpenEnds = std::vector<std::vector<OpenEnd>>;  // at each loose side

/// The components that are open at each loose side: two triangles of one component that run in opposite ways close it.
OpenEnds open_ends_of(const TriangleMesh& mesh, const Connections& connections,
                      const std::vector<std::uint32_t>& component) {
  OpenEnds ends(connections.loose.size());
  for (std::size_t s = 0; s < ends.size(); ++s)
    for (const std::uint32_t t : connections.loose[s].triangles) {
      const OpenEnd end{component[t], runs_along(mesh, connections, t, connections.loose[s])};
      const auto counterpart = std::ranges::find(ends[s], OpenEnd{end.component, !end.upwards});
      if (counterpart != ends[s].end())
        ends[s].erase(counterpart);
      else
        ends[s].push_back(end);
    }
  return ends;
}

/// Joins each open component to another that closes all its open ends at sides of several components, small ones first.
/// @return the number of the joined component of each component
std::vector<std::uint32_t> joined_components(OpenEnds& ends, const std::vector<std::size_t>& triangles) {
  struct Place {
    std::size_t side;
    bool upwards;
  };
  std::vector<std::vector<Place>> places(triangles.size());
  for (std::size_t s = 0; s < ends.size(); ++s)
    for (const OpenEnd& end : ends[s])
      if (ends[s].size() > 1) places[end.component].push_back({s, end.upwards});
  std::vector<std::uint32_t> order(triangles.size()), parent(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::iota(parent.begin(), parent.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t p) { return triangles[p]; });
  const auto root_of = [&](std::uint32_t p) {
    while (parent[p] != p) p = parent[p];
    return p;
  };
  const auto has = [&](const Place& at, const OpenEnd& end) { return std::ranges::count(ends[at.side], end) > 0; };
  for (const std::uint32_t component : order) {
    std::vector<Place>& open = places[component];
    std::erase_if(open, [&](const Place& at) { return !has(at, {component, at.upwards}); });
    if (open.empty()) continue;
    for (const OpenEnd& candidate : ends[open.front().side]) {
      const std::uint32_t other = candidate.component;
      const auto continues = [&](const Place& at) { return has(at, {other, !at.upwards}); };
      if (root_of(other) == component || !std::ranges::all_of(open, continues)) continue;
      for (const Place& at : open)
        for (const OpenEnd& end : {OpenEnd{component, at.upwards}, OpenEnd{other, !at.upwards}}) {
          const auto found = std::ranges::find(ends[at.side], end);
          if (found != ends[at.side].end()) ends[at.side].erase(found);
        }
      parent[component] = other;
      break;
    }
  }
  for (std::uint32_t& p : parent) p = root_of(p);
  return parent;
}

/// Sets the ends of a piece from its triangles.
void find_ends(const TriangleMesh& mesh, Piece& piece) {
  piece.ends.fill(mesh.vertices[mesh.triangles[piece.triangles.front()][0]]);
  for (const std::uint32_t t : piece.triangles)
    for (const std::uint32_t v : mesh.triangles[t])
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3& vertex = mesh.vertices[v];
        Vec3 &low = piece.ends[2 * std::size_t(axis)], &high = piece.ends[2 * std::size_t(axis) + 1];
        if (vertex[axis] < low[axis]) low = vertex;
        if (vertex[axis] > high[axis]) high = vertex;
      }
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 &low = piece.ends[2 * std::size_t(axis)], &high = piece.ends[2 * std::size_t(axis) + 1];
    const double beyond = 1e-6 * (high[axis] - low[axis]);
    low[axis] -= beyond;
    high[axis] += beyond;
  }
}

}  // namespace

std::size_t Connections::open_sides() const {
  return std::size_t(std::ranges::count_if(loose, [](const LooseSide& side) { return side.triangles.size() == 1; }));
}

Connections connections_in(const TriangleMesh& mesh) {
  Connections connections;
  connections.places = places_of(mesh.vertices);
  connections.neighbours.resize(mesh.triangles.size());
  const std::vector<SideOfTriangle> sides = sides_of_triangles(mesh, connections.places);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].is_at(sides[begin])) ++end;
    if (sides[begin].from == sides[begin].to) continue;
    const std::size_t count = end - begin;
    if (!are_two_faces(&sides[begin], count)) {
      Connections::LooseSide side{sides[begin].from, sides[begin].to, {}};
      for (std::size_t n = begin; n < end; ++n) side.triangles.push_back(sides[n].triangle);
      connections.loose.push_back(std::move(side));
      continue;
    }
    for (std::size_t n = begin; n < begin + count / 2; ++n) {
      const SideOfTriangle &a = sides[n], &b = sides[n + count / 2];
      const bool alike = a.upwards != b.upwards;
      connections.all_alike &= alike;
      connections.neighbours[a.triangle].push_back({b.triangle, alike});
      connections.neighbours[b.triangle].push_back({a.triangle, alike});
    }
  }
  return connections;
}

std::vector<Piece> pieces_of(const TriangleMesh& mesh, const Connections& connections) {
  if (mesh.triangles.empty()) return {};
  const std::vector<std::uint32_t> component = components_in(connections);
  std::vector<std::size_t> triangles(*std::ranges::max_element(component) + std::size_t(1), 0);
  for (const std::uint32_t p : component) ++triangles[p];
  OpenEnds ends = open_ends_of(mesh, connections, component);
  const std::vector<std::uint32_t> joined = joined_components(ends, triangles);
  std::vector<Piece> pieces(triangles.size());
  for (std::uint32_t t = 0; t < component.size(); ++t) {
    Piece& piece = pieces[joined[component[t]]];
    piece.triangles.push_back(t);
    piece.six_volumes += six_volumes_of(mesh, t);
  }
  for (const std::vector<OpenEnd>& side : ends)
    for (const OpenEnd& end : side) pieces[joined[end.component]].closed = false;
  std::erase_if(pieces, [](const Piece& piece) { return piece.triangles.empty(); });
  for (Piece& piece : pieces) find_ends(mesh, piece);
  return pieces;
}

std::vector<Vec3> points_inside(const TriangleMesh& mesh, const Piece& piece) {
  constexpr std::size_t kMaxPoints = 64;
  constexpr double kBesideFace = 1e-6;  // [edges of a face]
  std::vector<Vec3> points;
  const std::size_t stride = (piece.triangles.size() + kMaxPoints - 1) / kMaxPoints;
  for (std::size_t n = 0; n < piece.triangles.size(); n += stride) {
    const auto& [a, b, c] = mesh.triangles[piece.triangles[n]];
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    const Vec3 area = (q - p).cross(r - p);
    if (!(area.norm() > 0)) continue;
    const double inwards = piece.six_volumes < 0 ? kBesideFace : -kBesideFace;
    points.emplace_back((p + q + r) / 3 + inwards * std::sqrt(area.norm()) * area.normalized());
  }
  return points;
}

}  // namespace hapticut
