// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// A triangle that continues another one across a side.
struct NeighbourTriangle {
  std::uint32_t triangle;
  bool alike;  // both have the same orientation
};

/// How the triangles of a mesh are connected. Vertices at the same place count as one.
struct Connections {
  /// A side whose triangles do not continue each other: one triangle at a hole, or several where bodies touch.
  struct LooseSide {
    std::uint32_t from, to;  // places of its ends
    std::vector<std::uint32_t> triangles;
  };
  std::vector<std::uint32_t> places;  // one of each vertex
  std::vector<std::vector<NeighbourTriangle>> neighbours;
  std::vector<LooseSide> loose;
  bool all_alike = true;  // all neighbours

  /// Number of sides with a single triangle.
  [[nodiscard]] std::size_t open_sides() const;
};

/// Connects triangles across each side of two triangles. Where two bodies share faces the same way round, each copy of
/// a face is connected to one copy of the next one.
[[nodiscard]] Connections connections_in(const TriangleMesh& mesh);

/// A part of a surface: the surface of one body, or of one cavity.
struct Piece {
  std::vector<std::uint32_t> triangles;
  bool closed = true;
  double six_volumes = 0;    // [m^3] negative: it faces inwards
  std::array<Vec3, 6> ends;  // [m] points slightly beyond the extreme vertices along each axis, outside of the piece
};

/// Splits a surface into pieces. Triangles are together if sides of two triangles connect them. At a side of more
/// triangles, a part that is open there continues in a part that runs along all of these sides the other way: of two
/// bodies that touch in a face, each keeps one copy of the face.
[[nodiscard]] std::vector<Piece> pieces_of(const TriangleMesh& mesh, const Connections& connections);

/// [m] Points beside some faces of a closed piece, inside of it, whichever way it faces.
[[nodiscard]] std::vector<Vec3> points_inside(const TriangleMesh& mesh, const Piece& piece);

}  // namespace hapticut
