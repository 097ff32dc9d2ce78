// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// Ready-made materials, each as a kind of cutter meets it. `docs/materials.md` holds the same numbers as tables, what
/// they rest on, how far they can be trusted, and what they predict beside what others measured.
///
/// Energy belongs to the pair of tool and material, and to the chip: blades take the size effect sqrt(h_s/h), which
/// reaches from a drill's chips of tens of micrometres to the ten nanometres of a dental bur (force/chip.hpp); grains
/// of diamond a constant u at the one load that was measured; twist drills an edge force, h_e.
///
/// Rules shared by all presets, each an assumption unless it names a source:
/// * `specific_cutting_energy` and `size_length` of enamel and dentin under carbide: White 1998, Proc SPIE 3248
///   (10.1117/12.306013), 0.273 and 0.493 mm/s along the axis at high speed, for the 0.98 N that dentists usually press
///   with (Siegel & von Fraunhofer), a bur of 0.84 mm with six blades at 250000 rpm under load and kappa = 0.5. One
///   rate fixes u sqrt(h_s) only: u is that of drills' chips.
/// * Diamond: Fais et al. 2010, Braz J Oral Sci 9:39 (fine, enamel), 0.053 mm^3/s at 0.64 N; Benedettini et al. 2003, J
///   Dent Res 82 (coarse, tooth in resin), 0.54 mm^3/s at 1 N, whose unit is misprinted. Enamel takes 1.8 times what
///   dentin does, as with White. The two differ tenfold, which is carried as fine and coarse.
/// * Twist drills in cortical bone: kappa = 3.3 and u (1 + h_e/h) = 0.53 GJ/m^3 at 50 um per lip from Orelaja et al.
///   2020, J Healthc Eng 8817422 (feed assumed; kappa 0.4 ... 5 by others); h_e = 20 um from James et al. 2012 and 2013
///   (one tooth of a saw, 2 ... 10 um).
/// * Bone under burs is taken to be cut as dentin is; trabecular bone takes a sixth, caries 0.44 of it, as their
/// hardness.
/// * `edge_pressure` = 0 and `damping` = 0: no measurement of them is known to us.
/// * `relative_stiffness` = 1 of all that is hard: it scales a regularisation, not a spring that exists. By their
/// moduli
///   a ball of 1 mm under 2 N goes 1 ... 3 um into enamel, dentin or cortical bone (Hertz), and 60 um into the
///   foundation that the grid allows. Trabecular bone 0.1, pulp and clay 0.01: assumptions.
/// * `static_friction` = `dynamic_friction` = 0.3, the tooth of the thesis' case study 6.5; bone on muscle lies at 0.29
///   ... 0.36 (Shacham 2010).
/// * `compressive_strength`: enamel 384 and dentin 297 MPa (Craig, Peyton & Johnson 1961, J Dent Res 40:936; Craig &
///   Peyton 1958, 37:710), cortical bone 150 MPa, between 133 across and 193 along the bone (Reilly & Burstein 1975, J
///   Biomech 8:393), trabecular bone 5 MPa, which spreads from 2 to 12 with its density. Caries 0.44 of dentin, amalgam
///   400 MPa, pulp half of what it takes to cut it, clay a third of its hardness: assumptions.
/// * `tangential_stiffness` = 0: a contact sticks as stiffly as it presses.
namespace hapticut {
namespace presets {

/// Human enamel. E = 82 GPa (Dent Mater 2008, PMC2584618, table 1, young). Density 2950 kg/m^3: common textbook value,
/// assumption.
[[nodiscard]] Material enamel(CutterKind cutter = CutterKind::carbide_bur);

/// Human enamel under a fine diamond bur, by this name whatever the cutter: u = 1.14e11 J/m^3 of Fais et al. above
/// (DC4), with kappa = 0.5 and a bur of 1.2 mm at 300 000 rpm.
[[nodiscard]] Material enamel_with_diamond();

/// Human dentin. E = 19.5 GPa (survey of nanoindentation, its table 8-3: 16.3 ... 29.8). Density 2150 kg/m^3: common
/// textbook value, assumption.
[[nodiscard]] Material dentin(CutterKind cutter = CutterKind::carbide_bur);

/// Dental pulp, a soft tissue, the same for each cutter. E = 2.1 MPa (used throughout finite element work, e.g. Int J
/// Environ Res Public Health 2023, 20:1889, table 1). u = 5 MJ/m^3: assumption, tearing soft tissue costs about 1
/// kJ/m^2 and shreds it to 0.2 mm. Density 1000 kg/m^3: assumption, mostly water.
[[nodiscard]] Material pulp(CutterKind cutter = CutterKind::carbide_bur);

/// Decayed hard tissue, 0.44 of dentin: Knoop 31.7 of enamel lesions of ICDAS code 3 is a hardness of 0.31 GPa (Shimizu
/// et al. 2015, Dent Mater J 34:252), dentin's is 0.7. Density 1700 kg/m^3: assumption, dentin that lost a third of its
/// mineral.
[[nodiscard]] Material caries(CutterKind cutter = CutterKind::carbide_bur);

/// Set high-copper amalgam, the same for each cutter: enamel under carbide by the ratio of their hardness, 0.89 GPa
/// (90.7 kgf/mm^2 with 29 % copper: Aminatun, Dental Journal, Universitas Airlangga) to 3.5. Density 11600
/// kg/m^3 (half mercury, half silver-tin-copper alloy): assumption.
[[nodiscard]] Material amalgam(CutterKind cutter = CutterKind::carbide_bur);

/// Cortical bone. E = 14.5 GPa (finite element table, Int J Environ Res Public Health 2023, 20:1889; 17 ... 20 along
/// the bone is also quoted). Density 1900 kg/m^3: middle of the usual 1800 ... 2000, assumption.
[[nodiscard]] Material cortical_bone(CutterKind cutter = CutterKind::carbide_bur);

/// Trabecular (cancellous) bone with its marrow, as a continuum. A sixth of cortical bone: drills meet 1 ... 1.5 N in
/// the cancellous trochanter and 24 ... 48 N in cortical tibia (both in table 6 of Orelaja et al. 2020), which would
/// allow even less. E = 1.37 GPa (same table as cortical bone). Density 1180 kg/m^3:
/// assumption, a fifth bone of 1900 and the rest marrow of 1000.
[[nodiscard]] Material trabecular_bone(CutterKind cutter = CutterKind::carbide_bur);

/// Modelling clay, for exercises and for comparing devices, the same for each cutter. Everything about it is an
/// assumption: u = 1 MJ/m^3 is its indentation hardness with the stiffest kinds, density 1800 kg/m^3.
[[nodiscard]] Material clay(CutterKind cutter = CutterKind::carbide_bur);

}  // namespace presets

/// The names that `find_preset` knows: "enamel", "enamel_with_diamond", "dentin", "pulp", "caries", "amalgam",
/// "cortical_bone", "trabecular_bone", "clay".
[[nodiscard]] std::span<const std::string_view> preset_names();

/// A preset by its name, as it is written on a command line or in a settings file.
/// @param cutter  that it is to be cut with
/// @throws Error listing the known names
[[nodiscard]] Material find_preset(std::string_view name, CutterKind cutter = CutterKind::carbide_bur);

/// A colour to show a preset in. A matter of taste, without a source.
/// @throws Error listing the known names
[[nodiscard]] Color preset_color(std::string_view name);

}  // namespace hapticut
