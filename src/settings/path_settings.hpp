// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hapticut/settings/motion.hpp"
#include "hapticut/tool/tool.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// How the tool moves, as the user writes it: `[path]` in a settings file. All positions in W.
struct PathSettings {
  enum class Kind { line, circle, spiral, cavity, poses };
  enum class Point { tip, head, handle };

  std::optional<Kind> kind;
  std::optional<Point> point;           ///< which point of the tool the positions are of
  std::optional<double> feed_mm_per_s;  ///< along the path
  std::optional<double> approach_mm;    ///< before the path, along the spindle axis from outside
  std::optional<double> approach_feed_mm_per_s;
  std::optional<double> retract_mm;     ///< after the path, outwards along the spindle axis
  std::optional<Vec3> tool_axis;        ///< direction of +z of T: from the tip to the shank
  std::optional<double> tool_roll_deg;  ///< turns the tool about its axis

  std::optional<Vec3> from_mm, to_mm;                                        // line
  std::optional<Vec3> center_mm, axis;                                       // circle, spiral, cavity
  std::optional<double> radius_mm, turns, start_angle_deg;                   // circle
  std::optional<double> start_radius_mm, end_radius_mm, pitch_mm, depth_mm;  // spiral; the last two also cavity
  std::optional<double> top_radius_mm, bottom_radius_mm, layer_mm;           // cavity
  std::string file;                                                          // poses
};

[[nodiscard]] std::vector<Setting> settings_of(PathSettings& path);

/// The motion of the tool head, X_WT over time.
/// @throws Error when something is missing for this kind of path, or was set but does not belong to it
[[nodiscard]] Motion make_motion(const PathSettings& settings, const Tool& tool);

/// The point of the tool that `Point::tip` means, in T: where the spindle axis leaves the head at its lower end.
[[nodiscard]] Vec3 tip_in_head(const ToolHead& head);

}  // namespace hapticut::settings
