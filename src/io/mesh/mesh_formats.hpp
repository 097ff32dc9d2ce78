// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "io/mesh/polygons.hpp"

/// @file
/// One reader per format of meshes. What they are given may be anything: they read it or throw an Error that says in
/// one sentence what is wrong and in which line, triangle or face. The caller adds the name of the file, and gives no
/// more than kMaxMeshBytes.
namespace hapticut {

/// Beyond, the vertices of a file could be more than 32 bits count.
inline constexpr std::size_t kMaxMeshBytes = std::size_t(1) << 32U;

/// Text or binary. Each `solid` of a text is an object.
[[nodiscard]] Polygons parse_stl(std::string_view file);

/// Text or binary of either byte order. Faces are the lists `vertex_indices` (or `vertex_index`) of the element `face`,
/// and triangle strips those of `tristrips`; everything else is skipped.
[[nodiscard]] Polygons parse_ply(std::string_view file);

/// Each name after `o` or `g` is an object. Textures, normals, colours, lines and points are skipped; free-form
/// surfaces are refused, for without them a part of the shape would be missing.
[[nodiscard]] Polygons parse_obj(std::string_view file);

/// Text, with or without normals and colours, which are skipped.
[[nodiscard]] Polygons parse_off(std::string_view file);

/// Reads a file of glTF.
/// @throws Error also when the library was built without Assimp
[[nodiscard]] Polygons read_with_assimp(const std::filesystem::path& path);

}  // namespace hapticut
