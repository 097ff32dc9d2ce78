// SPDX-License-Identifier: Apache-2.0
#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <charconv>
#include <nlohmann/json.hpp>

#include "import/mesh/mesh_formats.hpp"
#include "io/byte_reader.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

/// The JSON text of a file: all of a .gltf, the first part of a .glb.
std::string json_of(const std::filesystem::path& path) {
  constexpr std::size_t kHeader = 20, kPlaceOfLength = 12;  // [bytes] header of a .glb, and the place of a length in it
  std::string file = bytes_of_file(path);
  if (file.size() < kHeader || !file.starts_with("glTF")) return file;
  return file.substr(kHeader, number_in<std::uint32_t>(std::string_view(file).substr(kPlaceOfLength)));
}

/// Assimp's messages describe its own code; only the name of a missing file is useful.
std::string cause_of(std::string_view reason) {
  constexpr std::string_view kNamed = "referenced file \"";
  if (const std::size_t at = reason.find(kNamed); at != std::string_view::npos) {
    const std::string_view name = reason.substr(at + kNamed.size());
    return "the file " + in_quotes(name.substr(0, name.find('"'))) +
           " that it refers to cannot be read; keep the files together, or export the mesh as .glb.";
  }
  return "it is damaged, has no mesh or is compressed; export it again as glTF 2.0 without compression, or as STL or "
         "OBJ.";
}

/// A list of the outermost object; empty when it has none of that name.
nlohmann::json list_in(const nlohmann::json& json, const char* key) {
  return json.is_object() && json.contains(key) ? json[key] : nlohmann::json::array();
}

/// Whether an extension of glTF concerns only colours, pictures, lights or notes, so the shape is the same without it.
bool leaves_shapes_alone(std::string_view extension) {
  constexpr std::array<std::string_view, 5> kParts = {"_materials_", "_texture_", "_lights_", "_animation_", "_xmp"};
  return std::ranges::any_of(kParts,
                             [&](std::string_view part) { return extension.find(part) != std::string_view::npos; });
}

/// Whether an object has bones (a skin), or weights of other shapes.
bool is_posed(const nlohmann::json& item) {
  const nlohmann::json weights = list_in(item, "weights");
  return item.contains("skin") ||
         std::ranges::any_of(weights, [](const nlohmann::json& weight) { return weight != 0; });
}

/// Refuses files that Assimp would read incompletely. Assimp ignores required extensions that it does not know. It
/// reads only the first copy of EXT_mesh_gpu_instancing, even if the extension is optional, and does not apply bones or
/// morph targets.
void require_known_shape(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return (std::uint8_t(c) & 0x80U) != 0; }, '?');  // names in any encoding
  text.erase(text.find_last_not_of('\0') + 1);                            // some programs pad a .glb with these
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) throw Error(cause_of(""));
  std::vector<std::string> extensions;
  for (const nlohmann::json& used : list_in(json, "extensionsUsed"))
    if (used == "EXT_mesh_gpu_instancing") extensions.push_back(used);
  for (const nlohmann::json& required : list_in(json, "extensionsRequired"))
    if (required.is_string() && !leaves_shapes_alone(required.get<std::string>())) extensions.push_back(required);
  if (!extensions.empty())
    throw Error("it needs the glTF extension " + in_quotes(extensions.front()) +
                ", which is not supported; export it again without it, or as STL or OBJ.");
  if (std::ranges::any_of(list_in(json, "nodes"), is_posed) || std::ranges::any_of(list_in(json, "meshes"), is_posed))
    throw Error(
        "its shape is posed by bones (a skin) or by morph targets, which are not supported; apply them in the program "
        "that made the file, and export it again.");
}

/// Decodes %20 to a blank, and so on.
std::string without_escapes(std::string_view name) {
  std::string text;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const std::string_view digits = name.substr(at + 1, 2);
    unsigned byte = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    const bool escaped = name[at] == '%' && error == std::errc{} && end == digits.data() + 2 && byte != 0;
    text += escaped ? char(byte) : name[at];
    if (escaped) at += 2;
  }
  return text;
}

/// Opens a mesh for Assimp, and the files that the mesh names by URIs.
class MeshAndFilesBeside : public Assimp::DefaultIOSystem {
 public:
  /// @param text  replaces the content of the mesh file and must outlive this object; empty: the file is read
  MeshAndFilesBeside(std::string mesh, std::string_view text) : mesh_(std::move(mesh)), text_(text) {}

  bool Exists(const char* name) const override { return !place_of(name).empty(); }

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (!text_.empty() && name == mesh_)
      return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size());
    const std::string place = place_of(name);
    if (place.empty()) return nullptr;
    if (first_bytes(place, kGitLfsPointer.size()) == kGitLfsPointer) pointer_ = place;
    return DefaultIOSystem::Open(place.c_str(), mode);
  }

  /// A file beside the mesh that is only a Git LFS pointer; empty: none.
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
  /// Path of a file; empty when it does not exist or is a pipe, on which reading blocks.
  std::string place_of(std::string name) const {
    std::error_code error;
    if (std::filesystem::is_regular_file(name, error)) return name;
    const std::string folder = mesh_.substr(0, mesh_.find_last_of("/\\") + 1);
    const std::size_t known = name.starts_with(folder) ? folder.size() : 0;
    name.replace(known, std::string::npos, without_escapes(std::string_view(name).substr(known)));
    return std::filesystem::is_regular_file(name, error) ? name : "";
  }

  std::string mesh_;
  std::string_view text_;
  std::string pointer_;
};

/// Adds the polygons of a mesh to an object. Skips lines and points, which Assimp calls faces too.
void add(const aiMesh& mesh, const aiMatrix4x4& transform, Polygons& polygons, PolygonObject& object) {
  const std::size_t first = polygons.vertices.size();
  std::size_t begin = object.corners.size();
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
    // A mirror turns faces inside out (glTF 2.0, 3.7.4).
    if (transform.Determinant() < 0) std::reverse(object.corners.begin() + std::ptrdiff_t(begin), object.corners.end());
    object.ends.push_back(begin = object.corners.size());
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

}  // namespace

Polygons read_with_assimp(const std::filesystem::path& path) {
  const std::string json = json_of(path);
  constexpr std::string_view kMark = "\xef\xbb\xbf";  // byte order mark of UTF-8, which Assimp does not know
  const bool marked = json.starts_with(kMark);
  const std::string_view text = std::string_view(json).substr(marked ? kMark.size() : 0);
  require_known_shape(std::string(text));
  Assimp::Importer importer;
  // The importer owns the handler.
  auto* const files = new MeshAndFilesBeside(path.string(), marked ? text : "");
  importer.SetIOHandler(files);
  // No post-processing: Assimp's triangulation ends the program on damaged files.
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (!files->pointer().empty()) (void)readable_size(files->pointer());  // throws
  if (scene == nullptr || scene->mRootNode == nullptr) throw Error(cause_of(importer.GetErrorString()));
  Polygons polygons;
  collect(*scene, *scene->mRootNode, aiMatrix4x4(), polygons);
  return polygons;
}

}  // namespace hapticut
