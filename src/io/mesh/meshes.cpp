// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/mesh/meshes.hpp"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh/ply_check.hpp"

namespace hapticut {
namespace {

constexpr double kMaxExtent = 100;        // [m] a mesh this large has a wrong unit
constexpr double kMaxOffset = 1e6;        // [extents] from the origin: beyond, single precision loses the shape
constexpr int kMaxWholeDigits = 15;       // Assimp reads longer numbers as something else, without a word
constexpr std::size_t kStlHeader = 84;    // bytes of a binary STL file before its triangles
constexpr std::size_t kStlTriangle = 50;  // bytes
static_assert(std::endian::native == std::endian::little, "binary STL and PLY are written as the memory has them");

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error("cannot read mesh '" + path.string() + "': " + reason);
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string read_bytes(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) fail(path, "it is a folder; give a mesh file.");
  errno = 0;
  std::ifstream stream(path, std::ios_base::binary);
  if (!stream) fail(path, std::generic_category().message(errno) + "; check the path and its permissions.");
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_text(const std::string& bytes, const std::string& extension) {
  if (extension == ".ply") return bytes.substr(0, 200).find("format binary") == std::string::npos;
  return bytes.substr(0, 1000).find('\0') == std::string::npos;
}

/// Assimp overflows silently on numbers with many digits before the decimal point: found here, in lines that are no
/// comment.
void check_numbers(const std::string& text, const std::filesystem::path& path) {
  int digits = 0;
  bool fraction = false, comment = false;
  long line = 1;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      comment = false;
    }
    comment |= c == '#';
    if (c >= '0' && c <= '9') {
      digits += fraction ? 0 : 1;
      if (digits > kMaxWholeDigits && !comment)
        fail(path, "line " + std::to_string(line) + " has a number with more than " + std::to_string(kMaxWholeDigits) +
                       " digits before its decimal point.");
      continue;
    }
    digits = 0;
    fraction = c == '.';
  }
}

/// A binary STL file says how many triangles it has; the file must be that long.
void check_stl(const std::string& bytes, const std::filesystem::path& path) {
  if (is_text(bytes, ".stl") && bytes.find("facet") != std::string::npos) {
    if (bytes.find("endsolid") == std::string::npos) fail(path, "it ends before 'endsolid'; it was cut off.");
    return;
  }
  if (bytes.size() < kStlHeader) fail(path, "it is neither a text nor a binary STL file, or it is empty.");
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, bytes.data() + 80, 4);
  if (bytes.size() < kStlHeader + triangles * kStlTriangle)
    fail(path, "it announces " + std::to_string(triangles) + " triangles, but ends after " +
                   std::to_string((bytes.size() - kStlHeader) / kStlTriangle) + "; it was cut off.");
}

/// Welds vertices at the same place and drops triangles that have no three different ones.
class MeshCollector {
 public:
  explicit MeshCollector(const std::filesystem::path& path, double unit) : path_(path), unit_(unit) {}

  void add(const aiMesh& mesh, const aiMatrix4x4& transform) {
    std::vector<std::uint32_t> welded(mesh.mNumVertices, kUnused);
    for (unsigned n = 0; n < mesh.mNumFaces; ++n) {
      const aiFace& face = mesh.mFaces[n];
      if (face.mNumIndices < 3)
        fail(path_, "face " + std::to_string(n + 1) + " of object '" + mesh.mName.C_Str() + "' has " +
                        std::to_string(face.mNumIndices) + " corners; at least 3 are needed.");
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        const unsigned v = face.mIndices[k];
        if (v >= mesh.mNumVertices) fail(path_, "a face names a vertex that does not exist.");
        if (welded[v] == kUnused) welded[v] = weld(transform * mesh.mVertices[v]);
      }
      // Polygons become fans. Where a polygon is not convex its triangles overlap with opposite signs, so that volumes
      // and winding numbers are right all the same. (Assimp's own triangulation aborts the program on damaged files.)
      for (unsigned k = 2; k < face.mNumIndices; ++k) {
        const std::array<std::uint32_t, 3> triangle = {welded[face.mIndices[0]], welded[face.mIndices[k - 1]],
                                                       welded[face.mIndices[k]]};
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
          mesh_.triangles.push_back(triangle);
      }
    }
  }

  [[nodiscard]] TriangleMesh take() { return std::move(mesh_); }

 private:
  static constexpr std::uint32_t kUnused = 0xffffffff;

  std::uint32_t weld(const aiVector3D& p) {
    const Vec3 position(double(p.x), double(p.y), double(p.z));
    if (!is_finite(position)) fail(path_, "a coordinate is not a finite number; repair the mesh.");
    const std::array<double, 3> key = {position.x() + 0.0, position.y() + 0.0, position.z() + 0.0};  // -0 is 0
    const auto [entry, is_new] = index_.try_emplace(key, std::uint32_t(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.emplace_back(unit_ * position);
    return entry->second;
  }

  const std::filesystem::path& path_;
  double unit_;
  TriangleMesh mesh_;
  std::map<std::array<double, 3>, std::uint32_t> index_;
};

void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, const std::filesystem::path& path,
             double unit, std::vector<NamedMesh>& meshes) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  MeshCollector collector(path, unit);
  std::string name = node.mName.C_Str();
  for (unsigned n = 0; n < node.mNumMeshes; ++n) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[n]];
    collector.add(mesh, transform);
    if (mesh.mName.length > 0) name = mesh.mName.C_Str();
  }
  TriangleMesh mesh = collector.take();
  if (!mesh.triangles.empty()) meshes.push_back({name, std::move(mesh)});
  for (unsigned n = 0; n < node.mNumChildren; ++n) collect(scene, *node.mChildren[n], transform, path, unit, meshes);
}

