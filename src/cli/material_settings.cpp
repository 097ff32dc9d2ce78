// SPDX-License-Identifier: Apache-2.0
#include "cli/material_settings.hpp"

#include <algorithm>

#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::cli {
namespace {

std::vector<std::string> known_presets() { return {preset_names().begin(), preset_names().end()}; }

std::vector<Setting> settings_of(MaterialChange& m) {
  const Range positive = Range::positive(), not_negative = Range::not_negative();
  return {
      text("based_on", "", m.based_on, "the preset that it starts from"),
      number("relative_stiffness", "", m.relative_stiffness, positive, "foundation stiffness over the reference"),
      number("damping_s_per_m", "", m.damping, not_negative, "Hunt-Crossley factor"),
      number("cutting_ratio", "", m.cutting_ratio, not_negative, "tangential over normal force of the spinning head"),
      number("specific_cutting_energy_J_per_m3", "", m.specific_cutting_energy, positive, "energy to cut away"),
      number("edge_pressure_Pa", "", m.edge_pressure, not_negative, "pressure below which nothing is cut"),
      number("static_friction", "", m.static_friction, not_negative, "of the standing spindle"),
      number("dynamic_friction", "", m.dynamic_friction, not_negative, "of the standing spindle"),
      number("tangential_stiffness_N_per_m", "", m.tangential_stiffness, positive, "of the sticking anchor"),
      number("density_kg_per_m3", "", m.density, positive, "mass over volume"),
  };
}

void apply(const MaterialChange& change, Material& material) {
  const auto set = [](const std::optional<double>& from, double& to) { to = from.value_or(to); };
  set(change.relative_stiffness, material.relative_stiffness);
  set(change.damping, material.damping);
  set(change.cutting_ratio, material.cutting_ratio);
  set(change.specific_cutting_energy, material.specific_cutting_energy);
  set(change.edge_pressure, material.edge_pressure);
  set(change.static_friction, material.static_friction);
  set(change.dynamic_friction, material.dynamic_friction);
  set(change.tangential_stiffness, material.tangential_stiffness);
  set(change.density, material.density);
  validate(material);
}

}  // namespace

Setting MaterialChanges::setting() {
  Setting setting;
  setting.key = "material";
  setting.meaning = "constants of materials, by name";
  setting.kind = Setting::Kind::named_tables;
  setting.open_table = [this](const std::string& name) { return settings_of(changes_[name]); };
  return setting;
}

Material MaterialChanges::find(const std::string& name) const {
  const std::vector<std::string> presets = known_presets();
  const auto change = changes_.find(name);
  const std::string base =
      change != changes_.end() && !change->second.based_on.empty() ? change->second.based_on : name;
  if (std::find(presets.begin(), presets.end(), base) == presets.end()) {
    std::string known;
    for (const std::string& preset : presets) known += (known.empty() ? "" : ", ") + preset;
    throw Error("there is no material " + base + "; the presets are " + known + "." + suggestion(base, presets) +
                " For one of your own write [material." + base + "] with based_on = \"a preset\".");
  }
  Material material = find_preset(base);
  material.name = name;
  if (change != changes_.end()) apply(change->second, material);
  return material;
}

Material MaterialChanges::changed(Material material) const {
  const auto change = changes_.find(material.name);
  if (change == changes_.end()) return material;
  return change->second.based_on.empty() ? (apply(change->second, material), material) : find(material.name);
}

}  // namespace hapticut::cli
