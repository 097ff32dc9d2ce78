// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "import/mesh/stl_layout.hpp"
#include "io/atomic_file.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL and PLY are written as the memory has them");

/// The unit of a file to write.
struct Unit {
  explicit Unit(double unit_mm) : mm(unit_mm) { require_positive(unit_mm, "unit_mm [mm]"); }
  [[nodiscard]] double scale() const { return 1 / (mm * units::mm); }  // [1/m]
  [[nodiscard]] std::string text() const { return "written by hapticut, one unit is " + format_number(mm) + " mm"; }

  double mm;
};

void require_writable_mesh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw Error("the mesh has no triangle, so there is nothing to write.");
  for (const Vec3& v : mesh.vertices)
    if (!v.allFinite()) throw Error("a vertex of the mesh is not finite, so the mesh cannot be written.");
}

void append(std::string& bytes, const Vec3& v, double scale) {
  for (int axis = 0; axis < 3; ++axis) append_bytes_of(bytes, float(v[axis] * scale));
}

std::string ply_header(const TriangleMesh& mesh, bool colored, const Unit& unit) {
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment " + unit.text() + "\nelement vertex " +
                       std::to_string(mesh.vertices.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\n";
  if (colored) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  return header + "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string stl_header(const TriangleMesh& mesh, const Unit& unit) {
  std::string header = unit.text();
  header.resize(kStlHeader - sizeof(std::uint32_t), ' ');
  append_bytes_of(header, std::uint32_t(mesh.triangles.size()));
  return header;
}

void write_ply(const TriangleMesh& mesh, const std::vector<Color>* colors, const std::filesystem::path& path,
               const Unit& unit) {
  require_writable_mesh(mesh);
  std::string bytes = ply_header(mesh, colors != nullptr, unit);
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) {
    append(bytes, mesh.vertices[n], unit.scale());
    if (colors == nullptr) continue;
    for (const std::uint8_t value : {(*colors)[n].red, (*colors)[n].green, (*colors)[n].blue})
      append_bytes_of(bytes, value);
  }
  for (const auto& t : mesh.triangles) {
    append_bytes_of(bytes, std::uint8_t(3));
    for (const std::uint32_t v : t) append_bytes_of(bytes, std::int32_t(v));
  }
  write_atomically(path, bytes);
}

/// A name for one line; line ends and control characters become blanks.
std::string printable(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return name;
}

/// @param before  number of vertices written before
void append_obj(std::string& text, const TriangleMesh& mesh, double scale, std::size_t before) {
  require_writable_mesh(mesh);
  for (const Vec3& v : mesh.vertices) {
    text += 'v';
    for (const double coordinate : v) {
      text += ' ';
      append_number(text, coordinate * scale);
    }
    text += '\n';
  }
  for (const auto& t : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t v : t) text += ' ' + std::to_string(before + v + 1);
    text += '\n';
  }
}

std::string obj_header(const Unit& unit) { return "# " + unit.text() + '\n'; }

}  // namespace

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  const Unit unit(unit_mm);
  require_writable_mesh(mesh);
  std::string bytes = stl_header(mesh, unit);
  bytes.reserve(kStlHeader + kStlTriangle * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 normal = (b - a).cross(c - a);
    append(bytes, normal.norm() > 0 ? Vec3(normal / normal.norm()) : Vec3(Vec3::Zero()), 1);
    for (const Vec3& v : {a, b, c}) append(bytes, v, unit.scale());
    append_bytes_of(bytes, std::uint16_t(0));
  }
  write_atomically(path, bytes);
}

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  write_ply(mesh, nullptr, path, Unit(unit_mm));
}

void write_ply(const ColoredMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  if (mesh.colors.size() != mesh.mesh.vertices.size())
    throw Error("the mesh has " + std::to_string(mesh.mesh.vertices.size()) + " vertices but " +
                std::to_string(mesh.colors.size()) + " colours; give one colour per vertex.");
  write_ply(mesh.mesh, &mesh.colors, path, Unit(unit_mm));
}

void write_without_triangles(const std::filesystem::path& path) {
  const bool is_ply = extension_in_lower_case(path) == ".ply";
  write_atomically(path, is_ply ? ply_header({}, true, Unit(1)) : stl_header({}, Unit(1)));
}

void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm) {
  const Unit unit(unit_mm);
  std::string text = obj_header(unit);
  append_obj(text, mesh, unit.scale(), 0);
  write_atomically(path, text);
}

void write_obj(const std::vector<NamedMesh>& objects, const std::filesystem::path& path, double unit_mm) {
  const Unit unit(unit_mm);
  std::string text = obj_header(unit);
  std::size_t vertices = 0;
  for (std::size_t n = 0; n < objects.size(); ++n) {
    const std::string& name = objects[n].name;
    text += "o " + (name.empty() ? "object " + std::to_string(n + 1) : printable(name)) + '\n';
    append_obj(text, objects[n].mesh, unit.scale(), vertices);
    vertices += objects[n].mesh.vertices.size();
  }
  write_atomically(path, text);
}

}  // namespace hapticut
