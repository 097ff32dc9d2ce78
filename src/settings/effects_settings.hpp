// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hapticut/simulation/output.hpp"
#include "settings/given.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[effects]` of a settings file: forces added to the model's force, and limits of the output.
struct EffectsSettings {
  Given<Gravity> gravity;      ///< on if its mass is given
  Given<Vibration> vibration;  ///< on if its frequency is given
  Given<ToothPassing> teeth;   ///< on with the texture
  bool thesis_filter = false;
  Given<DeltaFilter> filter;
  std::vector<double> force_axes, torque_axes;  ///< 0 or 1 for x, y, z; empty: all on
  Given<OutputLimits> limits;
};

[[nodiscard]] std::vector<Setting> settings_of(EffectsSettings& effects);

/// @param update_rate  [Hz] of the step
/// @param texture  whether a hand feels the turns of the cutter
/// @throws Error when a setting belongs to an effect that is off, or contradicts the rate or another setting
[[nodiscard]] Effects make_effects(const EffectsSettings& settings, double update_rate, bool texture);

}  // namespace hapticut::settings
