// SPDX-License-Identifier: Apache-2.0
#include "settings/names.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "settings/scene_settings.hpp"

namespace hapticut::settings {
namespace {

constexpr std::pair<std::string_view, std::string_view> kKeys[] = {
    {"MeshImport::voxel_size", "workpiece.voxel_mm"},
    {"RawLayout::dims", "workpiece.raw_dims"},
    {"RawLayout::skip", "workpiece.raw_skip_bytes"},
    {"RawLayout::type", "workpiece.raw_type"},
    {"Shank::neck_diameter", "tool.shank_neck_mm"},
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

std::map<std::string, std::string, std::less<>> flags_of_scenes() {
  SceneSettings scene;
  std::map<std::string, std::string, std::less<>> flags;
  for (const Setting& setting : settings_of(scene))
    if (!setting.flag.empty()) flags[setting.key] = setting.flag;
  return flags;
}

const std::map<std::string, std::string, std::less<>>& flags() {
  static const auto known = flags_of_scenes();
  return known;
}

}  // namespace

std::optional<std::string_view> key_of(const Name& name) {
  const auto* const field =
      std::ranges::find(kKeys, name.text(), &std::pair<std::string_view, std::string_view>::first);
  if (field != std::end(kKeys)) return field->second;
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
