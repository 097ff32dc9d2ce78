// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hapticut/heat/heat_field.hpp"
#include "settings/given.hpp"
#include "settings/material_settings.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[heat]` of a settings file: the temperatures of the workpiece.
struct HeatSettings {
  bool on = false;
  Given<HeatConfig> config;
};

[[nodiscard]] std::vector<Setting> settings_of(HeatSettings& heat);

/// The configuration of a heat field, with the thermal properties of the materials by their names. A material with
/// `based_on` has those of its preset.
/// @param changes  `[material]`
/// @return nullopt when heat is off
/// @throws Error when heat is off and one of its numbers is given, or a number is not allowed
[[nodiscard]] std::optional<HeatConfig> make_heat(const HeatSettings& settings, const MaterialTable& materials,
                                                  const MaterialChanges& changes);

}  // namespace hapticut::settings
