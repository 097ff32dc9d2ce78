// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/mesh.hpp"

/// @file
/// Reads and writes triangle meshes. The numbers in a file are millimetres, unless `unit_mm` or the format defines
/// another unit (`read_mesh`).
namespace hapticut {

/// One object of a mesh file.
struct NamedMesh {
  std::string name;  ///< name in the file; if it has none: empty, or "object 2" when the file has several objects
  TriangleMesh mesh;
};

/// Reads a mesh file of a format that docs/files.md lists; glTF needs Assimp (HAPTICUT_WITH_ASSIMP). Each object (OBJ:
/// `o` or `g`, STL: `solid`) becomes a separate mesh. Vertices at the same place are merged, triangles without area are
/// dropped, and polygons are split into triangles. Normals, colours and textures are ignored.
/// @param unit_mm  [mm] length of one unit of the file; default 1, for glTF 1000, because glTF is in metres
/// @throws Error that names the file and, if known, the line or the face: when the file is missing, damaged, of another
///         kind, has no triangle, has a coordinate that is not finite, has a face with too few corners, or is more than
///         100 m long
[[nodiscard]] std::vector<NamedMesh> read_mesh(const std::filesystem::path& path,
                                               std::optional<double> unit_mm = std::nullopt);

/// Writes a binary STL file, in units of `unit_mm`. An existing file is replaced only when the new file is complete.
/// @throws Error when the mesh has no triangle, a vertex is not finite, or the file cannot be written completely
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes a binary PLY file, in units of `unit_mm`.
/// @throws Error when the mesh has no triangle, a vertex is not finite, or the file cannot be written completely
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes a binary PLY file with a colour per vertex.
/// @throws Error when colours are missing or the file cannot be written completely
void write_ply(const ColoredMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes an OBJ file, in units of `unit_mm`, with all digits of its coordinates.
/// @throws Error when the mesh has no triangle, a vertex is not finite, or the file cannot be written completely
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes an OBJ file with several named objects.
/// @throws Error when the mesh has no triangle, a vertex is not finite, or the file cannot be written completely
void write_obj(const std::vector<NamedMesh>& objects, const std::filesystem::path& path, double unit_mm = 1);

}  // namespace hapticut
