// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/config.hpp"

#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/safety/device_limits.hpp"
#include "simulation/head_stiffness.hpp"

namespace hapticut {

void validate(const SimulationConfig& config) {
  require_fields_within(config, "SimulationConfig::");
  if (!config.law)
    throw Error("SimulationConfig::law"_name + " is null. Leave it as it is for FoundationLaw, or give a law.");
  if (config.friction) validate(*config.friction);
  validate(config.effects, config.update_rate);
  if (config.voxel_budget != 0)
    require_between(double(config.voxel_budget), 4096, 1e9, "SimulationConfig::voxel_budget");
  require_between(config.max_dt, config.min_dt, 1.0, "SimulationConfig::max_dt [s]");
}

SimulationConfig SimulationConfig::for_device(const DeviceCapabilities& device) {
  if (!(device.stiffness > 0))
    throw Error("the device '" + device.model + "' states no stiffness, so no contact can be chosen for it" +
                Sentence::clause("; set " + "DeviceCapabilities::stiffness"_name +
                                 " to that of the stiffest wall that it renders") +
                ".");
  SimulationConfig config;
  config.device_stiffness = device.stiffness;
  config.effects.limits = output_limits(device);
  return config;
}

HeadStiffness stiffness_of(const ToolHead& head, const SimulationConfig& config) {
  HeadStiffness of;
  const bool in_parts = config.quadrature == Quadrature::automatic ? config.law->integrates_parts()
                                                                   : config.quadrature == Quadrature::sub_voxel;
  of.chosen = in_parts ? stiffness_for_head(head) : kStiffnessOfPoints;
  if (config.device_stiffness > 0) of.renderable = stiffness_for_device(head, config.device_stiffness);
  return of;
}

SimulationConfig complete(SimulationConfig config, const ToolHead& head, const MaterialTable& materials) {
  if (config.quadrature == Quadrature::automatic)
    config.quadrature = config.law->integrates_parts() ? Quadrature::sub_voxel : Quadrature::centroid;
  if (config.reference_stiffness == 0) config.reference_stiffness = stiffness_of(head, config).in(materials);
  if (!config.contact_damping) {
    const bool calms = config.contact_time == ContactTime::end && config.law->is_foundation();
    config.contact_damping = calms ? kCalmingDamping : 0.0;
  }
  return config;
}

}  // namespace hapticut
