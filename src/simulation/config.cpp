// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/config.hpp"

#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/stiffness.hpp"

namespace hapticut {

void validate(const SimulationConfig& config) {
  require_fields_within(config, "SimulationConfig::");
  if (!config.law) throw Error("SimulationConfig::law is null. Leave it as it is for FoundationLaw, or give a law.");
  if (config.friction) validate(*config.friction);
  validate(config.effects, config.update_rate);
  if (config.voxel_budget != 0)
    require_between(double(config.voxel_budget), 4096, 1e9, "SimulationConfig::voxel_budget");
  require_between(config.max_dt, config.min_dt, 1.0, "SimulationConfig::max_dt [s]");
}

SimulationConfig complete(SimulationConfig config, const ToolHead& head) {
  if (config.quadrature == Quadrature::automatic)
    config.quadrature = config.law->integrates_parts() ? Quadrature::sub_voxel : Quadrature::centroid;
  if (config.reference_stiffness == 0)
    config.reference_stiffness =
        config.quadrature == Quadrature::sub_voxel ? stiffness_for_head(head) : kStiffnessOfPoints;
  if (!config.contact_damping) config.contact_damping = config.contact_time == ContactTime::end ? kCalmingDamping : 0.0;
  return config;
}

}  // namespace hapticut