void check_extent(const std::vector<NamedMesh>& meshes, const std::filesystem::path& path) {
  Vec3 min = meshes[0].mesh.vertices[0], max = min;
  for (const NamedMesh& object : meshes)
    for (const Vec3& v : object.mesh.vertices) {
      min = min.cwiseMin(v);
      max = max.cwiseMax(v);
    }
  const double extent = (max - min).maxCoeff();
  const double offset = std::max(min.cwiseAbs().maxCoeff(), max.cwiseAbs().maxCoeff());
  if (extent > kMaxExtent)
    fail(path, "it is " + format_number(extent) + " m long; at most " + format_number(kMaxExtent) +
                   " m are allowed. Check its coordinates and unit_mm.");
  if (offset > kMaxOffset * extent)
    fail(path, "it lies " + format_number(offset / extent) +
                   " times its own size from the origin, where coordinates have lost its shape; move it nearer.");
}

/// Appends the bytes of a value.
template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append(std::string& bytes, const Vec3& v, double scale) {
  for (int axis = 0; axis < 3; ++axis) append(bytes, float(v[axis] * scale));
}

void write_ply(const TriangleMesh& mesh, const std::vector<Color>* colors, const std::filesystem::path& path,
               double unit_mm) {
  require_positive(unit_mm, "unit_mm [mm]");
  const double scale = 1 / (unit_mm * units::mm);
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment written by hapticut, one unit is " +
                      format_number(unit_mm) + " mm\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\n";
  if (colors != nullptr) bytes += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  bytes += "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) {
    append(bytes, mesh.vertices[n], scale);
    if (colors == nullptr) continue;
    for (const std::uint8_t value : {(*colors)[n].red, (*colors)[n].green, (*colors)[n].blue}) append(bytes, value);
  }
  for (const auto& t : mesh.triangles) {
    append(bytes, std::uint8_t(3));
    for (const std::uint32_t v : t) append(bytes, std::int32_t(v));
  }
  write_atomically(path, [&](std::ostream& stream) { stream.write(bytes.data(), std::streamsize(bytes.size())); });
}

}  // namespace

std::vector<NamedMesh> read_mesh(const std::filesystem::path& path, double unit_mm) {
  require_positive(unit_mm, "unit_mm [mm]");
  const std::string extension = lower_extension(path);
  if (extension != ".obj" && extension != ".stl" && extension != ".ply" && extension != ".off")
    fail(path, "its extension is '" + extension + "'; .obj, .stl, .ply and .off can be read.");
  {
    const std::string bytes = read_bytes(path);
    if (bytes.empty()) fail(path, "the file is empty.");
    if (is_text(bytes, extension)) check_numbers(bytes, path);
    if (extension == ".stl") check_stl(bytes, path);
    if (extension == ".ply") {
      const std::string damage = find_ply_damage(bytes);
      if (!damage.empty()) fail(path, damage + ".");
    }
  }
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  std::vector<NamedMesh> meshes;
  if (scene != nullptr && scene->mRootNode != nullptr)
    collect(*scene, *scene->mRootNode, aiMatrix4x4(), path, unit_mm * units::mm, meshes);
  else
    fail(path, std::string("it is damaged or holds no mesh (Assimp: ") + importer.GetErrorString() + ").");
  if (meshes.empty()) fail(path, "there is no triangle with an area in it.");
  check_extent(meshes, path);
  return meshes;
}

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  require_positive(unit_mm, "unit_mm [mm]");
  const double scale = 1 / (unit_mm * units::mm);
  std::string bytes = "written by hapticut, one unit is " + format_number(unit_mm) + " mm";
  bytes.resize(80, ' ');
  append(bytes, std::uint32_t(mesh.triangles.size()));
  bytes.reserve(kStlHeader + kStlTriangle * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 normal = (b - a).cross(c - a);
    append(bytes, normal.norm() > 0 ? Vec3(normal / normal.norm()) : Vec3(Vec3::Zero()), 1);
    for (const Vec3& v : {a, b, c}) append(bytes, v, scale);
    append(bytes, std::uint16_t(0));
  }
  write_atomically(path, [&](std::ostream& stream) { stream.write(bytes.data(), std::streamsize(bytes.size())); });
}

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  write_ply(mesh, nullptr, path, unit_mm);
}

void write_ply(const ColoredMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  if (mesh.colors.size() != mesh.mesh.vertices.size())
    throw Error("the mesh has " + std::to_string(mesh.mesh.vertices.size()) + " vertices but " +
                std::to_string(mesh.colors.size()) + " colours; give one colour per vertex.");
  write_ply(mesh.mesh, &mesh.colors, path, unit_mm);
}

}  // namespace hapticut
