// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "hapticut/simulation/config.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[force]` of a settings file: the force law, its constants, and friction.
struct ForceSettings {
  enum class Law { foundation, thesis, contact_mechanics, hertzian_burr, damping_matrix, twist_drill };

  std::optional<Law> law;
  // Constants of individual laws.
  std::optional<double> thesis_voxel_mm, thesis_damping_Ns_per_m, thesis_spin_torque, thesis_spin_exponent,
      thesis_cutting_force_N, thesis_cutting_rpm;
  std::optional<double> effective_modulus_Pa, burr_stiffness_Pa;
  std::optional<double> resistance_Ns_per_m3, matrix_friction;
  std::optional<double> chip_energy_J_per_m3, max_feed_per_revolution_mm;
  // Terms added to the law.
  std::optional<double> static_friction, dynamic_friction, tangential_stiffness_N_per_m;
  bool deep_contact = true;
  std::optional<HandleTorque> handle_torque;
  std::optional<double> handle_torque_scale;
};

constexpr auto names_of(Of<ForceSettings::Law>) {
  using enum ForceSettings::Law;
  return std::array{Named{foundation, "foundation"},
                    Named{thesis, "thesis"},
                    Named{contact_mechanics, "contact_mechanics"},
                    Named{hertzian_burr, "hertzian_burr"},
                    Named{damping_matrix, "damping_matrix"},
                    Named{twist_drill, "twist_drill"}};
}

[[nodiscard]] std::vector<Setting> settings_of(ForceSettings& force);

/// Only the settings of the law and its constants.
[[nodiscard]] std::vector<Setting> law_settings_of(ForceSettings& force);

/// @throws Error when this law lacks a constant, or a constant of another law is set
[[nodiscard]] std::shared_ptr<const ForceLaw> make_law(const ForceSettings& settings);

/// Sets the law, friction, deep contact and the torque at the handle.
/// @throws Error when this law lacks a constant, a constant of another law is set, or a value is out of range
void apply(const ForceSettings& settings, SimulationConfig& config);

}  // namespace hapticut::settings
