// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/tool/cutter.hpp"

namespace hapticut {

/// Number of a material of a workpiece, 1 ... 255; 0 means empty.
using MaterialId = std::uint8_t;
inline constexpr MaterialId kEmpty = 0;
inline constexpr int kMaxMaterials = 255;

/// One entry for each MaterialId, including kEmpty.
template <class T>
using ByMaterial = std::array<T, kMaxMaterials + 1>;

enum class Estimate;  // preset_constants.hpp

/// A material of a workpiece. The cutting constants are valid for this material with one kind of cutter. The list below
/// has the meaning, unit and range of each number.
struct Material {
  std::string name;                      ///< unique within a workpiece, not empty
  double relative_stiffness = 1;         ///< [1] foundation stiffness over the simulation's reference_stiffness
  double damping = 0;                    ///< [s/m] Hunt-Crossley factor chi
  double cutting_ratio = 0.5;            ///< [1] kappa, tangential over normal force of the spinning head
  double specific_cutting_energy = 3e8;  ///< [J/m^3] u, energy to cut away
  double edge_pressure = 0;              ///< [Pa] p_e: below this pressure nothing is cut
  double edge_length = 0;                ///< [m] h_e: ploughing of a lip costs u h_e per length and removes nothing
  double size_length = 0;                ///< [m] h_s: chips of thickness h cost u sqrt(h_s/h) more energy
  double viscosity = 0;                  ///< [Pa s/m] eta: cutting at a speed v takes the pressure eta v more
  double grain = 0;                      ///< [1] variation of the cutting energy from place to place, over its mean
  double grain_length = 0;               ///< [m] size of the places within which the cutting energy is even
  /// [Pa] sigma: pressure that crushes the material under any head; 0: it is never crushed
  double compressive_strength = 0;
  double static_friction = 0.3;   ///< [1] dry friction with the spindle at rest, not below dynamic_friction
  double dynamic_friction = 0.3;  ///< [1] dry friction with the spindle at rest, while it slips
  /// [N/m] stiffness of the sticking anchor; 0: that of the contact along its normals
  double tangential_stiffness = 0;
  double density = 1000;  ///< [kg/m^3] mass over volume

  /// Kind of cutter that the cutting constants are for; none: not known, and not checked.
  /// Presets set it, workpieces and recordings keep it, and a scene sets it from its tool; see
  /// StepStatus::other_cutter.
  std::optional<CutterKind> cutter = {};

  /// This preset with the constants that resist a cut at one place of their ranges: u, share, edge_pressure,
  /// edge_length, size_length and viscosity, of `preset_constants`. With Estimate::low the force is the least that
  /// published measurements allow. A number is changed only if its range says so; others stay as they are.
  /// @throws Error when the name is not that of a preset
  [[nodiscard]] Material with(Estimate estimate) const;

