// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/config.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const SimulationConfig& config) {
  require_fields_within(config, "SimulationConfig::");
  if (config.friction) validate(*config.friction);
  validate(config.effects, config.update_rate);
  if (config.voxel_budget != 0)
    require_between(double(config.voxel_budget), 4096, 1e9, "SimulationConfig::voxel_budget");
  require_between(config.longest_dt, config.shortest_dt, 1.0, "SimulationConfig::longest_dt [s]");
}

}  // namespace hapticut
