// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/settings/scene.hpp"
#include "settings/path_settings.hpp"
#include "settings/simulation_settings.hpp"
#include "settings/tool_settings.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::settings {

/// A scene as the user writes it.
struct SceneSettings {
  WorkpieceSettings workpiece;
  ToolSettings tool;
  PathSettings path;
  SimulationSettings simulation;
};

[[nodiscard]] std::vector<Setting> settings_of(SceneSettings& scene);

/// @param with_motion  false: the path is not asked for
/// @throws Error when something is missing, cannot be read or does not fit together
[[nodiscard]] Scene make_scene(const SceneSettings& settings, bool with_motion = true);

}  // namespace hapticut::settings
