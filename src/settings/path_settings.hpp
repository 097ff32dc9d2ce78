// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hapticut/settings/motion.hpp"
#include "hapticut/tool/tool.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[path]` of a settings file: the motion of the tool. All positions in W.
struct PathSettings {
  enum class Kind { line, circle, spiral, cavity, poses };
  enum class Point { tip, head, handle };  ///< tip: the lower end of the head on the spindle axis

  std::optional<Kind> kind;
  std::optional<Point> point;           ///< point of the tool that follows the path
  std::optional<double> feed_mm_per_s;  ///< along the path
  std::optional<double> approach_mm;    ///< distance before the path, along the spindle axis, from outside
  std::optional<double> approach_feed_mm_per_s;
  std::optional<double> retract_mm;     ///< distance after the path, along the spindle axis, outwards
  std::optional<Vec3> tool_axis;        ///< direction of +z of T: from the tip to the shank
  std::optional<double> tool_roll_deg;  ///< rotation of the tool about its axis

  std::optional<Vec3> from_mm, to_mm;                                        // line
  std::optional<Vec3> center_mm, axis;                                       // circle, spiral, cavity
  std::optional<double> radius_mm, turns, start_angle_deg;                   // circle
  std::optional<double> start_radius_mm, end_radius_mm, pitch_mm, depth_mm;  // spiral; the last two also cavity
  std::optional<double> top_radius_mm, bottom_radius_mm, layer_mm;           // cavity
  std::string file;                                                          // poses
};

[[nodiscard]] std::vector<Setting> settings_of(PathSettings& path);

/// Motion of the tool head, X_WT over time.
/// @throws Error when this kind of path lacks a setting, or a setting of another kind is set
[[nodiscard]] Motion make_motion(const PathSettings& settings, const Tool& tool);

}  // namespace hapticut::settings
