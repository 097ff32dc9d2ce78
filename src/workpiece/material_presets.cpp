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
  Material (*make)(CutterKind);
  Color color;
};

constexpr std::array kPresets = {
    Preset{"enamel", presets::enamel, {240, 236, 222}},
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

/// The properties of a material that do not depend on the cutter.
/// @param stiffness  [1] relative
/// @param density    [kg/m^3]
/// @param strength   [Pa] compressive
Material solid(const char* name, double stiffness, double density, double strength) {
  return {.name = name,
          .relative_stiffness = stiffness,
          .damping = 0,
          .cutting_ratio = 0.5,
          .compressive_strength = strength,
          .static_friction = 0.3,
          .dynamic_friction = 0.3,
          .density = density};
}

/// Cutting constants of dentin and cortical bone for one kind of cutter.
struct CuttingConstants {
  double ratio, energy;             // [1] kappa, [J/m^3] u
  double edge_length, size_length;  // [m] h_e, h_s
};

constexpr CuttingConstants of_dentin(CutterKind kind) {
  switch (kind) {
    case CutterKind::fine_diamond:
      return {0.5, 63.3e9, 0, 0};
    case CutterKind::coarse_diamond:
      return {0.5, 20e9, 0, 0};
    case CutterKind::mastoid_diamond_bur:
      return {0.5, 80e9, 0, 0};
    case CutterKind::twist_drill:
      return {0.45, 65e6, 18e-6, 0};
    case CutterKind::carbide_bur:
    case CutterKind::mastoid_cutting_bur:
      break;
  }
  return {0.5, 0.1e9, 0, 180e-6};
}

/// Sets the cutting constants of a hard material from those of dentin. With u times the relative energy e, and h_s
/// divided by it, every bur feeds 1/e times as fast as in dentin under any load. Drills keep h_e, so that the force
/// below which they cut nothing is proportional to e.
/// @param relative_energy  [1] e, cutting energy over that of dentin
Material cut_by(CutterKind kind, double relative_energy, Material material) {
  const CuttingConstants cut = of_dentin(kind);
  material.cutting_ratio = cut.ratio;
  material.specific_cutting_energy = cut.energy * relative_energy;
  material.edge_length = cut.edge_length;
  material.size_length = cut.size_length / relative_energy;
  material.cutter = kind;
  return material;
}

/// Sets the cutting energy of a soft material, which does not depend on the cutter.  @param energy  [J/m^3]
Material soft(double energy, Material material) {
  material.specific_cutting_energy = energy;
  return material;
}

}  // namespace

namespace presets {

Material enamel(CutterKind cutter) { return cut_by(cutter, 1.8, solid("enamel", 1, 2950, 384e6)); }

Material dentin(CutterKind cutter) { return cut_by(cutter, 1, solid("dentin", 1, 2150, 297e6)); }

Material pulp(CutterKind) { return soft(5e6, solid("pulp", 0.01, 1000, 2.5e6)); }

Material caries(CutterKind cutter) { return cut_by(cutter, 0.44, solid("caries", 1, 1700, 130e6)); }

Material amalgam(CutterKind cutter) { return cut_by(cutter, 1.27, solid("amalgam", 1, 11600, 400e6)); }

Material cortical_bone(CutterKind cutter) { return cut_by(cutter, 1, solid("cortical_bone", 1, 1900, 150e6)); }

Material trabecular_bone(CutterKind cutter) {
  return cut_by(cutter, 1.0 / 6, solid("trabecular_bone", 0.1, 1180, 5e6));
}

Material clay(CutterKind) { return soft(1e6, solid("clay", 0.01, 1800, 0.3e6)); }

}  // namespace presets

std::span<const std::string_view> preset_names() { return kNames; }

Material find_preset(std::string_view name, CutterKind cutter) { return preset_named(name).make(cutter); }

Color preset_color(std::string_view name) { return preset_named(name).color; }

}  // namespace hapticut
