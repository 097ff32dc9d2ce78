// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material_presets.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

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
    Preset{"enamel_with_diamond", [](CutterKind) { return presets::enamel_with_diamond(); }, {200, 214, 236}},
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

/// What a material is, whatever cuts it: relative stiffness, density [kg/m^3] and
/// compressive strength [Pa].
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

/// What it takes to cut one with a kind of tool.
struct Cut {
  double ratio, energy;             // [1] kappa, [J/m^3] u
  double edge_length, size_length;  // [m] h_e, h_s
};

/// Of the hard tissues, in the order of CutterKind: carbide_bur, fine_diamond, coarse_diamond, twist_drill,
/// mastoid_cutting_bur, mastoid_diamond_bur.
using Cuts = std::array<Cut, 6>;

Material cut_by(CutterKind kind, const Cuts& cuts, Material material) {
  const Cut& cut = cuts[std::size_t(kind)];
  material.cutting_ratio = cut.ratio;
  material.specific_cutting_energy = cut.energy;
  material.edge_length = cut.edge_length;
  material.size_length = cut.size_length;
  return material;
}

/// Whatever cuts it.
Material cut_by_any(const Cut& cut, Material material) {
  return cut_by(CutterKind::carbide_bur, {cut, cut, cut, cut, cut, cut}, std::move(material));
}

constexpr double kSizeOfEnamel = 27e-6, kSizeOfBone = 180e-6, kEdgeOfDrills = 20e-6;  // [m]

/// Bone and dentin, which is cut alike, by a share of what cortical bone takes.
constexpr Cuts cuts_of_bone(double share) {
  const Cut blades = {0.5, 0.1e9 * share, 0, kSizeOfBone}, coarse = {0.5, 20e9 * share, 0, 0};
  return {blades, Cut{0.5, 63e9 * share, 0, 0}, coarse, Cut{3.3, 0.38e9 * share, kEdgeOfDrills, 0}, blades, coarse};
}

}  // namespace

namespace presets {

Material enamel(CutterKind cutter) {
  constexpr Cut kBlades = {0.5, 0.35e9, 0, kSizeOfEnamel}, kFine = {0.5, 114e9, 0, 0}, kCoarse = {0.5, 37e9, 0, 0};
  return cut_by(cutter, {kBlades, kFine, kCoarse, kBlades, kBlades, kCoarse}, solid("enamel", 1, 2950, 384e6));
}

Material enamel_with_diamond() {
  Material material = enamel(CutterKind::fine_diamond);
  material.name = "enamel_with_diamond";
  return material;
}

Material dentin(CutterKind cutter) { return cut_by(cutter, cuts_of_bone(1), solid("dentin", 1, 2150, 297e6)); }

Material pulp(CutterKind) { return cut_by_any({0.5, 5e6, 0, 0}, solid("pulp", 0.01, 1000, 2.5e6)); }

Material caries(CutterKind cutter) { return cut_by(cutter, cuts_of_bone(0.44), solid("caries", 1, 1700, 130e6)); }

Material amalgam(CutterKind) { return cut_by_any({0.5, 89e6, 0, kSizeOfEnamel}, solid("amalgam", 1, 11600, 400e6)); }

Material cortical_bone(CutterKind cutter) {
  return cut_by(cutter, cuts_of_bone(1), solid("cortical_bone", 1, 1900, 150e6));
}

Material trabecular_bone(CutterKind cutter) {
  return cut_by(cutter, cuts_of_bone(1.0 / 6), solid("trabecular_bone", 0.1, 1180, 5e6));
}

Material clay(CutterKind) { return cut_by_any({0.5, 1e6, 0, 0}, solid("clay", 0.01, 1800, 0.3e6)); }

}  // namespace presets

std::span<const std::string_view> preset_names() { return kNames; }

Material find_preset(std::string_view name, CutterKind cutter) { return preset_named(name).make(cutter); }

Color preset_color(std::string_view name) { return preset_named(name).color; }

}  // namespace hapticut
