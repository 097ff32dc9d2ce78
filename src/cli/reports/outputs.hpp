// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/commands/drill.hpp"
#include "settings/setting.hpp"

namespace hapticut::cli {

/// The files that a run leaves behind, as the user writes them: `[output]` in a settings file. Empty: not wanted.
struct OutputSettings {
  std::string json, steps_csv, workpiece, surface, picture, record;
  std::optional<Vec3> picture_view;  ///< [1] direction from the camera into the scene
};

[[nodiscard]] std::vector<settings::Setting> settings_of(OutputSettings& outputs);

/// Says before the work begins that a file cannot be written, rather than after it.
/// @throws Error naming the file
void check_outputs(const OutputSettings& outputs);

/// The same for a file that a workpiece is written to.
/// @throws Error also when its extension names no format that this program writes
void check_workpiece_file(const std::string& path);

/// Writes what is left of the workpiece, in the format that the extension names: see `check_workpiece_file`.
/// @throws Error when the file cannot be written
void write_workpiece(const std::string& path, const Workpiece& workpiece);

/// Writes the surface of what is left: .stl, or .ply with colours.
/// @throws Error as above
void write_surface(const std::string& path, const Workpiece& workpiece);

/// Draws what is left, as PNG.
/// @throws Error when the file cannot be written
void write_picture_of(const OutputSettings& outputs, const Workpiece& workpiece);

/// One line per step. Positions and rotations are those of the head, and can be read again as a path of poses with
/// `point = "head"`.
void write_steps(const std::string& path, const std::vector<StepRow>& rows);

}  // namespace hapticut::cli
