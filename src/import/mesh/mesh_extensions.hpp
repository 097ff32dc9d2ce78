// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

/// @file
/// Mesh formats by extension: reader and length of a unit.
namespace hapticut {

struct MeshFormat {
  std::string_view extension;                   ///< in lower case, with its dot
  std::string_view name;                        ///< for messages, with its article
  std::array<std::string_view, 5> first_words;  ///< a text of this format begins with one of them; may be empty
  Polygons (*read)(const std::filesystem::path& path);
  double unit_mm;           ///< [mm] default length of one unit
  bool is_archive = false;  ///< may be one
};

/// Reads a file with a parser of this library.
template <Polygons (*kParse)(std::string_view)>
Polygons parsed(const std::filesystem::path& path) {
  return kParse(bytes_of_file(path));
}

/// All supported formats. glTF is in metres by its specification; the others define no unit. Other formats of Assimp
/// are not supported: on damaged 3MF, COLLADA and other files Assimp ends the program or hangs, and it reads the
/// transforms of 3DS objects wrongly. So another format needs a parser of this library.
inline constexpr MeshFormat kMeshFormats[] = {
    {".stl", "an STL file", {"solid"}, parsed<parse_stl>, 1},
    {".ply", "a PLY file", {"ply"}, parsed<parse_ply>, 1},
    {".obj", "an OBJ file", {"mtllib", "v", "o", "g"}, parsed<parse_obj>, 1},
    {".off", "an OFF file", {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"}, parsed<parse_off>, 1},
    {".gltf", "a glTF file", {}, read_with_assimp, 1000},
    {".glb", "a binary glTF file", {}, read_with_assimp, 1000}};

/// The extensions of the table, for callers that do not link the parsers.
inline constexpr auto kMeshExtensions = [] {
  std::array<std::string_view, std::size(kMeshFormats)> extensions;
  std::ranges::transform(kMeshFormats, extensions.begin(), &MeshFormat::extension);
  return extensions;
}();

/// The extension of a name, in lower case.
[[nodiscard]] inline std::string extension_in_lower_case(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

[[nodiscard]] inline bool is_mesh_file(const std::filesystem::path& path) {
  return std::ranges::find(kMeshExtensions, extension_in_lower_case(path)) != kMeshExtensions.end();
}

/// The format of a file by its extension; null when it is not a mesh format.
[[nodiscard]] inline const MeshFormat* mesh_format_of(const std::filesystem::path& path) {
  const MeshFormat* const found =
      std::ranges::find(kMeshFormats, extension_in_lower_case(path), &MeshFormat::extension);
  return found == std::end(kMeshFormats) ? nullptr : found;
}

/// [mm] Default length of one unit.
[[nodiscard]] inline double common_unit_mm(const std::filesystem::path& path) {
  const MeshFormat* const format = mesh_format_of(path);
  return format == nullptr ? 1 : format->unit_mm;
}

inline constexpr double kMaxPlausibleLength = 1000;  ///< [mm] maximum length at which the unit is not questioned

/// The units that make a length plausible: "unit_mm to 1000 if its unit is a metre"; nothing when there is none.
/// @param length    [units of the file]
/// @param min_length  [mm] shortest plausible length
[[nodiscard]] inline std::optional<Sentence> plausible_units(double length, double min_length) {
  std::optional<Sentence> units;
  for (const auto& [unit, name] : {std::pair{1000.0, "a metre"},
                                   {25.4, "an inch"},
                                   {10.0, "a centimetre"},
                                   {1.0, "a millimetre"},
                                   {0.001, "a micrometre"}})
    if (unit * length >= min_length && unit * length <= kMaxPlausibleLength)
      units = (units ? *units + ", " : "") + "unit_mm"_name + " to " + format_number(unit) + " if its unit is " + name;
  return units;
}

}  // namespace hapticut
