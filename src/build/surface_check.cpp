// SPDX-License-Identifier: Apache-2.0
#include "build/surface_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "build/pieces.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

std::string volume_text(double volume) { return format_number(std::round(volume / units::mm3 * 1e4) / 1e4) + " mm^3"; }

}  // namespace

SurfaceMeasure measure_surface(const TriangleMesh& mesh) {
  const Connections connections = connections_in(mesh);
  const std::vector<Piece> pieces = pieces_of(mesh, connections);
  SurfaceMeasure measure;
  measure.open_sides = connections.open_sides();
  measure.closed = std::ranges::all_of(pieces, &Piece::closed);
  for (const Piece& piece : pieces) measure.volume += piece.six_volumes / 6;
  measure.volume = std::abs(measure.volume);
  Vec3 sum = Vec3::Zero();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& p = mesh.vertices[a];
    const Vec3 area = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p) / 2;
    measure.area += area.norm();
    sum += area;
  }
  measure.vector_area = sum.norm();
  return measure;
}

void check_surface(const SurfaceMeasure& surface, const std::string& name, double filled, bool overlaps,
                   double voxel_size, const std::function<void(const std::string&)>& warn) {
  constexpr double kSheet = 0.5;        // [1] vector area over area: half a ball has so much
  constexpr double kDifference = 0.05;  // [1] as for labels
  const std::string voxels = "voxels of " + format_number(voxel_size / units::mm) + " mm";
  const bool sheet = surface.open_sides > 0 && surface.vector_area > kSheet * surface.area;
  if (sheet && filled < voxel_size * surface.area)
    throw Error(name + " is an open sheet: on its " +
                format_number(std::round(surface.area / (units::mm * units::mm) * 1e4) / 1e4) +
                " mm^2 it encloses a layer of " + volume_text(filled) + ", thinner than " + voxels +
                "; close it to a body first.");
  if (!warn) return;
  if (surface.open_sides > 0)
    warn(name + " is open: " + format_number(double(surface.open_sides)) +
         " of its edges have one face. It is closed where its winding number is one half, and then fills " +
         volume_text(filled) + "; close its holes first if this is not the body.");
  else if (surface.closed && !overlaps && std::abs(filled - surface.volume) > kDifference * surface.volume)
    warn("parts of " + name + " are too thin for " + voxels + ": it encloses " + volume_text(surface.volume) +
         ", and its voxels fill " + volume_text(filled) + ". Choose smaller voxels.");
}

}  // namespace hapticut
