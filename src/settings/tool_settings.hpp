// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/shank.hpp"
#include "hapticut/tool/tool.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// The tool as the user writes it: `[tool]` in a settings file.
struct ToolSettings {
  enum class Head {
    sphere,
    cone,
    flat,
    profile,
    round,
    inverted_cone,
    cylinder,
    round_end_cylinder,
    tapered,
    round_end_tapered,
    needle,
    flame,
    pear,
    wheel,
    christmas_tree,
    twist_drill
  };
  enum class HandleKind { ray, angled };

  std::optional<Head> head;
  std::optional<double> radius_mm, height_mm, half_angle_deg;
  std::optional<FlatRule> flat_rule;
  std::optional<double> diameter_mm, length_mm, tip_diameter_mm, neck_diameter_mm, shank_diameter_mm, widest_height_mm;
  std::optional<double> point_angle_deg;
  std::size_t tiers = 0;  ///< 0: not given
  std::string profile;    ///< file
  std::optional<ShankKind> shank;
  std::optional<double> shank_neck_mm;
  std::optional<HandleKind> handle;
  std::optional<double> handle_length_mm, handle_neck_mm, handle_bend_deg;
  std::optional<double> spindle_rpm;
  std::optional<CutterKind> cutter;
  std::size_t lips = 0;  ///< 0: not given
  std::optional<MotorKind> motor;
  std::optional<double> power_limit_W, acceleration_rpm_per_s, droop_rpm_per_Nmm, torque_limit_Nmm, rotor_inertia_gmm2;
};

[[nodiscard]] std::vector<Setting> settings_of(ToolSettings& tool);

/// @throws Error when something is missing for this kind of head or handle, or was set but does not belong to it
[[nodiscard]] Tool make_tool(const ToolSettings& settings);

}  // namespace hapticut::settings
