// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "io/text_lines.hpp"

/// @file
/// Which files are meshes and how long their units are, by the endings of their names.
namespace hapticut {

/// Read by the library itself; the last two through Assimp. Its other formats are left out: on damaged 3MF, COLLADA and
/// other files it ends the program or never comes back, and of 3DS files it turns the transforms of objects into
/// others.
inline constexpr std::array<std::string_view, 6> kMeshExtensions = {".obj", ".stl", ".ply", ".off", ".glb", ".gltf"};

/// The ending of a name, in lower case.
[[nodiscard]] inline std::string extension_in_lower_case(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

[[nodiscard]] inline bool is_mesh_file(const std::filesystem::path& path) {
  return std::ranges::find(kMeshExtensions, extension_in_lower_case(path)) != kMeshExtensions.end();
}

/// [mm] Length of one unit where nobody says it: glTF is in metres by its specification, the others say nothing.
[[nodiscard]] inline double common_unit_mm(const std::filesystem::path& path) {
  const std::string extension = extension_in_lower_case(path);
  return extension == ".glb" || extension == ".gltf" ? 1000 : 1;
}

inline constexpr double kLongestPlausible = 1000;  ///< [mm] of a mesh whose unit nobody need ask for

/// Which units make a length plausible: "unit_mm = 1000 if its unit is a metre", or nothing.
/// @param length    [units of the file]
/// @param shortest  [mm] that is plausible
[[nodiscard]] inline std::string plausible_units(double length, double shortest) {
  std::string units;
  for (const auto& [unit, name] : {std::pair{1000.0, "a metre"},
                                   {25.4, "an inch"},
                                   {10.0, "a centimetre"},
                                   {1.0, "a millimetre"},
                                   {0.001, "a micrometre"}})
    if (unit * length >= shortest && unit * length <= kLongestPlausible)
      append_part(units, "unit_mm = " + format_number(unit) + " if its unit is " + name, ", ");
  return units;
}

}  // namespace hapticut
