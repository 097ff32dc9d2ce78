// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/mesh.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// Ready-made materials. `docs/materials.md` holds the same numbers as a table.
///
/// **All but `enamel_with_diamond` hold for a carbide round or fissure burr of 1 ... 4 mm that takes chips (feed per
/// revolution times the sine of the contact angle) from a few micrometres to some tens of micrometres.** Specific
/// cutting energy belongs to the tool as much as to the material: bone takes 0.05 ... 0.3 GJ/m^3 with chips of about
/// 0.1 mm, while an abrasive burr with sub-micrometre chips spends about 100 GJ/m^3 on enamel: Fais et al. 2010, Braz J
/// Oral Sci 9:39, removed 0.1117 g in 12 min under 50 ... 80 g, which is 0.053 mm^3/s; at 0.64 N, kappa = 0.5 and about
/// 19 m/s at the rim (a 1.2 mm diamond burr at 300 000 rpm, assumed) the burr works at 6 W, hence
/// u = 6 W / 0.053 mm^3/s = 114 GJ/m^3, which is the preset `enamel_with_diamond`. For a tool of another kind set
/// `specific_cutting_energy`, `cutting_ratio` and `edge_pressure` again.
///
/// From one drilling test with feed speed v and negligible edge pressure: u = M omega / (pi R^2 v), kappa = 2 M / (R
/// F). Orelaja et al. 2020, J Healthc Eng 8817422 (twist drill, R = 1.25 mm, 1000 rpm): bovine 20.07 N and 41.2 N mm
/// give kappa = 3.3, porcine 11.25 N and 37.0 N mm 5.3, artificial bone 5.62 N and 13.6 N mm 3.9. The flutes of a drill
/// rub along its whole depth, so these ratios are not a burr's. Bovine torque gives u = 2 M/(R^2 a) = 0.53 GJ/m^3 for a
/// feed a = 0.1 mm per revolution (assumed: the feed is not part of the summary used here), flute friction included.
///
/// Rules shared by all presets, each an assumption unless it names a source:
/// * `specific_cutting_energy` = half the indentation hardness H. The factor puts cortical bone (H = 0.6 GPa, assumed)
///   at the upper end of the range for bone with thick chips. Plausible at the chair: a flat burr of R = 0.6 mm at
///   20 000 rad/s fed at 1 mm/s into enamel meets 2 pi R u v/(kappa omega) = 0.66 N of chip force, and dentists press
///   with 0.43 ... 1.79 N (Siegel & von Fraunhofer), at most 1.03 N in a vertical cut of enamel (Liao et al. 1995, J
///   Oral Rehabil 22:67).
/// * `cutting_ratio` = 0.5, between sliding (0.3) and a sharp edge that bites (about 1): assumption.
/// * `edge_pressure` = specific_cutting_energy / 8750, which gives enamel 0.2 MPa: 0.23 N on the end of a 1.2 mm flat
///   burr, half of the lightest load (0.43 N) in the tested range of Siegel & von Fraunhofer. Twist drills rub far more
///   (edge part equal to the chip part near 25 um per revolution); their p_e would stop such a burr below 3.8 N.
/// * `relative_stiffness` = Young's modulus over that of enamel (82 GPa: Dent Mater 2008, PMC2584618, table 1), not
///   below 0.01. It scales a regularisation, not a spring that exists; with these numbers no preset is engaged
///   more than 1.2 times as deep as enamel at the same feed.
/// * `damping` = 0: no measurement of it is known to us.
/// * `static_friction` = `dynamic_friction` = 0.3, the tooth of the thesis' case study 6.5; bone on muscle lies at 0.29
///   ... 0.36 (Shacham 2010).
/// * `tangential_stiffness` = 1000 N/m where the material feels hard, which needs 800 ... 1000 N/m (Choi & Tan 2004);
///   500 for porous or decayed tissue, 100 for soft material: assumption.
namespace hapticut {
namespace presets {

/// Human enamel. H = 3.5 GPa, E = 82 GPa (Dent Mater 2008, PMC2584618, table 1, young). Density 2950 kg/m^3: common
/// textbook value, assumption.
[[nodiscard]] Material enamel();

/// Human enamel under a diamond bur, as `enamel` but u = 1.14e11 J/m^3: the measurement of Fais et al. above (DC4),
/// with kappa = 0.5 and a bur of 1.2 mm at 300 000 rpm. One measurement cannot tell edge from chip, so edge_pressure =
/// 0 and u holds for loads about 0.6 N. The engaged layer is eight times as thick as with `enamel`: raise
/// SimulationConfig::reference_stiffness, by 65 for the same layer (`stiffness_for_accuracy`).
[[nodiscard]] Material enamel_with_diamond();

/// Human dentin. H = 0.7 GPa, E = 19.5 GPa (survey of nanoindentation, its table 8-3: 0.15 ... 2.45 and 16.3 ... 29.8).
/// By microhardness enamel is 4.2 times as hard (Chun et al. 2014, J Dent Biomech 5), here 5 times. Density 2150
/// kg/m^3: common textbook value, assumption.
[[nodiscard]] Material dentin();

/// Dental pulp, a soft tissue. E = 2.1 MPa (used throughout finite element work, e.g. Int J Environ Res Public Health
/// 2023, 20:1889, table 1), so relative_stiffness is the floor 0.01. u = 5 MJ/m^3: assumption, tearing soft tissue
/// costs about 1 kJ/m^2 and shreds it to 0.2 mm. Density 1000 kg/m^3: assumption, mostly water.
[[nodiscard]] Material pulp();

/// Decayed hard tissue. H = 0.31 GPa: Knoop 31.7 of enamel lesions of ICDAS code 3, 90 % below sound enamel (Shimizu et
/// al. 2015, Dent Mater J 34:252). relative_stiffness 0.1: assumption, dentin's modulus reduced as its hardness.
/// Density 1700 kg/m^3: assumption, dentin that lost a third of its mineral.
[[nodiscard]] Material caries();

/// Set high-copper amalgam. H = 0.89 GPa: 90.7 kgf/mm^2 with 29 % copper (Aminatun, Dental Journal, Universitas
/// Airlangga, the copper series). relative_stiffness 0.6 (E about 50 GPa) and density 11600 kg/m^3 (half mercury, half
/// silver-tin-copper alloy): assumptions.
[[nodiscard]] Material amalgam();

/// Cortical bone. u = 0.3 GJ/m^3: upper end of 0.05 ... 0.3 for chips of about 0.1 mm, a range from memory. E = 14.5
/// GPa (finite element table, Int J Environ Res Public Health 2023, 20:1889; 17 ... 20 along the bone is also quoted).
/// Density 1900 kg/m^3: middle of the usual 1800 ... 2000, assumption.
[[nodiscard]] Material cortical_bone();

/// Trabecular (cancellous) bone with its marrow, as a continuum. u = 0.05 GJ/m^3: lower end of the range above; drills
/// meet 1 ... 1.5 N in the cancellous trochanter and 24 ... 48 N in cortical tibia (both in table 6 of Orelaja et
/// al. 2020), which would allow even less. E = 1.37 GPa (same table as cortical bone), rounded to 0.02 of enamel.
/// Density 1180 kg/m^3: assumption, a fifth bone of 1900 and the rest marrow of 1000.
[[nodiscard]] Material trabecular_bone();

/// Modelling clay, for exercises and for comparing devices. Everything about it is an assumption: u = 1 MJ/m^3 is its
/// indentation hardness with the stiffest kinds, density 1800 kg/m^3.
[[nodiscard]] Material clay();

}  // namespace presets

/// The names that `find_preset` knows: "enamel", "enamel_with_diamond", "dentin", "pulp", "caries", "amalgam",
/// "cortical_bone", "trabecular_bone", "clay".
[[nodiscard]] std::span<const std::string_view> preset_names();

/// A preset by its name, as it is written on a command line or in a settings file.
/// @throws Error listing the known names
[[nodiscard]] Material find_preset(std::string_view name);

/// A colour to show a preset in. A matter of taste, without a source.
/// @throws Error listing the known names
[[nodiscard]] Color preset_color(std::string_view name);

}  // namespace hapticut