  /// This preset with one number at one place of its range.
  /// @param number  a number of Material, or "share"
  /// @throws Error when the name is not that of a preset, or the table has no such number of it
  [[nodiscard]] Material with(Estimate estimate, std::string_view number) const;
};

namespace detail {
/// [Pa] or [J/m^3], which are equal units: a hundredth of an atmosphere. Smaller values were meant in another unit.
inline constexpr double kMinPressure = 1e3;
}  // namespace detail

/// To add a number to materials, see "A material constant" in CONTRIBUTING.md. A file that is older than the number
/// gives it its default.
///
/// The contact is computed in single precision. The upper limits are far beyond any real material, and all results at
/// the limits are still finite.
constexpr auto fields_of(Of<Material>) {
  using M = Material;
  return std::tuple{
      field("name", &M::name, "unique within a workpiece, not empty"),
      field("relative_stiffness", &M::relative_stiffness, "1", Range::positive(),
            "foundation stiffness over the simulation's reference_stiffness"),
      field("damping", &M::damping, "s/m", Range::between(0, 1e6), "Hunt-Crossley factor chi"),
      field("cutting_ratio", &M::cutting_ratio, "1", Range::between(0, 1e6),
            "kappa, tangential over normal force of the spinning head"),
      field("specific_cutting_energy", &M::specific_cutting_energy, "J/m^3", Range::between(detail::kMinPressure, 1e18),
            "u, energy to cut away"),
      field("edge_pressure", &M::edge_pressure, "Pa", Range::not_negative(), "p_e: below this pressure nothing is cut"),
      field("edge_length", &M::edge_length, "m", Range::between(0, 0.01),
            "h_e: ploughing of a lip costs u h_e per length and removes nothing"),
      field("size_length", &M::size_length, "m", Range::between(0, 0.01),
            "h_s: chips of thickness h cost u sqrt(h_s/h) more energy"),
      field("viscosity", &M::viscosity, "Pa s/m", Range::between(0, 1e12),
            "eta: cutting at a speed v takes the pressure eta v more"),
      field("grain", &M::grain, "1", Range::between(0, 1),
            "variation of the cutting energy from place to place, over its mean"),
      field("grain_length", &M::grain_length, "m", Range::between(0, 0.1),
            "size of the places within which the cutting energy is even"),
      field("compressive_strength", &M::compressive_strength, "Pa", Range::not_negative(),
            "sigma: pressure that crushes the material under any head; 0: it is never crushed"),
      field("static_friction", &M::static_friction, "1", Range::not_negative(),
            "dry friction with the spindle at rest, not below dynamic_friction"),
      field("dynamic_friction", &M::dynamic_friction, "1", Range::not_negative(),
            "dry friction with the spindle at rest, while it slips"),
      field("tangential_stiffness", &M::tangential_stiffness, "N/m", Range::not_negative(),
            "stiffness of the sticking anchor; 0: that of the contact along its normals"),
      field("density", &M::density, "kg/m^3", Range::positive(), "mass over volume"),
      field("cutter", &M::cutter,
            "kind of cutter that the cutting constants are for; none: not known, and not checked"),
  };
}

/// @throws Error naming the material, the field, its value and the allowed range
inline void validate(const Material& material) {
  if (material.name.empty()) throw Error("Material::name"_name + " is empty; give every material a name.");
  const std::string prefix = "material '" + material.name + "': ";
  for (const auto& [name, pressure] : {std::pair("compressive_strength", material.compressive_strength),
                                       std::pair("edge_pressure", material.edge_pressure)})
    if (pressure > 0 && pressure < detail::kMinPressure)
      throw Error(prefix + name + " = " + format_number(pressure, detail::kMinPressure) + "; must be 0 or at least " +
                  format_number(detail::kMinPressure) + ". The unit is Pa: 150 MPa are 150e6.");
  const double u = material.specific_cutting_energy;
  if (u > 0 && u < detail::kMinPressure)
    throw Error(prefix + "specific_cutting_energy = " + format_number(u, detail::kMinPressure) + "; must be at least " +
                format_number(detail::kMinPressure) + ". The unit is J/m^3: 0.3 J/mm^3, or 300 MPa, are 3e8.");
  require_fields_within(material, prefix);
  if (material.dynamic_friction > material.static_friction)
    throw Error(
        prefix + "dynamic_friction = " + format_number(material.dynamic_friction, material.static_friction) +
        "; must not exceed static_friction = " + format_number(material.static_friction, material.dynamic_friction) +
        ". Lower it, or raise static_friction.");
}

/// The materials of a workpiece, by id.
class MaterialTable {
 public:
  MaterialTable() = default;

  /// @throws Error when a material is invalid, a name appears twice, or there are more than 255
  explicit MaterialTable(std::vector<Material> materials) {
    for (Material& material : materials) add(std::move(material));
  }

  /// Adds a material and returns its id: 1 for the first.
  /// @throws Error when the material is invalid, its name is in the table already, or the table has 255 materials
  MaterialId add(Material material) {
    validate(material);
    if (materials_.size() >= std::size_t(kMaxMaterials))
      throw Error("a workpiece can have at most 255 materials; material '" + material.name + "' exceeds that.");
    for (const Material& other : materials_)
      if (other.name == material.name)
        throw Error("material '" + material.name + "' is already in the table; names must be unique.");
    materials_.push_back(std::move(material));
    return MaterialId(materials_.size());
  }

  [[nodiscard]] int size() const { return int(materials_.size()); }
  [[nodiscard]] bool contains(MaterialId id) const noexcept { return id >= 1 && id <= materials_.size(); }

  /// The material of an id; null when there is no such id.
  [[nodiscard]] const Material* find(MaterialId id) const noexcept {
    return contains(id) ? &materials_[id - 1U] : nullptr;
  }

  /// The material of an id.  @throws Error when there is no such id
  [[nodiscard]] const Material& operator[](MaterialId id) const {
    if (!contains(id))
      throw Error("there is no material " + std::to_string(int(id)) + "; the table has materials 1 to " +
                  std::to_string(materials_.size()) + ".");
    return materials_[id - 1U];
  }

  /// The id of a name.  @throws Error when there is no such name
  [[nodiscard]] MaterialId id_of(std::string_view name) const {
    std::string known;
    for (std::size_t i = 0; i < materials_.size(); ++i) {
      if (materials_[i].name == name) return MaterialId(i + 1);
      known += (known.empty() ? "" : ", ") + materials_[i].name;
    }
    throw Error("there is no material '" + std::string(name) + "'; the table has: " + known + ".");
  }

  /// All materials in the order of their ids, from 1.
  [[nodiscard]] const std::vector<Material>& all() const { return materials_; }

 private:
  std::vector<Material> materials_;
};

}  // namespace hapticut
