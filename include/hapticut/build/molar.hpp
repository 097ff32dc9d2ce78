// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// A procedural lower (mandibular) right first molar, a workpiece that needs no file.
///
/// ```
///         view from the cheek (buccal)                view from above (occlusal)
///
///               z occlusal                                  y buccal
///               ^                                           ^
///     D   DB    |    MB   cusps                      ___DB__|_______
///     _   __    |   ____       --- crown_height     / D  .  |  MB   |
///    / \_/  \___|__/    \                          |   '.   |   .   |
///   |     enamel|        |                         |-----'--+-.'----|---> x mesial
///   |    .------|-----.  |                         |   .'   |  '.   |
///    \  |  pulp |      |/                           \ DL    |   ML  |
/// ----\-'-------+------'/----> x mesial   z = 0      \______|_______/
///      |  ___ dentin __|       cemento-enamel
///      | |   \____/  | |       line
///      | |   |    |  | |  furcation
///       \|   |    |  |/
///   distal root   mesial root  --- root length
/// ```
///
/// Frame W: the origin lies in the middle of the crown's neck, in the plane of the cemento-enamel junction; x points to
/// the mesial side (towards the front of the mouth), y to the cheek, z to the chewing surface.
///
/// Construction: each cusp is a lobe, the convex hull of a large ball in the crown's wall and a small ball at the
/// cusp's tip. Lobes, marginal ridges, root trunk and two strands per root are joined with rounded seams; then fissures
/// are pressed in. Grooves and fossae form where lobes meet, as in a growing tooth. The outer surface is antialiased.
/// Inside, each voxel has one material: enamel where the depth under the surface (without fissures) is less than the
/// local thickness, pulp in the chamber and canals, dentin elsewhere.
namespace hapticut {

/// Dimensions of the molar. The defaults are an average tooth. Sources: [L] Lee et al. 2016, J Dent Sci 11 (casts of
/// 141 teeth); [W] the usual table of tooth dimensions in textbooks of dental anatomy (Wheeler), from memory; [D]
/// Deutsch & Musikant 2004, J Endod 30:388 (100 lower molars); [H] Harris et al. 2013, J Endod 39 (22 lower first
/// molars); [A] assumption.
struct MolarParameters {
  double crown_mesiodistal = 11.1e-3;    ///< [m] largest width along x; [L] 11.13 +- 0.40 mm
  double crown_buccolingual = 10.5e-3;   ///< [m] largest width along y; [L] 10.47 +- 0.27 mm
  double crown_height = 7.5e-3;          ///< [m] junction to the tip of the highest cusp; [W] 7.5 mm
  double cervix_mesiodistal = 9e-3;      ///< [m] width of the neck along x, at most crown_mesiodistal; [W] 9 mm
  double cervix_buccolingual = 9e-3;     ///< [m] width of the neck along y, at most crown_buccolingual; [W] 9 mm
  double cervical_curvature = 1e-3;      ///< [m] rise of the junction on the mesial side; [W] 1 mm
  double mesial_root_length = 14e-3;     ///< [m] junction to apex; [W] 14 mm
  double distal_root_length = 13e-3;     ///< [m] junction to apex; [W] a little shorter than the mesial root
  double furcation_depth = 3.6e-3;       ///< [m] junction to the roof between the roots; [W] 3, [D] about 4
  double fossa_depth = 2.8e-3;           ///< [m] highest cusp to the middle of the central fossa; [A]
  double fissure_depth = 0.35e-3;        ///< [m] depth below the surface around; [A]
  double fissure_half_width = 0.4e-3;    ///< [m] half the width of a fissure; [A]
  bool distal_cusp = true;               ///< five cusps as on most lower first molars, or four
  double enamel_at_cusps = 2.2e-3;       ///< [m] tip of a cusp to the dentin horn under it; [A]
  double enamel_on_walls = 1.3e-3;       ///< [m] thickest on the sides; zero at the junction; [A]
  double enamel_in_fossa = 1.2e-3;       ///< [m] thickness under the central fossa; [A]
  double chamber_mesiodistal = 4.6e-3;   ///< [m] length of the pulp chamber along x; [H] orifices 4.4 mm apart
  double chamber_buccolingual = 3.8e-3;  ///< [m] length of the chamber along y; [H] mesial orifices 1.4 ... 3 mm apart
  double chamber_roof = 0.64e-3;         ///< [m] height above the junction; [D] 6.36 mm below a cusp of 7 mm
  double chamber_height = 1.57e-3;       ///< [m] height of the chamber; [D] 1.57 +- 0.68 mm
  double horn_height = 1.2e-3;           ///< [m] pulp horns above the roof; [A]
  double canal_radius = 0.4e-3;          ///< [m] radius at the orifices of the root canals; [A]
  double canal_radius_at_apex = 0.2e-3;  ///< [m] radius at the apex, at most canal_radius; [A]
  double apical_dentin = 1e-3;           ///< [m] dentin between the end of a canal and the apex: closed; [A]
  double caries_depth = 0;               ///< [m] depth of a lesion under the central fossa; 0: no lesion
  double caries_width = 2.5e-3;          ///< [m] diameter of the lesion along x and y
};

constexpr auto fields_of(Of<MolarParameters>) {
  using P = MolarParameters;
  using units::mm;
  return std::tuple{
      field("crown_mesiodistal", &P::crown_mesiodistal, "m", Range::between(8 * mm, 15 * mm),
            "largest width along x; [L] 11.13 +- 0.40 mm"),
      field("crown_buccolingual", &P::crown_buccolingual, "m", Range::between(8 * mm, 15 * mm),
            "largest width along y; [L] 10.47 +- 0.27 mm"),
      field("crown_height", &P::crown_height, "m", Range::between(5 * mm, 10 * mm),
            "junction to the tip of the highest cusp; [W] 7.5 mm"),
      field("cervix_mesiodistal", &P::cervix_mesiodistal, "m", Range::between(6.5 * mm, 15 * mm),
            "width of the neck along x, at most crown_mesiodistal; [W] 9 mm"),
      field("cervix_buccolingual", &P::cervix_buccolingual, "m", Range::between(6.5 * mm, 15 * mm),
            "width of the neck along y, at most crown_buccolingual; [W] 9 mm"),
      field("cervical_curvature", &P::cervical_curvature, "m", Range::between(0, 2 * mm),
            "rise of the junction on the mesial side; [W] 1 mm"),
      field("mesial_root_length", &P::mesial_root_length, "m", Range::between(8 * mm, 20 * mm),
            "junction to apex; [W] 14 mm"),
      field("distal_root_length", &P::distal_root_length, "m", Range::between(8 * mm, 20 * mm),
            "junction to apex; [W] a little shorter than the mesial root"),
      field("furcation_depth", &P::furcation_depth, "m", Range::between(2 * mm, 5 * mm),
            "junction to the roof between the roots; [W] 3, [D] about 4"),
      field("fossa_depth", &P::fossa_depth, "m", Range::between(1 * mm, 3.5 * mm),
            "highest cusp to the middle of the central fossa; [A]"),
      field("fissure_depth", &P::fissure_depth, "m", Range::between(0, 0.8 * mm),
            "depth below the surface around; [A]"),
      field("fissure_half_width", &P::fissure_half_width, "m", Range::between(0.1 * mm, 1 * mm),
            "half the width of a fissure; [A]"),
      field("distal_cusp", &P::distal_cusp, "five cusps as on most lower first molars, or four"),
      field("enamel_at_cusps", &P::enamel_at_cusps, "m", Range::between(1.2 * mm, 3 * mm),
            "tip of a cusp to the dentin horn under it; [A]"),
      field("enamel_on_walls", &P::enamel_on_walls, "m", Range::between(0.5 * mm, 2 * mm),
            "thickest on the sides; zero at the junction; [A]"),
      field("enamel_in_fossa", &P::enamel_in_fossa, "m", Range::between(0.5 * mm, 2 * mm),
            "thickness under the central fossa; [A]"),
      field("chamber_mesiodistal", &P::chamber_mesiodistal, "m", Range::between(2 * mm, 6 * mm),
            "length of the pulp chamber along x; [H] orifices 4.4 mm apart"),
      field("chamber_buccolingual", &P::chamber_buccolingual, "m", Range::between(2 * mm, 6 * mm),
            "length of the chamber along y; [H] mesial orifices 1.4 ... 3 mm apart"),
      field("chamber_roof", &P::chamber_roof, "m", Range::between(-1 * mm, 2 * mm),
            "height above the junction; [D] 6.36 mm below a cusp of 7 mm"),
      field("chamber_height", &P::chamber_height, "m", Range::between(1 * mm, 3 * mm),
            "height of the chamber; [D] 1.57 +- 0.68 mm"),
      field("horn_height", &P::horn_height, "m", Range::between(0, 2 * mm), "pulp horns above the roof; [A]"),
      field("canal_radius", &P::canal_radius, "m", Range::between(0.2 * mm, 0.6 * mm),
            "radius at the orifices of the root canals; [A]"),
      field("canal_radius_at_apex", &P::canal_radius_at_apex, "m", Range::between(0.1 * mm, 0.6 * mm),
            "radius at the apex, at most canal_radius; [A]"),
      field("apical_dentin", &P::apical_dentin, "m", Range::between(0.6 * mm, 3 * mm),
            "dentin between the end of a canal and the apex: closed; [A]"),
      field("caries_depth", &P::caries_depth, "m", Range::between(0, 5 * mm),
            "depth of a lesion under the central fossa; 0: no lesion"),
      field("caries_width", &P::caries_width, "m", Range::between(0.5 * mm, 6 * mm),
            "diameter of the lesion along x and y"),
  };
}

/// Ids of the materials of a molar; the last one exists only with `caries_depth` > 0.
inline constexpr MaterialId kMolarEnamel = 1;
inline constexpr MaterialId kMolarDentin = 2;
inline constexpr MaterialId kMolarPulp = 3;
inline constexpr MaterialId kMolarCaries = 4;

/// Checks the parameters.  @throws Error naming the field, its value and the allowed range
void validate(const MolarParameters& parameters);

/// The molar as functions of the position, for `build_body`.
/// @throws Error as `validate`
[[nodiscard]] BodyDescription describe_molar(const MolarParameters& parameters = {});

/// The molar as voxels, with the presets enamel, dentin, pulp and, with a lesion, caries. Equal parameters give equal
/// bits.
/// @throws Error as `validate`, and if the voxel size is not positive
[[nodiscard]] Workpiece build_molar(double voxel_size, const MolarParameters& parameters = {});

}  // namespace hapticut
