// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hapticut {

/// Names a material of a workpiece; 0 means empty, materials are 1 ... 255.
using MaterialId = std::uint8_t;
inline constexpr MaterialId kEmpty = 0;
inline constexpr int kMaxMaterials = 255;

/// What a workpiece is made of. Constants of cutting belong to this material together with this kind of tool.
struct Material {
  std::string name;                      ///< unique within a workpiece, not empty
  double relative_stiffness = 1;         ///< [1] > 0; the foundation stiffness is this times the simulation's reference
  double damping = 0;                    ///< [s/m] 0 ... 1e6 Hunt-Crossley factor chi
  double cutting_ratio = 0.5;            ///< [1] 0 ... 1e6 kappa, tangential over normal force of the spinning head
  double specific_cutting_energy = 3e8;  ///< [J/m^3] 1e-3 ... 1e18 u
  double edge_pressure = 0;              ///< [Pa] >= 0 p_e, below which nothing is cut
  double static_friction = 0.3;          ///< [1] >= dynamic_friction; of the standing spindle
  double dynamic_friction = 0.3;         ///< [1] >= 0
  double tangential_stiffness = 1000;    ///< [N/m] > 0 of the sticking anchor
  double density = 1000;                 ///< [kg/m^3] > 0
};

/// @throws Error naming the material, the field, its value and the allowed range
void validate(const Material& material);

/// The materials of a workpiece, by id.
class MaterialTable {
 public:
  MaterialTable() = default;

  /// @throws Error when a material is invalid, a name appears twice, or there are more than 255
  explicit MaterialTable(std::vector<Material> materials);

  /// Adds a material and returns its id: 1 for the first.
  /// @throws Error as above
  MaterialId add(Material material);

  [[nodiscard]] int size() const { return int(materials_.size()); }
  [[nodiscard]] bool contains(MaterialId id) const { return id >= 1 && id <= materials_.size(); }

  /// @throws Error when there is no such id
  [[nodiscard]] const Material& operator[](MaterialId id) const;

  /// @throws Error when there is no such name
  [[nodiscard]] MaterialId id_of(std::string_view name) const;

  /// In the order of their ids, from 1.
  [[nodiscard]] const std::vector<Material>& all() const { return materials_; }

 private:
  std::vector<Material> materials_;
};

}  // namespace hapticut
