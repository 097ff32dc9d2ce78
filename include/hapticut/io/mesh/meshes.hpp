// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/mesh.hpp"

/// @file
/// Triangle meshes from and to files. Files hold plain numbers: millimetres unless `unit_mm` says otherwise, or the
/// format does (`read_mesh`).
namespace hapticut {

/// One object of a mesh file.
struct NamedMesh {
  std::string name;  ///< as in the file; without one there it is empty, or "object 2" where the file has several
  TriangleMesh mesh;
};

/// Reads an OBJ, STL, PLY or OFF file; with Assimp (HAPTICUT_WITH_ASSIMP) also glTF (.gltf, .glb). Each object (OBJ:
/// `o` or `g`, STL: `solid`) is a mesh of its own; vertices at the same place are one vertex, triangles without area
/// are dropped, polygons are cut into triangles. Normals, colours and textures are skipped.
/// @param unit_mm  [mm] length of one unit of the file; without it 1, and of glTF, which is in metres, 1000
/// @throws Error that names the file, and where it can the line or the face, when it is missing, damaged, of another
///         kind, holds no triangle, has a coordinate that is not finite or a face without enough corners, or is more
///         than 100 m long
[[nodiscard]] std::vector<NamedMesh> read_mesh(const std::filesystem::path& path,
                                               std::optional<double> unit_mm = std::nullopt);

/// Writes a binary STL file, in units of `unit_mm`. What was at `path` before stays until the new file is complete.
/// @throws Error when the file cannot be written completely
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes a binary PLY file, in units of `unit_mm`.  @throws Error as above
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes a binary PLY file with a colour per vertex.  @throws Error as above, and when colours are missing
void write_ply(const ColoredMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes an OBJ file, in units of `unit_mm`, with all digits of its coordinates.  @throws Error as above
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path, double unit_mm = 1);

/// Writes an OBJ file of several objects, each under its name.  @throws Error as above
void write_obj(const std::vector<NamedMesh>& objects, const std::filesystem::path& path, double unit_mm = 1);

}  // namespace hapticut
