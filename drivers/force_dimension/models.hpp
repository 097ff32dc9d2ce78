// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace hapticut::force_dimension {

/// The properties of a kind of device, by its number in the library.
struct Model {
  std::string_view name;  ///< "omega.7", "omega.7-left"
  int type;
  double force;                      ///< [N]
  double torque;                     ///< [N·m] 0: none or unknown
  double stiffness;                  ///< [N/m]
  double rotational_stiffness;       ///< [N·m/rad]
  double damping;                    ///< [N·s/m]
  std::array<double, 3> half_width;  ///< [m] half the workspace along x, y, z of the library
};

[[nodiscard]] std::span<const Model> models();

/// The model of a type.  @return null if the type is unknown
[[nodiscard]] const Model* find_model(int type);

/// Whether a name means a model: "omega.7" means the models for both hands, "omega.7-left" and "omega.7-right" one.
[[nodiscard]] bool answers_to(const Model& model, std::string_view name);

}  // namespace hapticut::force_dimension
