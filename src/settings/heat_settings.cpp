// SPDX-License-Identifier: Apache-2.0
#include "settings/heat_settings.hpp"

#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

constexpr Keys kHeat{"heat", "", {{"cutting_share", "cutting_share", "that of the cutter"}}};

}  // namespace

std::vector<Setting> settings_of(HeatSettings& s) {
  std::vector<Setting> settings = {
      boolean("heat.on", "--heat", s.on, "computes the temperatures of the workpiece, beside the steps [false]")};
  s.config.add_settings(kHeat, settings);
  return settings;
}

std::optional<HeatConfig> make_heat(const HeatSettings& s, const MaterialTable& materials,
                                    const MaterialChanges& changes) {
  if (!s.on) {
    s.config.refuse(kHeat, "a run without " + "heat.on"_name, "set " + "heat.on"_name);
    return std::nullopt;
  }
  HeatConfig config = s.config.make(kHeat, "the heat");
  for (const Material& material : materials.all())
    config.by_material.push_back(thermal_properties_of(changes.base_of(material.name)));
  return config;
}

}  // namespace hapticut::settings
