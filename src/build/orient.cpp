// SPDX-License-Identifier: Apache-2.0
#include "build/orient.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ranges>
#include <utility>
#include <vector>

#include "build/repeated_faces.hpp"
#include "build/winding_number.hpp"
#include "core/interruption.hpp"

namespace hapticut {
namespace {

/// One side of a triangle, seen from its smaller vertex.
struct Side {
  std::uint64_t vertices;  // both, the smaller one first
  std::uint32_t triangle;
  bool upwards;  // the triangle goes from the smaller to the larger one
};

/// A neighbour of a triangle across a side of exactly two triangles.
struct Neighbour {
  std::uint32_t triangle;
  bool alike;  // both have the same orientation
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

struct Neighbours {
  std::vector<std::vector<Neighbour>> of;  // each triangle
  bool all_alike = true;
};

Neighbours neighbours_in(const TriangleMesh& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  Neighbours neighbours;
  neighbours.of.resize(mesh.triangles.size());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].vertices == sides[begin].vertices) ++end;
    if (end - begin != 2) continue;
    const Side &a = sides[begin], &b = sides[begin + 1];
    const bool alike = a.upwards != b.upwards;
    neighbours.all_alike &= alike;
    neighbours.of[a.triangle].push_back({b.triangle, alike});
    neighbours.of[b.triangle].push_back({a.triangle, alike});
  }
  return neighbours;
}

/// A part of a surface, connected by sides of exactly two triangles.
struct Piece {
  std::vector<std::uint32_t> triangles;
  bool closed = true;
  double six_volumes = 0;    // [m^3] negative: it faces inwards
  std::array<Vec3, 6> ends;  // [m] points slightly beyond the extreme vertices along each axis, outside of the piece
};

std::vector<Piece> pieces_of(const TriangleMesh& mesh, const std::vector<std::vector<Neighbour>>& neighbours) {
  std::vector<Piece> pieces;
  std::vector<bool> seen(mesh.triangles.size(), false);
  for (std::uint32_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    Piece piece;
    piece.triangles = {first};
    for (std::size_t n = 0; n < piece.triangles.size(); ++n) {
      const std::uint32_t t = piece.triangles[n];
      piece.closed &= neighbours[t].size() == 3;
      piece.six_volumes += six_volumes(mesh, t);
      for (const Neighbour& next : neighbours[t])
        if (!seen[next.triangle]) {
          seen[next.triangle] = true;
          piece.triangles.push_back(next.triangle);
        }
    }
    piece.ends.fill(mesh.vertices[mesh.triangles[first][0]]);
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
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Whether a surface winds around all ends of a piece, independent of its orientation.
bool encloses(const WindingNumber& surface, const Piece& piece) {
  return std::ranges::all_of(piece.ends, [&](const Vec3& end) { return std::abs(surface.at(end)) > 0.5; });
}

/// Whether the box around a piece contains the box around another piece.
bool box_holds(const Piece& piece, const Piece& other) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (other.ends[2 * axis][int(axis)] < piece.ends[2 * axis][int(axis)] ||
        other.ends[2 * axis + 1][int(axis)] > piece.ends[2 * axis + 1][int(axis)])
      return false;
  return true;
}

/// The pieces that lie inside another piece.
std::vector<std::size_t> pieces_in(const TriangleMesh& mesh, const std::vector<Piece>& pieces, const Piece& outer) {
  std::vector<std::size_t> within;
  for (std::size_t n = 0; n < pieces.size(); ++n)
    if (&pieces[n] != &outer && box_holds(outer, pieces[n])) within.push_back(n);
  if (within.empty()) return within;
  TriangleMesh part;
  for (const std::uint32_t t : outer.triangles) {
    const auto first = std::uint32_t(part.vertices.size());
    for (const std::uint32_t v : mesh.triangles[t]) part.vertices.push_back(mesh.vertices[v]);
    part.triangles.push_back({first, first + 1, first + 2});
  }
  const WindingNumber alone(part);
  std::erase_if(within, [&](std::size_t n) {
    look_for_interruption();
    return !encloses(alone, pieces[n]);
  });
  return within;
}

/// Flips triangles until neighbours traverse their shared side in opposite directions. The orientation of a piece is
/// that of most of its triangles.
void orient_alike(TriangleMesh& mesh, const std::vector<std::vector<Neighbour>>& neighbours) {
  enum : std::uint8_t { kUnseen, kKept, kFlipped };
  std::vector<std::uint8_t> state(mesh.triangles.size(), kUnseen);
  for (std::uint32_t first = 0; first < state.size(); ++first) {
    if (state[first] != kUnseen) continue;
    std::vector<std::uint32_t> piece = {first};
    state[first] = kKept;
    bool possible = true;
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (const Neighbour& next : neighbours[piece[n]]) {
        const std::uint8_t wanted = (state[piece[n]] == kKept) == next.alike ? kKept : kFlipped;
        if (state[next.triangle] == kUnseen) {
          state[next.triangle] = wanted;
          piece.push_back(next.triangle);
        }
        possible &= state[next.triangle] == wanted;
      }
    if (!possible) continue;  // a one-sided surface, such as a Moebius strip
    // Most triangles keep their orientation. In a tie, the enclosed volume must be positive.
    std::size_t flipped = 0;
    double volume = 0;
    for (const std::uint32_t t : piece) {
      flipped += state[t] == kFlipped ? 1 : 0;
      volume += state[t] == kFlipped ? -six_volumes(mesh, t) : six_volumes(mesh, t);
    }
    const bool other = 2 * flipped == piece.size() ? volume < 0 : 2 * flipped > piece.size();
    for (const std::uint32_t t : piece)
      if ((state[t] == kFlipped) != other) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
}

/// Flips closed outer pieces that face inwards, together with all pieces inside them.
void orient_outwards(TriangleMesh& mesh, const std::vector<std::vector<Neighbour>>& neighbours) {
  const std::vector<Piece> pieces = pieces_of(mesh, neighbours);
  const auto faces_inwards = [](const Piece& piece) { return piece.six_volumes < 0; };
  if (!std::ranges::all_of(pieces, &Piece::closed) || std::ranges::none_of(pieces, faces_inwards)) return;
  const WindingNumber all(mesh);
  std::vector<bool> flips(pieces.size(), false);
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    look_for_interruption();
    if (!faces_inwards(pieces[n]) || encloses(all, pieces[n])) continue;
    flips[n] = true;
    for (const std::size_t within : pieces_in(mesh, pieces, pieces[n])) flips[within] = true;
  }
  for (std::size_t n = 0; n < pieces.size(); ++n)
    if (flips[n])
      for (const std::uint32_t t : pieces[n].triangles) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

}  // namespace

TriangleMesh oriented(TriangleMesh mesh) {
  mesh = without_repeated_faces(std::move(mesh));
  const auto [neighbours, all_alike] = neighbours_in(mesh);
  if (!all_alike) orient_alike(mesh, neighbours);
  orient_outwards(mesh, neighbours);
  return mesh;
}

}  // namespace hapticut
