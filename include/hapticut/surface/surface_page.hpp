// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hapticut/core/mesh.hpp"
#include "hapticut/workpiece/block.hpp"

namespace hapticut {

/// A vertex of a page, 12 bytes, in a format for graphics cards. Two bytes of padding keep each field at a multiple of
/// four.
struct SurfaceVertex {
  static constexpr int kStepsPerVoxel = 512;

  std::array<std::int16_t, 3> position;  ///< [1/512 voxel edge] along the axes of V, from the page's first voxel centre
  MaterialId material;                   ///< material of the nearest voxel that is at least half full
  std::uint8_t unused_1 = 0;
  std::array<std::int8_t, 3> normal;  ///< [1/127] unit vector out of the material, along the axes of V
  std::uint8_t unused_2 = 0;

  [[nodiscard]] bool operator==(const SurfaceVertex&) const = default;
};
static_assert(sizeof(SurfaceVertex) == 12);

/// The surface in 32 x 32 x 32 voxels, for one draw call. A page without vertices means that no surface is left there.
///
/// A triangle belongs to the page of the lower of the two samples between which the surface passes. So pages meet
/// without gap or overlap, and vertices at a seam are in both pages.
struct SurfacePage {
  static constexpr int kEdge = 32;                        ///< voxels along an edge
  static constexpr int kBlocks = kEdge / kBlockEdge;      ///< blocks along an edge
  static constexpr std::size_t kMaxVertices = 64 * 729;   ///< fewer than 65 536, so that 16 bits number them
  static constexpr std::size_t kMaxIndices = 64 * 9'216;  ///< a checkerboard

  VoxelIndex origin = {0, 0, 0};  ///< its first voxel; identifies the page
  std::uint64_t version = 0;      ///< grows with every page that is handed out
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint16_t> indices;  ///< three a triangle, counter-clockwise seen from outside
};

/// [m] Position of a vertex of a page, in W.
[[nodiscard]] inline Vec3 vertex_position(const GridFrame& frame, const SurfacePage& page,
                                          const SurfaceVertex& vertex) {
  Vec3 p_V;
  for (int axis = 0; axis < 3; ++axis)
    p_V[axis] = page.origin[std::size_t(axis)] +
                double(vertex.position[std::size_t(axis)]) / double(SurfaceVertex::kStepsPerVoxel);
  return frame.X_WV * (frame.voxel_size * p_V);
}

/// Normal of a vertex of a page, in W, of unit length.
[[nodiscard]] inline Vec3 vertex_normal(const GridFrame& frame, const SurfaceVertex& vertex) {
  return (frame.X_WV.rotation * Vec3(vertex.normal[0], vertex.normal[1], vertex.normal[2])).normalized();
}

}  // namespace hapticut
