// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "import/mesh/polygons.hpp"

/// @file
/// One parser per mesh format. The input may be any bytes: a parser reads them, or throws an Error that names the
/// problem and the line, triangle or face. The caller adds the file name, and passes at most kMaxMeshBytes.
namespace hapticut {

/// [bytes] Limit of a mesh file; above it, the number of vertices could exceed 32 bits.
inline constexpr std::size_t kMaxMeshBytes = std::size_t(1) << 32U;

/// Parses STL, text or binary. Each `solid` of a text is an object.
[[nodiscard]] Polygons parse_stl(std::string_view file);

/// Parses PLY, text or binary in either byte order. Faces are the lists `vertex_indices` (or `vertex_index`) of the
/// element `face`; triangle strips are the lists of `tristrips`. Everything else is skipped.
[[nodiscard]] Polygons parse_ply(std::string_view file);

/// Parses OBJ. Each name after `o` or `g` is an object. Textures, normals, colours, lines and points are skipped.
/// Free-form surfaces are refused, because without them a part of the shape would be missing.
[[nodiscard]] Polygons parse_obj(std::string_view file);

/// Parses OFF in text form. Normals and colours are skipped.
[[nodiscard]] Polygons parse_off(std::string_view file);

/// Writes a valid STL or PLY file (by the extension) without vertices and triangles, in mm: the surface of a workpiece
/// of which nothing is left. Readers refuse it.
/// @throws Error when the file cannot be written completely
void write_without_triangles(const std::filesystem::path& path);

/// Reads a glTF file.
/// @throws Error also when the library was built without Assimp
[[nodiscard]] Polygons read_with_assimp(const std::filesystem::path& path);

}  // namespace hapticut
