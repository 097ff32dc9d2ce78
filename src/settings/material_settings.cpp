// SPDX-License-Identifier: Apache-2.0
#include "settings/material_settings.hpp"

#include <algorithm>

#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::cli {
namespace {

std::vector<std::string> known_presets() { return {preset_names().begin(), preset_names().end()}; }

/// A number of Material that the user may change.
struct MaterialField {
  const char* key;
  double Material::*member;
  Range range;
  const char* meaning;
};

const std::array<MaterialField, std::tuple_size_v<decltype(MaterialChange::numbers)>> kMaterialFields = {{
    {"relative_stiffness", &Material::relative_stiffness, Range::positive(), "foundation stiffness over the reference"},
    {"damping_s_per_m", &Material::damping, Range::not_negative(), "Hunt-Crossley factor"},
    {"cutting_ratio", &Material::cutting_ratio, Range::not_negative(),
     "tangential over normal force of the spinning head"},
    {"specific_cutting_energy_J_per_m3", &Material::specific_cutting_energy, Range::positive(), "energy to cut away"},
    {"edge_pressure_Pa", &Material::edge_pressure, Range::not_negative(), "pressure below which nothing is cut"},
    {"static_friction", &Material::static_friction, Range::not_negative(), "of the standing spindle"},
    {"dynamic_friction", &Material::dynamic_friction, Range::not_negative(), "of the standing spindle"},
    {"tangential_stiffness_N_per_m", &Material::tangential_stiffness, Range::positive(), "of the sticking anchor"},
    {"density_kg_per_m3", &Material::density, Range::positive(), "mass over volume"},
}};

std::vector<Setting> settings_of(MaterialChange& change) {
  std::vector<Setting> settings = {text("based_on", "", change.based_on, "the preset that it starts from")};
  for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
    settings.push_back(
        number(kMaterialFields[i].key, "", change.numbers[i], kMaterialFields[i].range, kMaterialFields[i].meaning));
  return settings;
}

void apply(const MaterialChange& change, Material& material) {
  for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
    material.*kMaterialFields[i].member = change.numbers[i].value_or(material.*kMaterialFields[i].member);
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
