// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/heat/heat_field.hpp"
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

/// Everything that a simulation needs.
struct Scene {
  Workpiece workpiece;                     ///< [workpiece] and [material]
  Tool tool;                               ///< [tool]
  SimulationConfig config;                 ///< [simulation], [force], [effects]; update_rate is simulation.rate_Hz
  std::optional<Motion> motion;            ///< [path]: X_WT of the head over time; nullopt when the text has no [path]
  std::vector<std::string> warnings = {};  ///< remarks about the files that a user must know, e.g. padded samples
  std::optional<HeatConfig> heat = {};     ///< [heat], for a HeatField; nullopt: heat.on is false
  bool remove_loose_pieces = false;        ///< whether an IslandModel or IslandFinder shall remove loose pieces
};

/// Builds the scene that a TOML text describes. The tables [output] and [loop] belong to the program and are ignored.
/// Files other than .vdb need a library built with HAPTICUT_WITH_IMPORT.
/// @param folder  base of relative file names in the text; empty: the working folder
/// @throws Error that names line, key, value and what is allowed: `scene:7: tool.radius_mm: must be a number > 0, not
///         -1.` For an unknown key the message names the most similar key. Also thrown when a setting is missing or
///         contradicts another one, or a file cannot be read
/// @realtime set-up only
[[nodiscard]] Scene from_toml(std::string_view text, const std::filesystem::path& folder = {});

/// Builds the scene that a TOML file describes. Relative file names in it start at its folder.
/// @throws Error that names the file; otherwise like from_toml
[[nodiscard]] Scene from_file(const std::filesystem::path& path);

}  // namespace hapticut::settings
