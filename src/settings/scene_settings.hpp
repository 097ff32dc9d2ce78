// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/settings/scene.hpp"
#include "settings/heat_settings.hpp"
#include "settings/path_settings.hpp"
#include "settings/simulation_settings.hpp"
#include "settings/tool_settings.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::settings {

/// The settings of a scene, one member per table of the settings file.
struct SceneSettings {
  WorkpieceSettings workpiece;
  ToolSettings tool;
  PathSettings path;
  SimulationSettings simulation;
  HeatSettings heat;
};

[[nodiscard]] std::vector<Setting> settings_of(SceneSettings& scene);

/// @param with_motion  false: ignores the path
/// @throws Error when a setting is missing or contradicts another one, or a file cannot be read
[[nodiscard]] Scene make_scene(const SceneSettings& settings, bool with_motion = true);

}  // namespace hapticut::settings
