// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/simulation/config.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::cli {

/// A scene to be drilled by hand.
struct ViewScene {
  std::string name;
  Workpiece workpiece;
  Tool tool;
  SimulationConfig config;
  Box box;                    ///< [m] around what is solid, in W
  Vec3 axis = Vec3(0, 0, 1);  ///< of the tool at first, from the tip to the shank, in W
};

/// @param name  clay, molar, skull, a settings file (.toml), or a file that is a workpiece
/// @throws Error when it cannot be made
[[nodiscard]] ViewScene make_view_scene(const std::string& name);

/// Where the tool waits at first: above the middle of the workpiece, along its axis.
[[nodiscard]] Pose waiting_place(const ViewScene& scene);

}  // namespace hapticut::cli
