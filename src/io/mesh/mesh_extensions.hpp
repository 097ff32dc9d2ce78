// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

/// @file
/// Which files are meshes, by the endings of their names.
namespace hapticut {

/// Read by the library itself.
inline constexpr std::array<std::string_view, 4> kOwnMeshExtensions = {".obj", ".stl", ".ply", ".off"};
/// Read through Assimp. Its other formats are left out: on damaged 3MF, COLLADA and other files it ends the program or
/// never comes back, and of 3DS files it turns the transforms of objects into others.
inline constexpr std::array<std::string_view, 2> kAssimpExtensions = {".glb", ".gltf"};

/// The ending of a name, in lower case.
[[nodiscard]] inline std::string extension_in_lower_case(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

[[nodiscard]] inline bool is_mesh_file(const std::filesystem::path& path) {
  const std::string extension = extension_in_lower_case(path);
  return std::ranges::find(kOwnMeshExtensions, extension) != kOwnMeshExtensions.end() ||
         std::ranges::find(kAssimpExtensions, extension) != kAssimpExtensions.end();
}

}  // namespace hapticut
