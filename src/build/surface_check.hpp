// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// What the triangles of a surface say about the body that they enclose.
struct SurfaceMeasure {
  std::size_t open_sides = 0;  // with a single triangle
  bool closed = true;
  double volume = 0;       // [m^3] by the divergence theorem; of a closed surface
  double area = 0;         // [m^2]
  double vector_area = 0;  // [m^2] length of the sum of all area vectors: 0 of a closed surface, `area` of a flat sheet
};

[[nodiscard]] SurfaceMeasure measure_surface(const TriangleMesh& mesh);

/// Compares a surface with the voxels that it has filled.
/// @param name      of the surface: "the surface"
/// @param filled    [m^3] by the voxels
/// @param overlaps  parts of the surface overlap, so that its volume says nothing
/// @param warn      may be empty; receives a sentence about an open surface, or about walls too thin for the voxels
/// @throws Error when the surface is a sheet that encloses a layer thinner than a voxel
void check_surface(const SurfaceMeasure& surface, const std::string& name, double filled, bool overlaps,
                   double voxel_size, const std::function<void(const std::string&)>& warn);

}  // namespace hapticut
