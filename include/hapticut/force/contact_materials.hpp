// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// [N/m^4] Range of stiffness in single precision: far beyond any material, and its squares are still finite.
inline constexpr double kSoftestContact = 1, kStiffestContact = 1e25;

/// [Pa] Pressure of a fast cut at its rim. The corner of a cutting edge leaves the wall proud of the smooth side by
/// about the depth of that layer, sqrt(2 p/k_v). Three such layers are cut away behind the corner: with 1.5 layers the
/// torque of a drill in its hole is 20 % too high, with three it is right within 1 %.
inline constexpr double kPressureOfLand = 1e6;
inline constexpr double kLayersOfLand = 3;

/// [1] Relative stiffness of the stiffest material.
[[nodiscard]] inline double max_relative_stiffness(const MaterialTable& table) {
  double maximum = 0;
  for (int id = 1; id <= table.size(); ++id)
    maximum = std::max(maximum, table.find(MaterialId(id))->relative_stiffness);
  return maximum;
}

/// @param reference_stiffness  [N/m^4] of a material of relative stiffness 1
/// @throws Error when k_v of a material is not between kSoftestContact and kStiffestContact
inline void require_contact_stiffness(const MaterialTable& table, double reference_stiffness) {
  for (int id = 1; id <= table.size(); ++id) {
    const Material& m = table[MaterialId(id)];
    require_between(
        m.relative_stiffness * reference_stiffness, kSoftestContact, kStiffestContact,
        {"SimulationConfig::reference_stiffness"_name, " times relative_stiffness of '" + m.name + "' [N/m^4]"});
  }
}

/// The materials of a workpiece as the force laws read them: `k_v = relative_stiffness * reference_stiffness`, `w0 =
/// sqrt(2 p_e / k_v)`, crushing depth `sqrt(2 sigma / k_v)`.
/// @param reference_stiffness  [N/m^4] of a material of relative stiffness 1; see require_contact_stiffness
/// @param contact_damping      [s/m] on top of each material's own
[[nodiscard]] inline ContactMaterials contact_materials(const MaterialTable& table, double reference_stiffness,
                                                        double contact_damping = 0) noexcept {
  ContactMaterials constants = {};
  constants[kEmpty].cutting_energy = 1;  // empty lanes are computed like others and must not divide by zero
  for (int id = 1; id <= table.size(); ++id) {
    const Material& m = *table.find(MaterialId(id));
    const double stiffness = m.relative_stiffness * reference_stiffness;
    constants[std::size_t(id)] = {.stiffness = float(stiffness),
                                  .damping = float(m.damping + contact_damping),
                                  .cutting_ratio = float(m.cutting_ratio),
                                  .cutting_energy = float(m.specific_cutting_energy),
                                  .cutting_depth = float(std::sqrt(2 * m.edge_pressure / stiffness)),
                                  .edge_length = float(m.edge_length),
                                  .size_length = float(m.size_length),
                                  .viscosity = float(m.viscosity),
                                  .crushing_depth = m.compressive_strength > 0
                                                        ? float(std::sqrt(2 * m.compressive_strength / stiffness))
                                                        : ContactMaterial::kNeverCrushed,
                                  .sliding_ratio = float(m.dynamic_friction),
                                  .land = float(kLayersOfLand * std::sqrt(2 * kPressureOfLand / stiffness)),
                                  .grain = float(m.grain),
                                  .grain_length = float(m.grain_length)};
  }
  return constants;
}

}  // namespace hapticut
