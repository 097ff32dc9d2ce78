// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Reads and writes workpieces as `.vdb` files.
///
/// A saved workpiece is an ordinary OpenVDB file with three grids on one index space: float `density` (filled fraction,
/// fog volume), int32 `material` (ids) and int32 `centroid` (packed CentroidOffset). Its transform carries the voxel
/// size and the pose in **millimetres** (in metres, OpenVDB refuses voxels below 14 um). The metadata of `material`
/// carries the material table, the exact voxel size and the exact pose, in SI.
namespace hapticut {

/// Writes a workpiece without loss. Uniform regions stay tiles, so a solid block needs kilobytes. An existing file is
/// replaced only when the new file is complete.
/// @throws Error when the file cannot be written completely
void save_vdb(const Workpiece& workpiece, const std::filesystem::path& path);

/// Reads a file of `save_vdb`, bit by bit. If another program has moved or scaled the grid, the new place is kept.
/// @throws Error when the file is missing, damaged, of another kind or was not written by hapticut
[[nodiscard]] Workpiece load_vdb(const std::filesystem::path& path);

/// How to convert a `.vdb` file of another program.
struct VdbImport {
  Material material = {};  ///< material of the whole solid
  std::string grid = {};   ///< name of the float grid; empty: the only float grid of the file
  double unit_mm = 1;      ///< [mm] length of one world unit of the file
  enum class Kind { from_class, level_set, fog_volume } kind = Kind::from_class;  ///< meaning of the values
};

constexpr auto names_of(Of<VdbImport::Kind>) {
  using enum VdbImport::Kind;
  return std::array{
      Named{from_class, "from_class"},
      Named{level_set, "level_set"},
      Named{fog_volume, "fog_volume"},
  };
}

/// Reads a level set or fog volume of another program.
/// @throws Error when the file is missing or damaged, was written by hapticut, has no such float grid, or the grid does
///         not describe a solid
[[nodiscard]] Workpiece load_vdb(const std::filesystem::path& path, const VdbImport& options);

}  // namespace hapticut
