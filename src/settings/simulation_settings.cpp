// SPDX-License-Identifier: Apache-2.0
#include "settings/simulation_settings.hpp"

#include "hapticut/simulation/thesis_mode.hpp"

namespace hapticut::settings {
namespace {

/// The model of the thesis, where nothing else was set.
void fill_in_thesis_mode(SimulationSettings& s) {
  ThesisMode mode;
  mode.update_rate = s.rate_Hz;
  const SimulationConfig thesis = thesis_mode(mode);
  ForceSettings& force = s.force;
  if (!force.law) force.law = ForceSettings::Law::thesis;
  if (!force.static_friction && !force.dynamic_friction) {
    force.static_friction = thesis.friction->static_friction;
    force.dynamic_friction = thesis.friction->dynamic_friction;
  }
  if (!force.handle_torque) force.handle_torque = thesis.handle_torque;
  if (!s.quadrature) s.quadrature = thesis.quadrature;
  s.effects.thesis_filter = true;
  if (const auto& vibration = thesis.effects.vibration; vibration && !s.effects.vibration_Hz) {
    s.effects.vibration_Hz = vibration->frequency;
    if (!s.effects.vibration_N) s.effects.vibration_N = vibration->amplitude;
  }
}

}  // namespace

std::vector<Setting> settings_of(SimulationSettings& s) {
  const SimulationConfig limits;
  std::vector<Setting> all = {
      number("simulation.rate_Hz", "--rate", s.rate_Hz, Range::between(1 / limits.max_dt, 1 / limits.min_dt),
             "steps per second [1000]"),
      boolean("simulation.thesis_mode", "--thesis_mode", s.thesis_mode,
              "the whole model of the thesis: its law, friction, handle torque and filter, and from 1112 Hz on its "
              "vibration; what is set on its own counts [false]"),
      number("simulation.reference_stiffness_N_per_m4", "--reference_stiffness", s.config.reference_stiffness,
             range_of(&SimulationConfig::reference_stiffness),
             "foundation stiffness, N/m^4, of a material of relative stiffness 1; 0: what suits the head's radius [0]"),
      number("simulation.contact_damping_s_per_m", "--contact_damping", s.config.contact_damping,
             range_of(&SimulationConfig::contact_damping),
             "damping of the contact, s/m, on top of each material's own [300 behind a coupling, 0 without]"),
      choice("simulation.removal", "--removal", s.removal, "how material is taken away [constant_energy]"),
      choice("simulation.quadrature", "--quadrature", s.quadrature,
             "where in a partly filled voxel its force is taken [automatic: sub_voxel, or centroid under a law of "
             "points]"),
      integer("simulation.reserved_blocks", "--reserved_blocks", s.config.reserved_blocks, 1, 1e6,
              "blocks kept ready for cutting; they are refilled between steps [2048]"),
      integer("simulation.voxel_budget", "--voxel_budget", s.config.voxel_budget, 0, 1e9,
              "most voxels that a step evaluates, at least 4096, the others take turns; 0: all [0]"),
  };
  return together({std::move(all), settings_of(s.force), settings_of(s.effects)});
}

SimulationConfig make_config(const SimulationSettings& given) {
  SimulationSettings settings = given;
  if (settings.thesis_mode) fill_in_thesis_mode(settings);
  SimulationConfig config = settings.config;
  config.removal = settings.removal.value_or(config.removal);
  config.quadrature = settings.quadrature.value_or(config.quadrature);
  config.update_rate = settings.rate_Hz;
  apply(settings.force, config);
  config.effects = make_effects(settings.effects, config.update_rate);
  return config;
}

}  // namespace hapticut::settings
