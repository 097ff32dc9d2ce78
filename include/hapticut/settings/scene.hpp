// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/settings/motion.hpp"
#include "hapticut/simulation/config.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Component `settings`, target hapticut::settings: a scene as text, as `hapticut drill --settings` reads it.
///
///     settings::Scene scene = settings::from_file("molar.toml");
///     Simulation simulation(std::move(scene.workpiece), scene.tool, scene.config);
///
/// docs/command-line.md lists every key, what it means and which values it takes.
namespace hapticut::settings {

/// What a simulation is made of.
struct Scene {
  Workpiece workpiece;                     ///< [workpiece] and [material]: built or read
  Tool tool;                               ///< [tool]
  SimulationConfig config;                 ///< [simulation], [force], [effects]; its update_rate is simulation.rate_Hz
  std::optional<Motion> motion;            ///< [path]: X_WT of the head over time; none where the text has no [path]
  std::vector<std::string> warnings = {};  ///< what a user must know of the files: samples that are padding
};

/// Makes what a text in TOML describes. Its tables [output] and [loop] are the program's own and left alone. Files that
/// are no .vdb are read where hapticut was built with HAPTICUT_WITH_IO.
/// @param folder  that the files it names are relative to; empty: the working folder
/// @throws Error that names line, key, value and what is allowed: `scene:7: tool.radius_mm: must be a number > 0, not
///         -1.`; for a key that does not exist the nearest one; and when something is missing, does not fit together or
///         cannot be read
/// @realtime set-up only
[[nodiscard]] Scene from_toml(std::string_view text, const std::filesystem::path& folder = {});

/// The same from a file, whose name stands in the messages. The files that it names are relative to its folder.
[[nodiscard]] Scene from_file(const std::filesystem::path& path);

}  // namespace hapticut::settings
