// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// Ready-made materials, each as a kind of cutter meets it: the kind that the Tool is given too, whose lips make the
/// chips (`lips_of`). `docs/heads-and-materials.md` holds the same numbers as tables, where each comes from, how far it
/// can be trusted, and what it predicts beside what others measured.
///
/// Of what is hard, energy is that of dentin under the cutter times a share of the material: so the order of materials
/// is the same under every cutter, and under burs each goes 1/share times as fast as dentin, whatever the load.
namespace hapticut {
namespace presets {

/// Human enamel: 1.8 times dentin.
[[nodiscard]] Material enamel(CutterKind cutter = CutterKind::carbide_bur);

/// Human dentin: 1.
[[nodiscard]] Material dentin(CutterKind cutter = CutterKind::carbide_bur);

/// Dental pulp, a soft tissue, the same for each cutter: u = 5 MJ/m^3.
[[nodiscard]] Material pulp(CutterKind cutter = CutterKind::carbide_bur);

/// Decayed hard tissue: 0.44 of dentin.
[[nodiscard]] Material caries(CutterKind cutter = CutterKind::carbide_bur);

/// Set high-copper amalgam: 1.27 times dentin.
[[nodiscard]] Material amalgam(CutterKind cutter = CutterKind::carbide_bur);

/// Cortical bone: as dentin.
[[nodiscard]] Material cortical_bone(CutterKind cutter = CutterKind::carbide_bur);

/// Trabecular (cancellous) bone with its marrow, as a continuum: a sixth of cortical bone.
[[nodiscard]] Material trabecular_bone(CutterKind cutter = CutterKind::carbide_bur);

/// Modelling clay, for exercises and for comparing devices, the same for each cutter: u = 1 MJ/m^3.
[[nodiscard]] Material clay(CutterKind cutter = CutterKind::carbide_bur);

}  // namespace presets

/// The names that `find_preset` knows: "enamel", "dentin", "pulp", "caries", "amalgam", "cortical_bone",
/// "trabecular_bone", "clay".
[[nodiscard]] std::span<const std::string_view> preset_names();

/// A preset by its name, as it is written on a command line or in a settings file.
/// @param cutter  that it is to be cut with
/// @throws Error listing the known names
[[nodiscard]] Material find_preset(std::string_view name, CutterKind cutter = CutterKind::carbide_bur);

/// A colour to show a preset in. A matter of taste, without a source.
/// @throws Error listing the known names
[[nodiscard]] Color preset_color(std::string_view name);

}  // namespace hapticut
