// SPDX-License-Identifier: Apache-2.0
#include "settings/names.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "settings/scene_settings.hpp"

namespace hapticut::settings {
namespace {

/// The numbers of heads follow from the shapes.
constexpr std::pair<std::string_view, std::string_view> kKeys[] = {
    {"HeatConfig::voxels_per_cell", "heat.voxels_per_cell"},
    {"MeshImport::voxel_size", "workpiece.voxel_mm"},
    {"RawLayout::dims", "workpiece.raw_dims"},
    {"RawLayout::skip", "workpiece.raw_skip_bytes"},
    {"RawLayout::type", "workpiece.raw_type"},
    {"Shank::neck_diameter", "tool.shank_neck_mm"},
    {"SimulationConfig::grain", "simulation.texture"},
    {"SimulationConfig::law", "force.law"},
    {"SimulationConfig::quadrature", "simulation.quadrature"},
    {"SimulationConfig::reference_stiffness", "simulation.reference_stiffness_N_per_m4"},
    {"SimulationConfig::update_rate", "simulation.rate_Hz"},
    {"SimulationConfig::voxel_budget", "simulation.voxel_budget"},
    {"VdbImport::grid", "workpiece.grid"},
    {"VdbImport::kind", "workpiece.grid_kind"},
    {"VdbImport::material", "workpiece.material"},
    {"VolumeBuildOptions::crop", "workpiece.crop_mm"},
    {"VolumeBuildOptions::voxel_size", "workpiece.voxel_mm"},
    {"VolumeReadOptions::dicom_series", "workpiece.dicom_series"},
    {"VolumeReadOptions::spacing", "workpiece.spacing_mm"},
    {"large", "workpiece.large"},
    {"unit_mm", "workpiece.unit_mm"},
};

using Words = std::map<std::string, std::string, std::less<>>;

/// The keys of the numbers of each shape of head: "tool.height_mm" for `ConeHead::height`.
const Words& keys_of_shapes() {
  static const Words keys = [] {
    Words of_fields;
    for_each_shape([&]<class Shape>(Of<Shape>) {
      if constexpr (Described<Shape>)
        for_each_number<Shape>([&](const auto& field) {
          of_fields[std::string(Shape::kName) + "::" + field.name] = key_of_dimension(field.name, field.unit);
        });
    });
    return of_fields;
  }();
  return keys;
}

Words flags_of_scenes() {
  SceneSettings scene;
  Words flags;
  for (const Setting& setting : settings_of(scene))
    if (!setting.flag.empty()) flags[setting.key] = setting.flag;
  return flags;
}

const Words& flags() {
  static const auto known = flags_of_scenes();
  return known;
}

}  // namespace

std::optional<std::string_view> key_of(const Name& name) {
  const auto* const field =
      std::ranges::find(kKeys, name.text(), &std::pair<std::string_view, std::string_view>::first);
  if (field != std::end(kKeys)) return field->second;
  if (const auto shape = keys_of_shapes().find(name.text()); shape != keys_of_shapes().end()) return shape->second;
  const auto setting = flags().find(name.text());
  if (setting == flags().end()) return std::nullopt;
  return setting->first;
}

std::optional<std::string> flag_of(std::string_view key) {
  const auto setting = flags().find(key);
  if (setting == flags().end()) return std::nullopt;
  return setting->second;
}

}  // namespace hapticut::settings
