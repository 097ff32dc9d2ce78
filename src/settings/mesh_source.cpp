// SPDX-License-Identifier: Apache-2.0
#include "settings/mesh_source.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "import/mesh/mesh_extensions.hpp"

namespace hapticut::settings {
namespace {

constexpr double kVoxel_mm = 0.1;

std::string names_of(const std::vector<NamedMesh>& objects) {
  return joined(objects, ", ", [](const NamedMesh& o) { return o.name.empty() ? "one without a name" : o.name; });
}

/// All objects of one name as one surface. Vertices at the same place are merged, as a reader does within one object.
/// @throws Error when there is no such object
TriangleMesh surface_of(const std::vector<NamedMesh>& objects, const std::string& name) {
  if (std::ranges::count(objects, name, &NamedMesh::name) == 1)
    return std::ranges::find(objects, name, &NamedMesh::name)->mesh;
  TriangleMesh surface;
  std::map<std::array<double, 3>, std::uint32_t> places;
  for (const NamedMesh& object : objects) {
    if (object.name != name) continue;
    std::vector<std::uint32_t> vertices;
    vertices.reserve(object.mesh.vertices.size());
    for (const Vec3& v : object.mesh.vertices) {
      const auto [place, is_new] = places.try_emplace({v.x(), v.y(), v.z()}, std::uint32_t(surface.vertices.size()));
      if (is_new) surface.vertices.push_back(v);
      vertices.push_back(place->second);
    }
    for (const auto& t : object.mesh.triangles)
      surface.triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  }
  if (!surface.triangles.empty()) return surface;
  throw Error("there is no object '" + name + "' in the mesh; there are " + names_of(objects) + ". Set " +
              "workpiece.shells"_name + ".");
}

/// @throws Error when the mesh is shorter than a few voxels or has too many voxels for any memory, and another unit
///         gives a plausible length
void require_plausible_size(const WorkpieceSettings& s, const std::vector<NamedMesh>& objects, double unit_mm) {
  constexpr double kFew = 4, kMany = 1e4;  // [voxels]
  Box box{objects.front().mesh.vertices.front(), objects.front().mesh.vertices.front()};
  for (const NamedMesh& object : objects)
    for (const Vec3& v : object.mesh.vertices) box = {box.min.cwiseMin(v), box.max.cwiseMax(v)};
  const double length_mm = (box.max - box.min).maxCoeff() / units::mm, voxel_mm = s.voxel_mm.value_or(kVoxel_mm);
  const bool small = length_mm < kFew * voxel_mm;
  const bool large = !s.large && length_mm > std::max(kMany * voxel_mm, kMaxPlausibleLength);
  const std::optional<Sentence> units = plausible_units(length_mm / unit_mm, 2 * kFew * voxel_mm);
  if ((!small && !large) || !units) return;
  throw Error("with a unit of " + format_number(unit_mm) + " mm it is " + format_number(length_mm) + " mm long, " +
              (small ? "less than " + format_number(kFew) : "more than " + format_number(kMany)) + " voxels of " +
              format_number(voxel_mm) + " mm. Set " + *units + ", or " +
              (small ? "smaller voxels by " + "workpiece.voxel_mm"_name + "."
                     : "larger voxels by " + "workpiece.voxel_mm"_name + ", or " + "workpiece.large"_name + "."));
}

}  // namespace

Workpiece make_workpiece_from_mesh(const WorkpieceSettings& s) {
  const double unit_mm = s.unit_mm.value_or(common_unit_mm(s.source));
  const std::vector<NamedMesh> objects = read_mesh(s.source, unit_mm);
  require_plausible_size(s, objects, unit_mm);
  MeshImport options;
  options.voxel_size = s.voxel_mm.value_or(kVoxel_mm) * units::mm;
  options.large = s.large;
  options.observer = s.tell;
  options.warn = s.warn;
  if (s.material.empty() == s.shells.empty())
    throw Error("a mesh needs either a material or shells; its objects are " + names_of(objects) + ". Set " +
                "workpiece.material"_name + ", or " + "workpiece.shells"_name + " for each.");
  if (!s.material.empty()) {
    if (objects.size() > 1)
      throw Error("the mesh has several objects (" + names_of(objects) + "), so one material is not enough. Set " +
                  "workpiece.shells"_name + " for each object of the workpiece.");
    return build_from_mesh(objects.front().mesh, s.materials.find(s.material), options);
  }
  MaterialTable table;
  std::map<std::string, MaterialId> ids = {{"empty", kEmpty}};
  std::vector<MeshShell> shells;
  for (const WorkpieceSettings::Shell& shell : s.shells) {
    if (!ids.contains(shell.material)) ids[shell.material] = table.add(s.materials.find(shell.material));
    shells.push_back({surface_of(objects, shell.object), ids[shell.material]});
  }
  return build_from_shells(shells, std::move(table), options);
}

}  // namespace hapticut::settings
