// SPDX-License-Identifier: Apache-2.0
#include "settings/mesh_source.hpp"

#include <map>

#include "hapticut/core/units.hpp"
#include "hapticut/io/mesh/meshes.hpp"
#include "hapticut/workpiece/mesh_builder.hpp"

namespace hapticut::settings {
namespace {

std::string names_of(const std::vector<NamedMesh>& objects) {
  std::string names;
  for (const NamedMesh& object : objects)
    names += (names.empty() ? "" : ", ") + (object.name.empty() ? "one without a name" : object.name);
  return names;
}

const TriangleMesh& find(const std::vector<NamedMesh>& objects, const std::string& name) {
  for (const NamedMesh& object : objects)
    if (object.name == name) return object.mesh;
  throw Error("there is no object '" + name + "' in the mesh; there are " + names_of(objects) +
              ". Set --shell MATERIAL=OBJECT.");
}

}  // namespace

Workpiece make_workpiece_from_mesh(const WorkpieceSettings& s) {
  const std::vector<NamedMesh> objects = read_mesh(s.source, s.unit_mm.value_or(1));
  MeshImport options;
  options.voxel_size = s.voxel_mm.value_or(0.1) * units::mm;
  options.large = s.large;
  options.tell = s.tell;
  if (s.material.empty() == s.shells.empty())
    throw Error("a mesh needs either workpiece.material or workpiece.shells; its objects are " + names_of(objects) +
                ". Set --material, or --shell MATERIAL=OBJECT for each.");
  if (!s.material.empty()) {
    if (objects.size() > 1)
      throw Error("the mesh has several objects (" + names_of(objects) +
                  "), so workpiece.material is not clear. Set --shell MATERIAL=OBJECT for each that counts.");
    return build_from_mesh(objects.front().mesh, s.materials.find(s.material), options);
  }
  MaterialTable table;
  std::map<std::string, MaterialId> ids = {{"empty", kEmpty}};
  std::vector<MeshShell> shells;
  for (const WorkpieceSettings::Shell& shell : s.shells) {
    if (!ids.contains(shell.material)) ids[shell.material] = table.add(s.materials.find(shell.material));
    shells.push_back({find(objects, shell.object), ids[shell.material]});
  }
  return build_from_shells(shells, std::move(table), options);
}

}  // namespace hapticut::settings
