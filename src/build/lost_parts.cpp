// SPDX-License-Identifier: Apache-2.0
#include "build/lost_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "build/pieces.hpp"
#include "build/repeated_faces.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

constexpr double kBounding = 0.5;
constexpr double kBeside = 1e-6;        // [edges of a face] distance of a point from the face that it belongs to
constexpr double kThin = 2;             // [voxels]
constexpr std::size_t kFewFaces = 4;    // a body has at least so many
constexpr std::size_t kMaxFaces = 256;  // that are looked at in a part

/// Groups of triangles that share vertices, and closed pieces of them, each as a list of triangles.
std::vector<std::vector<std::uint32_t>> parts_of(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> places = places_of(mesh.vertices);
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root_of = [&](std::uint32_t v) {
    for (; parent[v] != v; v = parent[v]) parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : {t[1], t[2]}) parent[root_of(places[v])] = root_of(places[t[0]]);
  std::vector<std::vector<std::uint32_t>> parts(mesh.vertices.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) parts[root_of(places[mesh.triangles[t][0]])].push_back(t);
  std::erase_if(parts, [](const auto& part) { return part.empty(); });
  const std::size_t count = parts.size();
  std::vector<Piece> pieces = pieces_of(mesh, connections_in(mesh));
  if (pieces.size() == count) return parts;
  for (Piece& piece : pieces)
    if (piece.closed) parts.push_back(std::move(piece.triangles));
  return parts;
}

/// Whether the surface winds around a point beside the face, on either side.
bool bounds_something(const TriangleMesh& mesh, std::uint32_t t, const WindingNumber& winding) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
  const Vec3 area = (q - p).cross(r - p);
  if (!(area.norm() > 0)) return false;
  const Vec3 beside = kBeside * std::sqrt(area.norm()) * area.normalized(), middle = (p + q + r) / 3;
  return winding.at(middle - beside) > kBounding || winding.at(middle + beside) > kBounding;
}

}  // namespace

void require_no_lost_part(const TriangleMesh& mesh, const WindingNumber& winding, double voxel_size) {
  for (const std::vector<std::uint32_t>& part : parts_of(mesh)) {
    Eigen::AlignedBox3d box;
    for (const std::uint32_t t : part)
      for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.vertices[v]);
    if (part.size() < kFewFaces || box.sizes().minCoeff() < kThin * voxel_size) continue;
    const std::size_t stride = std::max<std::size_t>(part.size() / kMaxFaces, 1);
    bool bounds = false;
    for (std::size_t n = 0; n < part.size() && !bounds; n += stride) bounds = bounds_something(mesh, part[n], winding);
    if (bounds) continue;
    const Vec3 at = box.center() / units::mm;
    throw Error("a part of the surface, " + format_number(double(part.size())) + " triangles around " +
                format_number(at.x()) + ", " + format_number(at.y()) + ", " + format_number(at.z()) +
                " mm, would be lost, because it encloses nothing: its faces point the other way than the rest of the "
                "surface, or are there twice (two-sided); turn them over or keep one of each two, or delete the part.");
  }
}

}  // namespace hapticut
