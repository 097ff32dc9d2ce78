// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "hapticut/surface/surface_stream.hpp"
#include "support/mesh_measures.hpp"

/// @file
/// Pages of a surface, joined as in a viewer.
namespace hapticut::test {

using Pages = std::map<VoxelIndex, SurfacePage>;

/// The pages of a viewer after it received all waiting pages; empty pages are removed.
inline void take_pages(SurfaceStream& stream, Pages& pages) {
  SurfacePage page;
  while (stream.next_page(page)) {
    if (page.vertices.empty())
      pages.erase(page.origin);
    else
      pages[page.origin] = page;
  }
}

inline Pages pages_of(const Workpiece& workpiece) {
  SurfaceStream stream(workpiece);
  Pages pages;
  take_pages(stream, pages);
  return pages;
}

/// Compares byte by byte, except the versions.
inline bool are_equal(const Pages& a, const Pages& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.first == other.first && one.second.vertices == other.second.vertices &&
           one.second.indices == other.second.indices;
  });
}

/// [1/512 voxel] Position in the grid, without further rounding.
inline VoxelIndex grid_position(const SurfacePage& page, const SurfaceVertex& vertex) {
  VoxelIndex at;
  for (std::size_t axis = 0; axis < 3; ++axis)
    at[axis] = page.origin[axis] * SurfaceVertex::kStepsPerVoxel + vertex.position[axis];
  return at;
}

/// All pages as one mesh; vertices at the same place become one.
inline TriangleMesh welded(const Pages& pages, const GridFrame& frame) {
  TriangleMesh mesh;
  std::map<VoxelIndex, std::uint32_t> numbers;
  for (const auto& [origin, page] : pages)
    for (std::size_t n = 0; n < page.indices.size(); n += 3) {
      std::array<std::uint32_t, 3> triangle;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const SurfaceVertex& vertex = page.vertices.at(page.indices[n + corner]);
        const auto [place, is_new] =
            numbers.try_emplace(grid_position(page, vertex), std::uint32_t(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(vertex_position(frame, page, vertex));
        triangle[corner] = place->second;
      }
      mesh.triangles.push_back(triangle);
    }
  return mesh;
}

}  // namespace hapticut::test
