// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
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

  std::optional<const HeadShape*> head;                          ///< null: a profile head
  std::map<std::string_view, std::optional<double>> dimensions;  ///< [mm, deg, 1] those of the head, by name
  std::optional<FlatRule> flat_rule;
  std::string profile;  ///< file
  std::optional<ShankKind> shank;
  std::optional<double> shank_neck_mm;
  std::optional<HandleKind> handle;
  std::optional<double> handle_length_mm, handle_neck_mm, handle_bend_deg;
  std::optional<double> spindle_rpm;
  std::optional<CutterKind> cutter;
  std::optional<Sharpness> sharpness;  ///< for the presets of the workpiece
  std::size_t lips = 0;                ///< 0: not set
  std::optional<MotorKind> motor;
  std::optional<double> power_limit_W, acceleration_rpm_per_s, droop_rpm_per_Nmm, torque_limit_Nmm, rotor_inertia_gmm2;

  /// [mm, deg, 1]
  [[nodiscard]] std::optional<double> dimension(std::string_view name) const;
  void set_sphere(double radius_mm);
};

[[nodiscard]] std::vector<Setting> settings_of(ToolSettings& tool);

/// `tool.sharpness`, for the presets of a workpiece.
[[nodiscard]] Setting sharpness_setting(std::optional<Sharpness>& sharpness);

/// `tool.cutter`.
/// @param standard  kind without the setting, in words
[[nodiscard]] Setting cutter_setting(std::optional<CutterKind>& cutter, const std::string& standard);

/// The key of a dimension of heads: "tool.tip_diameter_mm".
[[nodiscard]] std::string key_of_dimension(std::string_view name, std::string_view unit);

/// @throws Error when this kind of head or handle lacks a setting, or a setting of another kind is set
[[nodiscard]] Tool make_tool(const ToolSettings& settings);

}  // namespace hapticut::settings
