// SPDX-License-Identifier: Apache-2.0
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "hapticut/core/errors.hpp"
#include "io/mesh/mesh_formats.hpp"
#include "io/mesh/text_lines.hpp"

namespace hapticut {
namespace {

/// Adds the polygons of a mesh to an object. Lines and points, which Assimp calls faces too, are left out.
void add(const aiMesh& mesh, const aiMatrix4x4& transform, Polygons& polygons, PolygonObject& object) {
  const std::size_t first = polygons.vertices.size();
  for (unsigned n = 0; n < mesh.mNumVertices; ++n) {
    const aiVector3D p = transform * mesh.mVertices[n];
    polygons.vertices.emplace_back(double(p.x), double(p.y), double(p.z));
  }
  for (unsigned n = 0; n < mesh.mNumFaces; ++n) {
    const aiFace& face = mesh.mFaces[n];
    if (face.mNumIndices < 3) continue;
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= mesh.mNumVertices) throw Error("a face names a vertex that does not exist.");
      object.corners.push_back(std::uint32_t(first + face.mIndices[k]));
    }
    object.ends.push_back(object.corners.size());
  }
}

void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, Polygons& polygons) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  PolygonObject object{node.mName.C_Str(), {}, {}};
  for (unsigned n = 0; n < node.mNumMeshes; ++n) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[n]];
    add(mesh, transform, polygons, object);
    if (mesh.mName.length > 0) object.name = mesh.mName.C_Str();
  }
  polygons.objects.push_back(std::move(object));
  for (unsigned n = 0; n < node.mNumChildren; ++n) collect(scene, *node.mChildren[n], transform, polygons);
}

/// What Assimp says of a file that it refuses is about its own code, but for the name of a file that is missing.
std::string cause_of(std::string_view reason) {
  constexpr std::string_view kNamed = "referenced file \"";
  if (const std::size_t at = reason.find(kNamed); at != std::string_view::npos) {
    const std::string_view name = reason.substr(at + kNamed.size());
    return "the file " + in_quotes(name.substr(0, name.find('"'))) +
           " that it needs cannot be read; keep them together, or export the mesh as .glb.";
  }
  return "it is damaged, holds no mesh or is compressed; export it again as glTF 2.0 without compression, or as STL or "
         "OBJ.";
}

}  // namespace

Polygons read_with_assimp(const std::filesystem::path& path) {
  Assimp::Importer importer;
  // No step of its own afterwards: its triangulation ends the program on damaged files.
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (scene == nullptr || scene->mRootNode == nullptr) throw Error(cause_of(importer.GetErrorString()));
  Polygons polygons;
  collect(*scene, *scene->mRootNode, aiMatrix4x4(), polygons);
  return polygons;
}

}  // namespace hapticut
