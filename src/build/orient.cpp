// SPDX-License-Identifier: Apache-2.0
#include "build/orient.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ranges>
#include <utility>
#include <vector>

#include "build/pieces.hpp"
#include "build/repeated_faces.hpp"
#include "build/winding_number.hpp"
#include "core/interruption.hpp"

namespace hapticut {
namespace {

double six_volumes(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
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
    if (!pieces[n].closed) return !encloses(alone, pieces[n]);
    return !std::ranges::all_of(points_inside(mesh, pieces[n]), [&](const Vec3& p) { return alone.at(p) > 0.5; });
  });
  return within;
}

/// Flips triangles until neighbours traverse their shared side in opposite directions. The orientation of a piece is
/// that of most of its triangles.
void orient_alike(TriangleMesh& mesh, const std::vector<std::vector<NeighbourTriangle>>& neighbours) {
  enum : std::uint8_t { kUnseen, kKept, kFlipped };
  std::vector<std::uint8_t> state(mesh.triangles.size(), kUnseen);
  for (std::uint32_t first = 0; first < state.size(); ++first) {
    if (state[first] != kUnseen) continue;
    std::vector<std::uint32_t> piece = {first};
    state[first] = kKept;
    bool possible = true;
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (const NeighbourTriangle& next : neighbours[piece[n]]) {
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

/// Whether other pieces fill the space inside a closed piece that is turned: then it is a cavity.
/// @param sign  makes winding numbers positive in a body
bool is_filled_by_others(const TriangleMesh& mesh, const WindingNumber& all, double sign, const Piece& piece) {
  constexpr double kFilled = 0.5;
  return std::ranges::all_of(points_inside(mesh, piece), [&](const Vec3& point) {
    const double others = sign * all.at(point) + 1;  // the piece itself counts -1
    return std::abs(others) > kFilled;
  });
}

/// Whether open pieces, taken together, face inwards: each is closed towards the middle of its box.
bool open_ones_face_inwards(const TriangleMesh& mesh, const std::vector<Piece>& pieces) {
  double volumes = 0;
  for (const Piece& piece : pieces) {
    if (piece.closed) continue;
    Eigen::AlignedBox3d box;
    for (const Vec3& end : piece.ends) box.extend(end);
    for (const std::uint32_t t : piece.triangles) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vec3 p = mesh.vertices[a] - box.center(), q = mesh.vertices[b] - box.center();
      volumes += p.dot(q.cross(mesh.vertices[c] - box.center()));
    }
  }
  return volumes < 0;
}

/// Flips closed outer pieces that face inwards, together with all pieces inside them. If open pieces face inwards, a
/// mesh may be inside out: closed pieces face inwards with them, and later the whole surface is turned.
void orient_outwards(TriangleMesh& mesh, const Connections& connections) {
  const std::vector<Piece> pieces = pieces_of(mesh, connections);
  const double outwards = open_ones_face_inwards(mesh, pieces) ? -1 : 1;
  const auto is_turned = [&](const Piece& piece) { return piece.closed && outwards * piece.six_volumes < 0; };
  if (std::ranges::none_of(pieces, is_turned)) return;
  const WindingNumber all(mesh);
  const double sign = all.is_turned() ? -outwards : outwards;
  std::vector<bool> flips(pieces.size(), false);
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    look_for_interruption();
    if (!is_turned(pieces[n]) || is_filled_by_others(mesh, all, sign, pieces[n])) continue;
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
  const Connections connections = connections_in(mesh);
  if (!connections.all_alike) orient_alike(mesh, connections.neighbours);
  orient_outwards(mesh, connections);
  return mesh;
}

}  // namespace hapticut
