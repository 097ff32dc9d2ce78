// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material.hpp"

#include <cmath>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const Material& material) {
  if (material.name.empty()) throw Error("Material::name is empty; give every material a name.");
  const auto field = [&](const char* name) { return "material '" + material.name + "': " + name; };
  require_positive(material.relative_stiffness, field("relative_stiffness [1]").c_str());
  require_not_negative(material.damping, field("damping [s/m]").c_str());
  require_not_negative(material.cutting_ratio, field("cutting_ratio [1]").c_str());
  require_positive(material.specific_cutting_energy, field("specific_cutting_energy [J/m^3]").c_str());
  require_not_negative(material.edge_pressure, field("edge_pressure [Pa]").c_str());
  require_not_negative(material.static_friction, field("static_friction [1]").c_str());
  require_not_negative(material.dynamic_friction, field("dynamic_friction [1]").c_str());
  require_positive(material.tangential_stiffness, field("tangential_stiffness [N/m]").c_str());
  require_positive(material.density, field("density [kg/m^3]").c_str());
  // The contact is computed in single precision: far beyond any material, and what follows from them is still finite.
  require_between(material.damping, 0, 1e6, field("damping [s/m]").c_str());
  require_between(material.cutting_ratio, 0, 1e6, field("cutting_ratio [1]").c_str());
  require_between(material.specific_cutting_energy, 1e-3, 1e18, field("specific_cutting_energy [J/m^3]").c_str());
  if (material.dynamic_friction > material.static_friction)
    throw Error(field("dynamic_friction") + " = " + format_number(material.dynamic_friction) +
                "; must not exceed static_friction = " + format_number(material.static_friction) +
                ". Lower it, or raise static_friction.");
}

MaterialTable::MaterialTable(std::vector<Material> materials) {
  for (Material& material : materials) add(std::move(material));
}

MaterialId MaterialTable::add(Material material) {
  validate(material);
  if (materials_.size() >= std::size_t(kMaxMaterials))
    throw Error("a workpiece can have at most 255 materials; material '" + material.name + "' would be one more.");
  for (const Material& other : materials_)
    if (other.name == material.name)
      throw Error("material '" + material.name + "' is already in the table; names must be unique.");
  materials_.push_back(std::move(material));
  return MaterialId(materials_.size());
}

const Material& MaterialTable::operator[](MaterialId id) const {
  if (!contains(id))
    throw Error("there is no material " + std::to_string(int(id)) + "; the table has materials 1 to " +
                std::to_string(materials_.size()) + ".");
  return materials_[id - 1U];
}

MaterialId MaterialTable::id_of(std::string_view name) const {
  std::string known;
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    if (materials_[i].name == name) return MaterialId(i + 1);
    known += (known.empty() ? "" : ", ") + materials_[i].name;
  }
  throw Error("there is no material '" + std::string(name) + "'; the table has: " + known + ".");
}

}  // namespace hapticut
