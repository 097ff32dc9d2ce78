// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material.hpp"
#include "hapticut/workpiece/preset_constants.hpp"

/// @file
/// Ready-made materials. Cutting constants depend on the kind of cutter: give a preset the kind of the Tool, whose lips
/// make the chips (`lips_of`), and how sharp it is. `preset_constants` has each number with its range and source;
/// `docs/measurements.md` compares predictions with measurements of others.
///
/// The cutting energy of a hard material is that of dentin under the same cutter times the share of the material. The
/// order of materials is therefore the same under every cutter, and burs feed 1/share times as fast as in dentin, at
/// any load.
namespace hapticut {
namespace presets {

/// Human enamel.
[[nodiscard]] Material enamel(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Human dentin.
[[nodiscard]] Material dentin(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Dental pulp, a soft tissue, which every cutter cuts alike.
[[nodiscard]] Material pulp(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Decayed hard tissue.
[[nodiscard]] Material caries(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Set high-copper amalgam.
[[nodiscard]] Material amalgam(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Cortical bone.
[[nodiscard]] Material cortical_bone(CutterKind cutter = CutterKind::carbide_bur,
                                     Sharpness sharpness = Sharpness::used);

/// Trabecular (cancellous) bone with its marrow, as a continuum.
[[nodiscard]] Material trabecular_bone(CutterKind cutter = CutterKind::carbide_bur,
                                       Sharpness sharpness = Sharpness::used);

/// Bone of class 1: almost only compact bone.
[[nodiscard]] Material bone_d1(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Bone of class 2: a thick compact layer on dense trabeculae.
[[nodiscard]] Material bone_d2(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Bone of class 3: a thin compact layer on dense trabeculae.
[[nodiscard]] Material bone_d3(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Bone of class 4: a thin compact layer on loose trabeculae.
[[nodiscard]] Material bone_d4(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Bone of class 5: loose trabeculae.
[[nodiscard]] Material bone_d5(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

/// Modelling clay, for exercises and for comparing devices, which every cutter cuts alike.
[[nodiscard]] Material clay(CutterKind cutter = CutterKind::carbide_bur, Sharpness sharpness = Sharpness::used);

}  // namespace presets

/// The names that `find_preset` knows: "enamel", "dentin", "pulp", "caries", "amalgam", "cortical_bone",
/// "trabecular_bone", "bone_d1" ... "bone_d5", "clay".
[[nodiscard]] std::span<const std::string_view> preset_names();

/// A preset by its name, as written on a command line or in a settings file.
/// @param cutter     the kind of cutter that will cut the material
/// @param sharpness  how worn its edges are
/// @throws Error listing the known names
[[nodiscard]] Material find_preset(std::string_view name, CutterKind cutter = CutterKind::carbide_bur,
                                   Sharpness sharpness = Sharpness::used);

/// A display colour for a preset, chosen freely.
/// @throws Error listing the known names
[[nodiscard]] Color preset_color(std::string_view name);

}  // namespace hapticut
