// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/import/mesh/meshes.hpp"

/// @file
/// The polygons of a mesh file, before they become triangles. Every format parser returns them; the steps common to all
/// formats (welding, fans, polygons without area) are here.
namespace hapticut {

/// One object of a file, made of polygons.
struct PolygonObject {
  std::string name;
  std::vector<std::uint32_t> corners;  ///< corners of all polygons in order: indices of `Polygons::vertices`
  std::vector<std::size_t> ends;       ///< end of each polygon in `corners`
};

struct Polygons {
  std::vector<Vec3> vertices;  ///< positions in units of the file
  std::vector<PolygonObject> objects;
};

/// Turns the vertices to patient axes (LPS) if the header of a file names another space, as 3D Slicer does:
/// `SPACE=RAS`. Without a name, and with `SPACE=LPS`, they stay as they are.
/// @param header  the text before the vertices
/// @throws Error when the space is neither
void turn_to_patient_axes(Polygons& polygons, std::string_view header);

/// Welds vertices at the same place, splits polygons into fans and drops triangles without three different corners.
/// Objects without a triangle are dropped.
/// @pre every corner is an index of a vertex
/// @param unit  [m] length of one unit of the file
/// @throws Error when a vertex of a polygon has a coordinate that is not finite
[[nodiscard]] std::vector<NamedMesh> to_meshes(const Polygons& polygons, double unit);

}  // namespace hapticut
