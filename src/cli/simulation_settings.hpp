// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "cli/setting.hpp"
#include "hapticut/simulation/config.hpp"

namespace hapticut::cli {

/// How it is computed, as the user writes it: `[simulation]` in a settings file.
struct SimulationSettings {
  double rate_Hz = 1000;
  std::optional<RemovalLaw> removal;
  std::optional<Quadrature> quadrature;
  SimulationConfig config;
};

[[nodiscard]] std::vector<Setting> settings_of(SimulationSettings& simulation);

[[nodiscard]] SimulationConfig make_config(const SimulationSettings& settings);

}  // namespace hapticut::cli
