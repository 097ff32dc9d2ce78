// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/mesh/meshes.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "io/mesh/mesh_extensions.hpp"
#include "io/mesh/mesh_formats.hpp"

namespace hapticut {
namespace {

constexpr double kMaxExtent = 100;  // [m] a mesh this large has a wrong unit
constexpr double kShortest = 0.1;   // [mm] of a mesh that somebody would cut
constexpr double kMaxOffset = 1e6;  // [extents] from the origin: beyond, single precision loses the shape

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error("cannot read mesh '" + path.string() + "': " + reason);
}

/// @throws Error unless it is a file of a size that can be read; a pipe or a device could be read for ever
void require_file(const std::filesystem::path& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (std::filesystem::is_directory(status)) fail(path, "it is a folder; give a mesh file.");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    fail(path, "it is no regular file; give a mesh file.");
  errno = 0;
  if (!std::ifstream(path, std::ios_base::binary))
    fail(path, std::generic_category().message(errno) + "; check the path and its permissions.");
  const auto size = std::filesystem::file_size(path, code);
  if (code) fail(path, code.message() + ".");
  if (size == 0) fail(path, "the file is empty.");
  if (size > kMaxMeshBytes)
    fail(path, "it has " + format_number(double(size)) + " bytes; at most " + format_number(double(kMaxMeshBytes)) +
                   " are read. Reduce the mesh first.");
}

std::vector<std::byte> bytes_of(const std::filesystem::path& path) {
  std::vector<std::byte> bytes(std::filesystem::file_size(path));
  std::ifstream stream(path, std::ios_base::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  if (stream.gcount() != std::streamsize(bytes.size())) fail(path, "it could not be read to its end.");
  return bytes;
}

Polygons parse(const std::filesystem::path& path) {
  const std::string extension = extension_in_lower_case(path);
  if (extension == ".obj") return parse_obj(bytes_of(path));
  if (extension == ".stl") return parse_stl(bytes_of(path));
  if (extension == ".ply") return parse_ply(bytes_of(path));
  if (extension == ".off") return parse_off(bytes_of(path));
  return read_with_assimp(path);
}

void check_extent(const std::vector<NamedMesh>& meshes, const std::filesystem::path& path, double unit_mm) {
  Vec3 min = meshes[0].mesh.vertices[0], max = min;
  for (const NamedMesh& object : meshes)
    for (const Vec3& v : object.mesh.vertices) {
      min = min.cwiseMin(v);
      max = max.cwiseMax(v);
    }
  const double extent = (max - min).maxCoeff();
  const double offset = std::max(min.cwiseAbs().maxCoeff(), max.cwiseAbs().maxCoeff());
  if (extent > kMaxExtent) {
    const std::string units = plausible_units(extent / units::mm / unit_mm, kShortest);
    fail(path, "with a unit of " + format_number(unit_mm) + " mm it is " + format_number(extent / units::mm) +
                   " mm long; at most " + format_number(kMaxExtent / units::mm) + " mm are allowed. " +
                   (units.empty() ? "Check its coordinates and its unit (unit_mm)." : "Give " + units + "."));
  }
  if (offset > kMaxOffset * extent)
    fail(path, "it lies " + format_number(offset / extent) +
                   " times its own size from the origin, where coordinates have lost its shape; move it nearer.");
}

}  // namespace

std::vector<NamedMesh> read_mesh(const std::filesystem::path& path, std::optional<double> unit_mm) {
  const double unit = unit_mm.value_or(common_unit_mm(path));
  require_positive(unit, "unit_mm [mm]");
  if (!is_mesh_file(path)) {
    std::string known;
    for (const std::string_view extension : kOwnMeshExtensions) known += std::string(extension) + " ";
    for (const std::string_view extension : kAssimpExtensions) known += std::string(extension) + " ";
    fail(path, "its extension is '" + extension_in_lower_case(path) +
                   "'; these can be read: " + known.substr(0, known.size() - 1) + ".");
  }
  require_file(path);
  std::vector<NamedMesh> meshes;
  try {
    meshes = to_meshes(parse(path), unit * units::mm);
  } catch (const Error& error) {
    fail(path, error.what());
  } catch (const std::bad_alloc&) {
    fail(path, "there is not enough memory for it; reduce the mesh first.");
  }
  if (meshes.empty()) fail(path, "there is no triangle with an area in it.");
  check_extent(meshes, path, unit);
  return meshes;
}

}  // namespace hapticut
