// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/shank.hpp"
#include "hapticut/tool/tool.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[tool]` of a settings file.
struct ToolSettings {
  enum class HandleKind { ray, angled };

  std::optional<const HeadShape*> head;  ///< null: a profile head
  /// [mm, deg] by HeadDimension, without the tiers
  std::array<std::optional<double>, kHeadDimensions> lengths_and_angles;
  std::size_t tiers = 0;  ///< 0: not set
  std::optional<FlatRule> flat_rule;
  std::string profile;  ///< file
  std::optional<ShankKind> shank;
  std::optional<double> shank_neck_mm;
  std::optional<HandleKind> handle;
  std::optional<double> handle_length_mm, handle_neck_mm, handle_bend_deg;
  std::optional<double> spindle_rpm;
  std::optional<CutterKind> cutter;
  std::size_t lips = 0;  ///< 0: not set
  std::optional<MotorKind> motor;
  std::optional<double> power_limit_W, acceleration_rpm_per_s, droop_rpm_per_Nmm, torque_limit_Nmm, rotor_inertia_gmm2;

  /// [mm, deg, 1]
  [[nodiscard]] std::optional<double> dimension(HeadDimension dimension) const;
  void set_sphere(double radius_mm);
};

[[nodiscard]] std::vector<Setting> settings_of(ToolSettings& tool);

/// @throws Error when this kind of head or handle lacks a setting, or a setting of another kind is set
[[nodiscard]] Tool make_tool(const ToolSettings& settings);

}  // namespace hapticut::settings
