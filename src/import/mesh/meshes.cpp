// SPDX-License-Identifier: Apache-2.0
#include "hapticut/import/mesh/meshes.hpp"

#include "hapticut/core/units.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "import/mesh/other_files.hpp"
#include "io/file_errors.hpp"

namespace hapticut {
namespace {

constexpr double kMaxExtent = 100;           // [m] a larger mesh has a wrong unit
constexpr double kMinPlausibleLength = 0.1;  // [mm] minimum length of a workpiece or head
constexpr double kMaxOffset = 1e6;           // [extents] from the origin; beyond it, single precision loses the shape

/// @throws Error unless the size of the file is supported
void require_readable(const std::filesystem::path& path) {
  const std::uint64_t size = readable_size(path);
  if (size == 0) cannot_read(path, "the file is empty.");
  if (size > kMaxMeshBytes)
    cannot_read(path, "it has " + format_number(double(size)) + " bytes; at most " +
                          format_number(double(kMaxMeshBytes)) + " are allowed. Reduce the mesh first.");
}

/// Throws what the file is when it is of another kind than its extension.
void require_own_extension(const std::filesystem::path& path, const MeshFormat& format) {
  constexpr std::size_t kHead = 1000;
  const std::string other = kind_unlike_extension(first_bytes(path, kHead), std::filesystem::file_size(path), format);
  if (!other.empty()) throw Error(other);
}

/// @throws Error; when the file is of another kind than its extension, the message says which
Polygons polygons_in(const std::filesystem::path& path, const MeshFormat& format) {
  try {
    Polygons polygons = format.read(path);
    if (polygons.objects.empty()) require_own_extension(path, format);
    return polygons;
  } catch (const Error&) {
    require_own_extension(path, format);
    throw;
  }
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
    const std::optional<Sentence> units = plausible_units(extent / units::mm / unit_mm, kMinPlausibleLength);
    cannot_read(path,
                "with a unit of " + format_number(unit_mm) + " mm it is " + format_number(extent / units::mm) +
                    " mm long; at most " + format_number(kMaxExtent / units::mm) + " mm are allowed. " +
                    (units ? "Set " + *units + "." : "Check its coordinates and its unit (" + "unit_mm"_name + ")."));
  }
  if (offset > kMaxOffset * extent)
    cannot_read(
        path, "it lies " + format_number(offset / extent) +
                  " times its own size away from the origin, so its coordinates have lost the shape; move it nearer.");
}

}  // namespace

std::vector<NamedMesh> read_mesh(const std::filesystem::path& path, std::optional<double> unit_mm) {
  const double unit = unit_mm.value_or(common_unit_mm(path));
  require_positive(unit, "unit_mm [mm]");
  const MeshFormat* const format = mesh_format_of(path);
  if (format == nullptr)
    cannot_read(path, "its extension is '" + extension_in_lower_case(path) +
                          "'; supported are: " + in_one_line(kMeshExtensions) + ".");
  require_readable(path);
  std::vector<NamedMesh> meshes = naming(path, [&] { return to_meshes(polygons_in(path, *format), unit * units::mm); });
  if (meshes.empty()) cannot_read(path, "it has no triangle with an area.");
  check_extent(meshes, path, unit);
  return meshes;
}

}  // namespace hapticut
