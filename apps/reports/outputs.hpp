// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/delivery.hpp"
#include "reports/drill.hpp"
#include "settings/setting.hpp"

namespace hapticut::apps {

/// `[output]` of a settings file: the files that a run writes. Empty: no file.
struct OutputSettings {
  std::string json, steps_csv, workpiece, surface, picture, record;
  std::optional<Vec3> picture_view;  ///< [1] direction from the camera into the scene
};

[[nodiscard]] std::vector<settings::Setting> settings_of(OutputSettings& outputs);

/// A setting that names the file for a workpiece; its files include the second one of a .nrrd.
[[nodiscard]] settings::Setting workpiece_file(std::string key, std::string flag, std::string& target,
                                               std::string meaning);

/// Checks before the work begins that the files can be written.
/// @throws UsageError that names all files of an unknown extension
/// @throws Error when none of the files can be written
[[nodiscard]] Delivery delivery_of(const OutputSettings& outputs);

/// Checks before the work begins that a workpiece can be written to a file.
/// @throws UsageError when its extension is unknown
/// @throws Error that names the file, also when this program does not write its format
void check_workpiece_file(const std::string& path);

/// A sentence when a file shows nothing because no surface is left of the workpiece; else empty.
[[nodiscard]] std::string warning_of_empty_file(const std::string& path, const Workpiece& workpiece);

/// The same for all files of a run.
[[nodiscard]] std::string warning_of_empty_outputs(const OutputSettings& outputs, const Workpiece& workpiece);

/// Writes the remaining workpiece in the format of the extension: see `check_workpiece_file`. An empty workpiece is one
/// empty voxel in a .nrrd.
/// @throws Error when the file cannot be written
void write_workpiece(const std::string& path, const Workpiece& workpiece);

/// Writes the surface of the remaining workpiece: .stl, or .ply with colours; without triangles if nothing is left.
/// @throws Error when the file cannot be written
void write_surface(const std::string& path, const Workpiece& workpiece);

/// Draws the remaining workpiece as PNG; the background alone if nothing is left.
/// @throws Error when the file cannot be written
void write_picture_of(const OutputSettings& outputs, const Workpiece& workpiece);

/// Writes one line per step. The poses are those of the head; a path of poses with `point = "head"` can read them.
void write_steps(const std::string& path, const std::vector<StepRow>& rows);

}  // namespace hapticut::apps
