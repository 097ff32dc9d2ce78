// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/preset_constants.hpp"

#include <algorithm>

#include "hapticut/workpiece/material.hpp"

namespace hapticut {
namespace {

constexpr std::string_view kWhite =
    "White 1998, Proc SPIE 3248, 10.1117/12.306013: 0.273 and 0.493 mm/s into enamel and dentin fix u sqrt(h_s) within "
    "a factor of 1.4; 0.98 N, six blades, 250000 rpm assumed";
constexpr std::string_view kGrit =
    "Fais et al. 2010, Braz J Oral Sci 9:39 (fine) and Benedettini, Melilli, Baldissara 2003, J Dent Res 82 (coarse), "
    "each with u of its own; fresh grits cut alike (Siegel and von Fraunhofer)";
constexpr std::string_view kThrusts =
    "thrust in bovine and dog bone: Hillery and Shuaib 1999; Orelaja et al. 2020, J Healthc Eng 8817422; by hand, 20 "
    "operators";
constexpr std::string_view kEdges =
    "new: dog jaw, 0 ... 1 um; used: James, Pearlman, Saigal 2013, Med Eng Phys 35:1638, 17 ... 25 um; worn: Hillery "
    "and Shuaib 1999, 38 ... 59 um";
constexpr std::string_view kDiamondHeat =
    "Farah et al. 2019, Restor Dent Endod 44:e3: +6.8 K in the pulp, dry, in 60 s; range assumed";
constexpr std::string_view kDrillHeat =
    "Augustin et al. 2008, Arch Orthop Trauma Surg 128:71: 0.8 ... 1.3 times the measured rises; range assumed";
constexpr std::string_view kBoneGrinding =
    "assumption: three times that of dental diamonds, because dry ones heat bone beyond 50 deg C 3 mm deep (Zhang, "
    "Tai, "
    "Shih 2013, Med Eng Phys 35:1391)";
constexpr std::string_view kAsDentin = "assumption: cuts like dentin, and bone varies by a factor of 2";
constexpr std::string_view kInsertion =
    "insertion torque by class, 11.2, 7.8, 3.0, 1.4 N·cm; range: half way to the next class";
constexpr std::string_view kWeaker = "assumption: between cortical bone and loose trabeculae, of 2 MPa";
constexpr std::string_view kStiffnessOfClass = "assumption: share^1.1";
constexpr std::string_view kDensityOfClass = "assumption: marrow and a share of bone";
constexpr std::string_view kTextbook = "textbook";
constexpr std::string_view kRegular =
    "regularises: the moduli give 1 ... 3 um under 2 N, the foundation 35 ... 52 um, and its stiffness follows from R";
constexpr std::string_view kGrain =
    "trabeculae are 1.02 +- 0.22 mm apart: PMC3352993; the variation is assumed to be that of their share";
constexpr std::string_view kGrainOfCortical = "assumption: osteons of 0.2 mm between denser lamellae";
constexpr std::string_view kGivesWay = "assumption: gives way before it is crushed";

/// The unit of a number of Material; "1" for shares.
constexpr std::string_view unit_of(std::string_view number) {
  std::string_view unit = "1";
  for_each_number<Material>([&](const auto& field) {
    if (number == field.name) unit = field.unit;
  });
  return unit;
}

constexpr PresetConstant row(std::string_view of, std::string_view number, double low, double typical, double high,
                             std::string_view source) {
  return {of, number, low, typical, high, unit_of(number), false, source};
}
/// A number that grows while the cutter wears.
constexpr PresetConstant worn(std::string_view of, std::string_view number, double low, double typical, double high,
                              std::string_view source) {
  PresetConstant constant = row(of, number, low, typical, high, source);
  constant.wears = true;
  return constant;
}
/// A number without a range.
constexpr PresetConstant row(std::string_view of, std::string_view number, double value, std::string_view source) {
  return row(of, number, value, value, value, source);
}

constexpr std::array kConstants = {
    // Cutters, in dentin and cortical bone
    row("carbide_bur", "cutting_ratio", 0.4, 0.5, 0.6, "assumption: as diamonds"),
    worn("carbide_bur", "specific_cutting_energy", 71e6, 100e6, 140e6, kWhite),
    row("carbide_bur", "size_length", 180e-6, kWhite),
    row("carbide_bur", "heat_share", 0.033, 0.1, 0.3, "assumption: chips carry most of the heat, as in metal"),
    row("fine_diamond", "cutting_ratio", 0.4, 0.5, 0.6, "Song and Yin: 0.40 ... 0.60 in leucite ceramic"),
    worn("fine_diamond", "specific_cutting_energy", 28e9, 40e9, 80e9, kGrit),
    row("fine_diamond", "heat_share", 0.017, 0.05, 0.15, kDiamondHeat),
    row("coarse_diamond", "cutting_ratio", 0.4, 0.5, 0.6, "as fine_diamond"),
    worn("coarse_diamond", "specific_cutting_energy", 22e9, 32e9, 64e9, kGrit),
    row("coarse_diamond", "heat_share", 0.017, 0.05, 0.15, kDiamondHeat),
    row("twist_drill", "cutting_ratio", 0.3, 0.45, 0.6,
        "torque over thrust of five sources of seven; up to 4.5 in a deep hole whose chips clog"),
    row("twist_drill", "specific_cutting_energy", 30e6, 75e6, 130e6, kThrusts),
    worn("twist_drill", "edge_length", 6e-6, 18e-6, 45e-6, kEdges),
    row("twist_drill", "heat_share", 0.33, 0.5, 1, kDrillHeat),
    row("mastoid_cutting_bur", "cutting_ratio", 0.4, 0.5, 0.6, "assumption: as carbide_bur"),
    worn("mastoid_cutting_bur", "specific_cutting_energy", 71e6, 100e6, 140e6, "assumption: as carbide_bur"),
    row("mastoid_cutting_bur", "size_length", 180e-6, "assumption: as carbide_bur"),
    row("mastoid_cutting_bur", "heat_share", 0.033, 0.1, 0.3, "assumption: as carbide_bur"),
    row("mastoid_diamond_bur", "cutting_ratio", 0.4, 0.5, 0.6, "assumption: as fine_diamond"),
    worn("mastoid_diamond_bur", "specific_cutting_energy", 28e9, 40e9, 80e9, "assumption: as fine_diamond"),
    row("mastoid_diamond_bur", "heat_share", 0.05, 0.15, 0.5, kBoneGrinding),
    // All solids
    row("solid", "relative_stiffness", 1, kRegular),
    row("solid", "damping", 0, "no measurement known"),
    row("solid", "cutting_ratio", 0.4, 0.5, 0.6, "assumption: as diamonds"),
    row("solid", "static_friction", 0.29, 0.3, 0.36,
        "bone on muscle: Shacham et al. 2010; thesis; assumed for a tool on bone and teeth"),
    row("solid", "dynamic_friction", 0.29, 0.3, 0.36,
        "bone on muscle: Shacham et al. 2010; thesis; assumed for a tool on bone and teeth"),
    // Materials
    row("enamel", "share", 1.5, 1.8, 2.2, "White 1998: the ratio of both rates, with their scatter"),
    row("enamel", "compressive_strength", 300e6, 384e6, 400e6,
        "Craig, Peyton, Johnson 1961, J Dent Res 40:936; range assumed"),
    row("enamel", "density", 2900, 2950, 3000, kTextbook),
    row("dentin", "share", 1, "the reference"),
    row("dentin", "compressive_strength", 250e6, 297e6, 350e6, "Craig, Peyton 1958, J Dent Res 37:710; range assumed"),
    row("dentin", "density", 2050, 2150, 2250, kTextbook),
    row("pulp", "specific_cutting_energy", 1.7e6, 5e6, 15e6, "assumption: tearing 1 kJ/m^2 into shreds of 0.2 mm"),
    row("pulp", "edge_pressure", 17e3, 50e3, 150e3, "assumption: a gel that yields"),
    row("pulp", "viscosity", 3.3e6, 10e6, 30e6, "assumption: a ball of 1 mm radius sinks about 40 mm/s under 1 N"),
    row("pulp", "compressive_strength", 0.8e6, 2.5e6, 7.5e6, "assumption: half of u"),
    row("pulp", "relative_stiffness", 0.01, kGivesWay),
    row("pulp", "density", 1000, 1000, 1050, kTextbook),
    row("caries", "share", 0.3, 0.44, 0.7,
        "hardness over that of dentin, 0.31 and 0.7 GPa: Shimizu et al. 2015, Dent Mater J 34:252; infected caries, "
        "which a spoon takes, is softer"),
    row("caries", "compressive_strength", 90e6, 130e6, 210e6, "assumption: share times that of dentin"),
    row("caries", "density", 1500, 1700, 2000, "assumption: dentin less a third of its mineral"),
    row("amalgam", "share", 1, 1.27, 1.5,
        "hardness over that of dentin, 0.89 and 0.7 GPa, at 29 % copper: Aminatun, Dental Journal, Universitas "
        "Airlangga; range assumed"),
    row("amalgam", "compressive_strength", 300e6, 400e6, 500e6, "assumption: set high-copper alloys"),
    row("amalgam", "density", 11000, 11600, 12000, "textbook: half mercury"),
    row("cortical_bone", "share", 0.5, 1, 2, kAsDentin),
    row("cortical_bone", "compressive_strength", 133e6, 150e6, 193e6,
        "Reilly, Burstein 1975, J Biomech 8:393: across and along the bone"),
    row("cortical_bone", "grain", 0.06, 0.12, 0.24, kGrainOfCortical),
    row("cortical_bone", "grain_length", 0.1e-3, 0.2e-3, 0.4e-3, kGrainOfCortical),
    row("cortical_bone", "density", 1800, 1900, 2000, kTextbook),
    row("trabecular_bone", "share", 0.04, 1.0 / 8, 0.33,
        "between bone_d3 and bone_d4; the trochanter of Tsai et al. 2007 alone gives 0.05; range: bone_d5 ... bone_d2"),
    row("trabecular_bone", "compressive_strength", 2e6, 5e6, 12e6, "assumption: rises with the density"),
    row("trabecular_bone", "relative_stiffness", 0.1, kGivesWay),
    row("trabecular_bone", "grain", 0.3, 0.4, 0.5, kGrain),
    row("trabecular_bone", "grain_length", 0.8e-3, 1e-3, 1.2e-3, kGrain),
    row("trabecular_bone", "density", 1050, 1180, 1350, "assumption: a fifth bone, the rest marrow"),
    row("bone_d1", "share", 0.5, 1, 2, kAsDentin),
    row("bone_d1", "compressive_strength", 133e6, 150e6, 193e6, "as cortical_bone"),
    row("bone_d1", "grain", 0.06, 0.12, 0.24, kGrainOfCortical),
    row("bone_d1", "grain_length", 0.1e-3, 0.2e-3, 0.4e-3, kGrainOfCortical),
    row("bone_d1", "density", 1800, 1900, 2000, kTextbook),
    row("bone_d2", "share", 0.29, 1.0 / 3, 0.58, kInsertion),
    row("bone_d2", "compressive_strength", 18e6, 25e6, 60e6, kWeaker),
    row("bone_d2", "relative_stiffness", 0.3, kStiffnessOfClass),
    row("bone_d2", "grain", 0.3, 0.4, 0.5, kGrain),
    row("bone_d2", "grain_length", 0.8e-3, 1e-3, 1.2e-3, kGrain),
    row("bone_d2", "density", 1200, 1300, 1500, kDensityOfClass),
    row("bone_d3", "share", 0.16, 0.25, 0.29, kInsertion),
    row("bone_d3", "compressive_strength", 8e6, 12e6, 18e6, kWeaker),
    row("bone_d3", "relative_stiffness", 0.22, kStiffnessOfClass),
    row("bone_d3", "grain", 0.3, 0.4, 0.5, kGrain),
    row("bone_d3", "grain_length", 0.8e-3, 1e-3, 1.2e-3, kGrain),
    row("bone_d3", "density", 1150, 1225, 1250, kDensityOfClass),
    row("bone_d4", "share", 0.063, 0.1, 0.16, kInsertion),
    row("bone_d4", "compressive_strength", 3e6, 5e6, 8e6, kWeaker),
    row("bone_d4", "relative_stiffness", 0.08, kStiffnessOfClass),
    row("bone_d4", "grain", 0.3, 0.4, 0.5, kGrain),
    row("bone_d4", "grain_length", 0.8e-3, 1e-3, 1.2e-3, kGrain),
    row("bone_d4", "density", 1050, 1100, 1150, kDensityOfClass),
    row("bone_d5", "share", 0.025, 0.04, 0.063, kInsertion),
    row("bone_d5", "compressive_strength", 1e6, 2e6, 3e6, kWeaker),
    row("bone_d5", "relative_stiffness", 0.03, kStiffnessOfClass),
    row("bone_d5", "grain", 0.3, 0.4, 0.5, kGrain),
    row("bone_d5", "grain_length", 0.8e-3, 1e-3, 1.2e-3, kGrain),
    row("bone_d5", "density", 1020, 1040, 1050, kDensityOfClass),
    row("clay", "specific_cutting_energy", 0.3e6, 1e6, 3e6, "assumption: hardness of stiff clay"),
    row("clay", "edge_pressure", 10e3, 30e3, 90e3, "assumption: half the yield stress of stiff clay"),
    row("clay", "viscosity", 3.3e6, 10e6, 30e6, "assumption: as pulp"),
    row("clay", "compressive_strength", 0.5e6, 1.5e6, 4.5e6, "assumption: hardness of stiff clay at a hand's speed"),
    row("clay", "relative_stiffness", 0.01, kGivesWay),
    row("clay", "density", 1600, 1800, 2000, kTextbook),
};

}  // namespace

std::span<const PresetConstant> preset_constants() { return kConstants; }

const PresetConstant* find_constant(std::string_view of, std::string_view number) noexcept {
  const auto found =
      std::ranges::find_if(kConstants, [&](const PresetConstant& one) { return one.of == of && one.number == number; });
  return found == kConstants.end() ? nullptr : &*found;
}

const PresetConstant* constant_of(std::string_view preset, std::string_view cutter, std::string_view number) noexcept {
  if (const PresetConstant* own = find_constant(preset, number)) return own;
  if (find_constant(preset, "share") != nullptr)
    if (const PresetConstant* of_cutter = find_constant(cutter, number)) return of_cutter;
  return find_constant("solid", number);
}

}  // namespace hapticut
