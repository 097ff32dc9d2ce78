// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "io/file_errors.hpp"
#include "io/mesh/mesh_formats.hpp"
#include "io/text_lines.hpp"

/// @file
/// Which files are meshes, how each is read and how long its units are, by the ending of its name.
namespace hapticut {

struct MeshFormat {
  std::string_view ending;  ///< in lower case
  Polygons (*read)(const std::filesystem::path& path);
  double unit_mm;  ///< [mm] length of one unit where nobody says it
};

/// Reads a file with a parser of our own.
template <Polygons (*kParse)(std::string_view)>
Polygons parsed(const std::filesystem::path& path) {
  return kParse(bytes_of_file(path));
}

/// All that are read. glTF is in metres by its specification, the others say nothing. Other formats of Assimp are left
/// out: on damaged 3MF, COLLADA and other files it ends the program or never comes back, and of 3DS files it turns the
/// transforms of objects into others.
inline constexpr MeshFormat kMeshFormats[] = {{".stl", parsed<parse_stl>, 1},    {".ply", parsed<parse_ply>, 1},
                                              {".obj", parsed<parse_obj>, 1},    {".off", parsed<parse_off>, 1},
                                              {".gltf", read_with_assimp, 1000}, {".glb", read_with_assimp, 1000}};

/// Those of the table, for callers that read no mesh: they need not be linked to the parsers.
inline constexpr auto kMeshEndings = [] {
  std::array<std::string_view, std::size(kMeshFormats)> endings;
  std::ranges::transform(kMeshFormats, endings.begin(), &MeshFormat::ending);
  return endings;
}();

/// The ending of a name, in lower case.
[[nodiscard]] inline std::string extension_in_lower_case(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

[[nodiscard]] inline bool is_mesh_file(const std::filesystem::path& path) {
  return std::ranges::find(kMeshEndings, extension_in_lower_case(path)) != kMeshEndings.end();
}

/// By the ending of its name; null where that is none of a mesh.
[[nodiscard]] inline const MeshFormat* mesh_format_of(const std::filesystem::path& path) {
  const MeshFormat* const found = std::ranges::find(kMeshFormats, extension_in_lower_case(path), &MeshFormat::ending);
  return found == std::end(kMeshFormats) ? nullptr : found;
}

/// [mm] Length of one unit where nobody says it.
[[nodiscard]] inline double common_unit_mm(const std::filesystem::path& path) {
  const MeshFormat* const format = mesh_format_of(path);
  return format == nullptr ? 1 : format->unit_mm;
}

inline constexpr double kMaxPlausibleLength = 1000;  ///< [mm] of a mesh whose unit nobody need ask for

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
    if (unit * length >= shortest && unit * length <= kMaxPlausibleLength)
      append_part(units, "unit_mm = " + format_number(unit) + " if its unit is " + name, ", ");
  return units;
}

}  // namespace hapticut
