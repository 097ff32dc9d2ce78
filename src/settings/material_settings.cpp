// SPDX-License-Identifier: Apache-2.0
#include "settings/material_settings.hpp"

#include <algorithm>

#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::settings {
namespace {

std::vector<std::string> known_presets() { return {preset_names().begin(), preset_names().end()}; }

/// Calls `visit(field, number)` for each number of a material.
template <class Change, class Visit>
void visit_numbers(Change& change, const Visit& visit) {
  std::size_t n = 0;
  for_each_number<Material>([&](const auto& field) { visit(field, change.numbers[n++]); });
}

std::vector<Setting> settings_of(MaterialChange& change) {
  std::vector<Setting> settings = {
      text("based_on", "", change.based_on, "preset that supplies the values not set here")};
  visit_numbers(change, [&](const auto& field, std::optional<double>& value) {
    const std::string unit = unit_in_names(field.unit);
    settings.push_back(number(field.name + (unit.empty() ? "" : "_" + unit), "", value, field.range, field.text));
  });
  settings.push_back(choice("cutter", "", change.cutter,
                            "kind of cutter that the constants are for; of a preset it chooses them [that of the tool; "
                            "for a .vdb that of the file]"));
  return settings;
}

void apply(const MaterialChange& change, Material& material) {
  visit_numbers(change, [&](const auto& field, const std::optional<double>& value) {
    material.*field.member = value.value_or(material.*field.member);
  });
  if (change.cutter) material.cutter = change.cutter;
  validate(material);
}

void require_preset(const std::string& name) {
  const std::vector<std::string> presets = known_presets();
  if (std::find(presets.begin(), presets.end(), name) != presets.end()) return;
  throw Error("there is no material " + name + "; the presets are " + joined(presets) + "." +
              suggestion(name, presets) + " For a custom material write [material." + name +
              "] with based_on = \"a preset\".");
}

}  // namespace

Setting MaterialChanges::setting() {
  Setting setting;
  setting.key = "material";
  setting.meaning = "constants of materials, one table for each name";
  setting.kind = Setting::Kind::named_tables;
  setting.explain = [](const std::string& key) {
    return key.ends_with(".share") ? key +
                                         ": there is no such setting, because the share is a factor of presets. "
                                         "Multiply specific_cutting_energy_J_per_m3 by it, and divide size_length_m."
                                   : "";
  };
  setting.open_table = [this](const std::string& name) { return settings_of(changes_[name]); };
  return setting;
}

const std::string& MaterialChanges::base_of(const std::string& name) const {
  const auto change = changes_.find(name);
  return change == changes_.end() || change->second.based_on.empty() ? name : change->second.based_on;
}

Material MaterialChanges::find(const std::string& name) const {
  const auto change = changes_.find(name);
  const std::string& base = base_of(name);
  require_preset(base);
  const bool is_changed = change != changes_.end();
  const CutterKind by = is_changed ? change->second.cutter.value_or(cutter) : cutter;
  Material material = find_preset(base, by, sharpness.value_or(Sharpness::used));
  material.name = name;
  if (is_changed) apply(change->second, material);
  return material;
}

Material MaterialChanges::changed(Material material) const {
  const auto change = changes_.find(material.name);
  if (change == changes_.end()) return material;
  return change->second.based_on.empty() ? (apply(change->second, material), material) : find(material.name);
}

void MaterialChanges::require_known(const MaterialTable& of_workpiece) const {
  for (const auto& [name, change] : changes_) {
    const auto is_this = [&name = name](const Material& material) { return material.name == name; };
    const std::vector<Material>& present = of_workpiece.all();
    if (!change.based_on.empty() || std::none_of(present.begin(), present.end(), is_this))
      require_preset(change.based_on.empty() ? name : change.based_on);
  }
}

}  // namespace hapticut::settings
