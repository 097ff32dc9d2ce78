// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "cli/setting.hpp"
#include "hapticut/tool/tool.hpp"

namespace hapticut::cli {

/// The tool as the user writes it: `[tool]` in a settings file.
struct ToolSettings {
  enum class Head { sphere, cone, flat };
  enum class HandleKind { ray, angled };

  std::optional<Head> head;
  std::optional<double> radius_mm, height_mm, half_angle_deg;
  std::optional<FlatRule> flat_rule;
  std::optional<HandleKind> handle;
  std::optional<double> handle_length_mm, handle_neck_mm, handle_bend_deg;
  std::optional<double> spindle_rpm;
  std::optional<double> power_limit_W;
};

[[nodiscard]] std::vector<Setting> settings_of(ToolSettings& tool);

/// @throws Error when something is missing for this kind of head or handle, or was set but does not belong to it
[[nodiscard]] Tool make_tool(const ToolSettings& settings);

}  // namespace hapticut::cli
