// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/surface.hpp"

#include <openvdb/tools/VolumeToMesh.h>

#include <cmath>
#include <limits>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/openvdb.hpp"
#include "workpiece/state.hpp"

namespace hapticut {
namespace {

using openvdb::Coord;

/// Surface at one half, in voxel coordinates.
struct VoxelMesh {
  std::vector<openvdb::Vec3s> vertices;
  std::vector<openvdb::Vec4I> quads;
};

VoxelMesh surface_in_voxels(openvdb::FloatGrid& density) {
  density.setTransform(openvdb::math::Transform::createLinearTransform(1.0));
  VoxelMesh mesh;
  openvdb::tools::volumeToMesh(density, mesh.vertices, mesh.quads, 0.5);
  return mesh;
}

TriangleMesh triangulated(const VoxelMesh& surface, const GridFrame& frame) {
  TriangleMesh mesh;
  mesh.vertices.reserve(surface.vertices.size());
  for (const auto& v : surface.vertices)
    mesh.vertices.push_back(frame.X_WV * (frame.voxel_size * Vec3(double(v.x()), double(v.y()), double(v.z()))));
  mesh.triangles.reserve(2 * surface.quads.size());
  for (const auto& quad : surface.quads) {
    // Cut along the shorter diagonal: better shaped triangles, and a smoother picture.
    const auto diagonal = [&](int a, int b) {
      return (surface.vertices[quad[a]] - surface.vertices[quad[b]]).lengthSqr();
    };
    const int first = diagonal(0, 2) <= diagonal(1, 3) ? 0 : 1;
    const auto corner = [&](int n) { return quad[(first + n) & 3]; };
    // OpenVDB's quads are clockwise seen from outside.
    mesh.triangles.push_back({corner(2), corner(1), corner(0)});
    mesh.triangles.push_back({corner(3), corner(2), corner(0)});
  }
  return mesh;
}

/// Of the voxel nearest to a point (in voxel coordinates) among the eight around it that are not empty.
template <class Accessor>
MaterialId nearest_material(const Accessor& materials, const openvdb::Vec3s& point) {
  const Coord low = Coord::floor(openvdb::Vec3d(point));
  MaterialId nearest = kEmpty;
  float least = std::numeric_limits<float>::max();
  for (int n = 0; n < 8; ++n) {
    const Coord at = low.offsetBy(n >> 2, n >> 1 & 1, n & 1);
    std::uint8_t id = kEmpty;
    if (!materials.probeValue(at, id)) continue;
    const float distance = (openvdb::Vec3s(at.asVec3s()) - point).lengthSqr();
    if (distance < least) {
      least = distance;
      nearest = id;
    }
  }
  return nearest;
}

}  // namespace

WorkpieceSurface extract_surface(const Workpiece& workpiece) {
  const VoxelMesh surface = surface_in_voxels(*density_grid(workpiece));
  WorkpieceSurface result;
  result.mesh = triangulated(surface, workpiece.frame());
  const openvdb::tree::ValueAccessor<const MaterialTree, false> materials(WorkpieceAccess::trees(workpiece).material);
  result.materials.reserve(surface.vertices.size());
  for (const auto& vertex : surface.vertices) result.materials.push_back(nearest_material(materials, vertex));
  return result;
}

TriangleMesh extract_surface(const Workpiece& workpiece, MaterialId material) {
  (void)workpiece.materials()[material];  // throws when there is none
  const auto density = density_grid(workpiece);
  const auto& ids = WorkpieceAccess::trees(workpiece).material;
  for (auto leaf = density->tree().beginLeaf(); leaf; ++leaf) {
    const auto* id = ids.probeConstLeaf(leaf->origin());
    for (auto voxel = leaf->beginValueOn(); voxel; ++voxel)
      if (id->getValue(voxel.pos()) != material) {
        voxel.setValue(0.0F);
        voxel.setValueOff();
      }
  }
  auto tile = density->tree().beginValueOn();
  for (tile.setMaxDepth(FillTree::DEPTH - 2); tile; ++tile)
    if (ids.getValue(tile.getCoord()) != material) {
      tile.setValue(0.0F);
      tile.setValueOff();
    }
  return triangulated(surface_in_voxels(*density), workpiece.frame());
}

}  // namespace hapticut
