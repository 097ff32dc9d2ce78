// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/io/mesh/meshes.hpp"

/// @file
/// What a mesh file says before it becomes triangles. Each reader of a format makes one of these; what is the same for
/// all formats (welding, fans, polygons without area) is done here once.
namespace hapticut {

/// One object of a file, made of polygons.
struct PolygonObject {
  std::string name;
  std::vector<std::uint32_t> corners;  ///< of all polygons, one after the other: indices of `Polygons::vertices`
  std::vector<std::size_t> ends;       ///< where each polygon ends in `corners`
};

struct Polygons {
  std::vector<Vec3> vertices;  ///< in units of the file
  std::vector<PolygonObject> objects;
};

/// Welds vertices at the same place, cuts polygons into fans and drops triangles that have no three different corners.
/// Objects without any triangle are left out.
/// @pre every corner is an index of a vertex
/// @param unit  [m] length of one unit of the file
/// @throws Error when a vertex of a polygon has a coordinate that is not finite
[[nodiscard]] std::vector<NamedMesh> to_meshes(const Polygons& polygons, double unit);

}  // namespace hapticut
