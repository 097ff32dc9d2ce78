// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// Ready-made materials. Cutting constants depend on the kind of cutter: give a preset the kind of the Tool, whose lips
/// make the chips (`lips_of`). `docs/heads-and-materials.md` has the numbers as tables, with their sources and
/// uncertainty, and compares their predictions with measurements of others.
///
/// The cutting energy of a hard material is that of dentin under the same cutter times a relative energy of the
/// material. The order of materials is therefore the same under every cutter, and burs feed 1/(relative energy) times
/// as fast as in dentin, at any load.
namespace hapticut {
namespace presets {

/// Human enamel: relative energy 1.8.
[[nodiscard]] Material enamel(CutterKind cutter = CutterKind::carbide_bur);

/// Human dentin: relative energy 1.
[[nodiscard]] Material dentin(CutterKind cutter = CutterKind::carbide_bur);

/// Dental pulp, a soft tissue: u = 5 MJ/m^3 with every cutter.
[[nodiscard]] Material pulp(CutterKind cutter = CutterKind::carbide_bur);

/// Decayed hard tissue: relative energy 0.44.
[[nodiscard]] Material caries(CutterKind cutter = CutterKind::carbide_bur);

/// Set high-copper amalgam: relative energy 1.27.
[[nodiscard]] Material amalgam(CutterKind cutter = CutterKind::carbide_bur);

/// Cortical bone: relative energy 1.
[[nodiscard]] Material cortical_bone(CutterKind cutter = CutterKind::carbide_bur);

/// Trabecular (cancellous) bone with its marrow, as a continuum: relative energy 1/6.
[[nodiscard]] Material trabecular_bone(CutterKind cutter = CutterKind::carbide_bur);

/// Modelling clay, for exercises and for comparing devices: u = 1 MJ/m^3 with every cutter.
[[nodiscard]] Material clay(CutterKind cutter = CutterKind::carbide_bur);

}  // namespace presets

/// The names that `find_preset` knows: "enamel", "dentin", "pulp", "caries", "amalgam", "cortical_bone",
/// "trabecular_bone", "clay".
[[nodiscard]] std::span<const std::string_view> preset_names();

/// A preset by its name, as written on a command line or in a settings file.
/// @param cutter  the kind of cutter that will cut the material
/// @throws Error listing the known names
[[nodiscard]] Material find_preset(std::string_view name, CutterKind cutter = CutterKind::carbide_bur);

/// A display colour for a preset, chosen freely.
/// @throws Error listing the known names
[[nodiscard]] Color preset_color(std::string_view name);

}  // namespace hapticut
