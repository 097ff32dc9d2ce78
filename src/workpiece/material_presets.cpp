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
  Material (*make)();
  Color color;
};

constexpr std::array kPresets = {
    Preset{"enamel", presets::enamel, {240, 236, 222}},
    Preset{"enamel_with_diamond", presets::enamel_with_diamond, {200, 214, 236}},
    Preset{"dentin", presets::dentin, {224, 196, 138}},
    Preset{"pulp", presets::pulp, {196, 72, 72}},
    Preset{"caries", presets::caries, {92, 58, 34}},
    Preset{"amalgam", presets::amalgam, {150, 152, 158}},
    Preset{"cortical_bone", presets::cortical_bone, {232, 220, 190}},
    Preset{"trabecular_bone", presets::trabecular_bone, {214, 170, 132}},
    Preset{"clay", presets::clay, {176, 110, 82}},
};

constexpr auto kNames = [] {
  std::array<std::string_view, kPresets.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kPresets[i].name;
  return names;
}();

const Preset& preset_named(std::string_view name) {
  const auto found = std::find_if(kPresets.begin(), kPresets.end(), [&](const Preset& p) { return p.name == name; });
  if (found != kPresets.end()) return *found;
  std::string known;
  for (const std::string_view other : kNames) known += (known.empty() ? "" : ", ") + std::string(other);
  throw Error("there is no material preset '" + std::string(name) + "'; choose one of: " + known + ".");
}

}  // namespace

namespace presets {

Material enamel() {
  return {.name = "enamel",
          .relative_stiffness = 1,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 1.75e9,
          .edge_pressure = 200e3,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 1000,
          .density = 2950};
}

Material enamel_with_diamond() {
  Material material = enamel();
  material.name = "enamel_with_diamond";
  material.specific_cutting_energy = 1.14e11;
  material.edge_pressure = 0;
  return material;
}

Material dentin() {
  return {.name = "dentin",
          .relative_stiffness = 0.24,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 0.35e9,
          .edge_pressure = 40e3,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 1000,
          .density = 2150};
}

Material pulp() {
  return {.name = "pulp",
          .relative_stiffness = 0.01,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 5e6,
          .edge_pressure = 570,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 100,
          .density = 1000};
}

Material caries() {
  return {.name = "caries",
          .relative_stiffness = 0.1,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 0.155e9,
          .edge_pressure = 17.7e3,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 500,
          .density = 1700};
}

Material amalgam() {
  return {.name = "amalgam",
          .relative_stiffness = 0.6,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 0.445e9,
          .edge_pressure = 50.9e3,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 1000,
          .density = 11600};
}

Material cortical_bone() {
  return {.name = "cortical_bone",
          .relative_stiffness = 0.18,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 0.3e9,
          .edge_pressure = 34.3e3,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 1000,
          .density = 1900};
}

Material trabecular_bone() {
  return {.name = "trabecular_bone",
          .relative_stiffness = 0.02,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 50e6,
          .edge_pressure = 5.7e3,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 500,
          .density = 1180};
}

Material clay() {
  return {.name = "clay",
          .relative_stiffness = 0.01,
          .damping = 0,
          .cutting_ratio = 0.5,
          .specific_cutting_energy = 1e6,
          .edge_pressure = 114,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .tangential_stiffness = 100,
          .density = 1800};
}

}  // namespace presets

std::span<const std::string_view> preset_names() { return kNames; }

Material find_preset(std::string_view name) { return preset_named(name).make(); }

Color preset_color(std::string_view name) { return preset_named(name).color; }

}  // namespace hapticut
