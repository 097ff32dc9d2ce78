// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hapticut/simulation/output.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[effects]` of a settings file: forces added to the model's force, and limits of the output.
struct EffectsSettings {
  std::optional<double> mass_kg;  ///< turns gravity on
  std::optional<Vec3> center_of_mass_mm, gravity_m_per_s2;
  std::optional<double> vibration_Hz;  ///< turns the vibration on
  std::optional<double> vibration_N, vibration_N_per_W, vibration_max_N;
  bool thesis_filter = false;
  std::optional<double> filter_delta_N, filter_epsilon_N;
  std::vector<double> force_axes, torque_axes;  ///< 0 or 1 for x, y, z; empty: all on
  OutputLimits limits;
};

[[nodiscard]] std::vector<Setting> settings_of(EffectsSettings& effects);

/// @param update_rate  [Hz] of the step
/// @throws Error when a setting belongs to an effect that is off, or contradicts the rate or another setting
[[nodiscard]] Effects make_effects(const EffectsSettings& settings, double update_rate);

}  // namespace hapticut::settings
