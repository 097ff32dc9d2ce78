// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/config.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const SimulationConfig& config) {
  require_positive(config.reference_stiffness, "SimulationConfig::reference_stiffness [N/m^4]");
  if (config.friction) validate(*config.friction);
  require_between(config.handle_torque_scale, -1e6, 1e6, "SimulationConfig::handle_torque_scale [1]");
  require_positive(config.update_rate, "SimulationConfig::update_rate [Hz]");
  validate(config.effects, config.update_rate);
  if (config.voxel_budget != 0)
    require_between(double(config.voxel_budget), 4096, 1e9, "SimulationConfig::voxel_budget");
  require_positive(config.shortest_dt, "SimulationConfig::shortest_dt [s]");
  require_between(config.longest_dt, config.shortest_dt, 1.0, "SimulationConfig::longest_dt [s]");
  require_between(config.longest_sweep, 1, 100000, "SimulationConfig::longest_sweep [sub-steps]");
  require_between(double(config.reserved_blocks), 1, 1e8, "SimulationConfig::reserved_blocks");
  require_between(double(config.removed_voxel_capacity), 0, 1e9, "SimulationConfig::removed_voxel_capacity");
}

}  // namespace hapticut
