// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/heat/heat_field.hpp"
#include "hapticut/simulation/config.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::apps {

/// A scene to drill by hand.
struct ViewScene {
  std::string name;
  Workpiece workpiece;
  Tool tool;
  SimulationConfig config;
  Box box;                            ///< [m] bounding box of the solid, in W
  Vec3 axis = Vec3(0, 0, 1);          ///< initial axis of the tool, from the tip to the shank, in W
  HeatConfig heat = {};               ///< how heat spreads, if a page or the scene turns it on
  bool shows_heat = false;            ///< whether it is on at the beginning
  bool removes_loose_pieces = false;  ///< whether pieces that were cut loose disappear, at the beginning
};

/// @param name  clay, molar, skull, a settings file (.toml), or a workpiece (.vdb)
/// @throws Error when the scene cannot be made
[[nodiscard]] ViewScene make_view_scene(const std::string& name);

/// Initial pose of the tool: above the centre of the workpiece, along its axis.
[[nodiscard]] Pose start_pose(const ViewScene& scene);

}  // namespace hapticut::apps
