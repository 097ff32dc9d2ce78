// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hapticut/simulation/config.hpp"
#include "settings/effects_settings.hpp"
#include "settings/force_settings.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[simulation]`, `[force]` and `[effects]` of a settings file.
struct SimulationSettings {
  double rate_Hz = 1000;
  bool thesis_mode = false;
  std::optional<bool> texture;
  bool texture_by_default = false;  ///< true where a hand feels the force, unless the law is that of the thesis
  std::optional<RemovalLaw> removal;
  std::optional<Quadrature> quadrature;
  bool remove_loose_pieces = false;  ///< for the program that makes the steps: see Scene::remove_loose_pieces
  SimulationConfig config;
  ForceSettings force;
  EffectsSettings effects;
};

[[nodiscard]] std::vector<Setting> settings_of(SimulationSettings& simulation);

/// @throws Error when settings contradict each other
[[nodiscard]] SimulationConfig make_config(const SimulationSettings& settings);

}  // namespace hapticut::settings
