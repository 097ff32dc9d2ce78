// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material_presets.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

struct Preset {
  std::string_view name;
  Color color;
};

constexpr std::array kPresets = {
    Preset{"enamel", {240, 236, 222}},
    Preset{"dentin", {224, 196, 138}},
    Preset{"pulp", {196, 72, 72}},
    Preset{"caries", {92, 58, 34}},
    Preset{"amalgam", {150, 152, 158}},
    Preset{"cortical_bone", {232, 220, 190}},
    Preset{"trabecular_bone", {214, 170, 132}},
    Preset{"bone_d1", {250, 240, 180}},
    Preset{"bone_d2", {206, 190, 168}},
    Preset{"bone_d3", {204, 152, 112}},
    Preset{"bone_d4", {186, 130, 122}},
    Preset{"bone_d5", {160, 96, 112}},
    Preset{"clay", {176, 110, 82}},
};

constexpr auto kNames = [] {
  std::array<std::string_view, kPresets.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kPresets[i].name;
  return names;
}();

const Preset& preset_named(std::string_view name) {
  const auto found = std::ranges::find(kPresets, name, &Preset::name);
  if (found != kPresets.end()) return *found;
  std::string known;
  for (const std::string_view other : kNames) known += (known.empty() ? "" : ", ") + std::string(other);
  throw Error("there is no material preset '" + std::string(name) + "'; choose one of: " + known + ".");
}

/// A preset with the numbers that `value_of` takes from their rows.
///
/// A hard material multiplies u of the cutter by its share and divides h_s by it, so every bur feeds 1/share times as
/// fast as in dentin under any load. Drills keep h_e, so that the force below which they cut nothing is proportional to
/// the share.
template <class Choose>
Material compose(std::string_view name, CutterKind cutter, const Choose& value_of) {
  Material material;
  material.name = preset_named(name).name;
  for_each_number<Material>([&](const auto& field) {
    if (const PresetConstant* row = constant_of(name, name_or_null(cutter), field.name))
      material.*field.member = value_of(*row);
  });
  if (const PresetConstant* share = find_constant(name, "share")) {
    material.specific_cutting_energy *= value_of(*share);
    material.size_length /= value_of(*share);
    material.cutter = cutter;
  }
  return material;
}

/// `material` with those numbers that differ in `other` from the typical ones.
Material with_changes_of(Material material, const Material& other, const Material& typical) {
  for_each_number<Material>([&](const auto& field) {
    if (other.*field.member != typical.*field.member) material.*field.member = other.*field.member;
  });
  return material;
}

double typical_of(const PresetConstant& row) { return row.typical; }

bool resists_a_cut(const PresetConstant& row) {
  constexpr std::array kNumbers = {
      "specific_cutting_energy", "share", "edge_pressure", "edge_length", "size_length", "viscosity"};
  return std::ranges::find(kNumbers, row.number) != kNumbers.end();
}

}  // namespace

Material Material::with(Estimate estimate) const {
  const CutterKind by = cutter.value_or(CutterKind::carbide_bur);
  const Material other =
      compose(name, by, [&](const PresetConstant& row) { return resists_a_cut(row) ? row.at(estimate) : row.typical; });
  return with_changes_of(*this, other, compose(name, by, typical_of));
}

Material Material::with(Estimate estimate, std::string_view number) const {
  const CutterKind by = cutter.value_or(CutterKind::carbide_bur);
  (void)preset_named(name);
  if (constant_of(name, name_or_null(by), number) == nullptr)
    throw Error("material '" + name + "' has no range of '" + std::string(number) +
                "'; preset_constants() lists the numbers that have one.");
  const Material other = compose(
      name, by, [&](const PresetConstant& row) { return row.number == number ? row.at(estimate) : row.typical; });
  return with_changes_of(*this, other, compose(name, by, typical_of));
}

namespace presets {

Material enamel(CutterKind cutter, Sharpness sharpness) { return find_preset("enamel", cutter, sharpness); }

Material dentin(CutterKind cutter, Sharpness sharpness) { return find_preset("dentin", cutter, sharpness); }

Material pulp(CutterKind cutter, Sharpness sharpness) { return find_preset("pulp", cutter, sharpness); }

Material caries(CutterKind cutter, Sharpness sharpness) { return find_preset("caries", cutter, sharpness); }

Material amalgam(CutterKind cutter, Sharpness sharpness) { return find_preset("amalgam", cutter, sharpness); }

Material cortical_bone(CutterKind cutter, Sharpness sharpness) {
  return find_preset("cortical_bone", cutter, sharpness);
}

Material trabecular_bone(CutterKind cutter, Sharpness sharpness) {
  return find_preset("trabecular_bone", cutter, sharpness);
}

Material bone_d1(CutterKind cutter, Sharpness sharpness) { return find_preset("bone_d1", cutter, sharpness); }

Material bone_d2(CutterKind cutter, Sharpness sharpness) { return find_preset("bone_d2", cutter, sharpness); }

Material bone_d3(CutterKind cutter, Sharpness sharpness) { return find_preset("bone_d3", cutter, sharpness); }

Material bone_d4(CutterKind cutter, Sharpness sharpness) { return find_preset("bone_d4", cutter, sharpness); }

Material bone_d5(CutterKind cutter, Sharpness sharpness) { return find_preset("bone_d5", cutter, sharpness); }

Material clay(CutterKind cutter, Sharpness sharpness) { return find_preset("clay", cutter, sharpness); }

}  // namespace presets

std::span<const std::string_view> preset_names() { return kNames; }

Material find_preset(std::string_view name, CutterKind cutter, Sharpness sharpness) {
  const Estimate wear = sharpness == Sharpness::new_   ? Estimate::low
                        : sharpness == Sharpness::worn ? Estimate::high
                                                       : Estimate::typical;
  return compose(name, cutter, [&](const PresetConstant& row) { return row.wears ? row.at(wear) : row.typical; });
}

Color preset_color(std::string_view name) { return preset_named(name).color; }

}  // namespace hapticut
