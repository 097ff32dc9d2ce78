// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material.hpp"

#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const Material& material) {
  if (material.name.empty()) throw Error("Material::name is empty; give every material a name.");
  const std::string prefix = "material '" + material.name + "': ";
  require_fields_within(material, prefix);
  if (material.dynamic_friction > material.static_friction)
    throw Error(prefix + "dynamic_friction = " + format_number(material.dynamic_friction) +
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
