// SPDX-License-Identifier: Apache-2.0
#include "cli/simulation_settings.hpp"

namespace hapticut::cli {

std::vector<Setting> settings_of(SimulationSettings& s) {
  const SimulationConfig limits;
  std::vector<Setting> all = {
      number("simulation.rate_Hz", "--rate", s.rate_Hz, Range::between(1 / limits.longest_dt, 1 / limits.shortest_dt),
             "steps per second [1000]"),
      number("simulation.reference_stiffness_N_per_m4", "--reference_stiffness", s.config.reference_stiffness,
             Range::positive(), "foundation stiffness, N/m^4, of a material of relative stiffness 1 [1e13]"),
      choice("simulation.removal", "--removal", s.removal,
             {{"none", RemovalLaw::none},
              {"constant_energy", RemovalLaw::constant_energy},
              {"elastic_release", RemovalLaw::elastic_release}},
             "how material is taken away [constant_energy]"),
      choice("simulation.quadrature", "--quadrature", s.quadrature,
             {{"centroid", Quadrature::centroid}, {"voxel_center", Quadrature::voxel_center}},
             "where in a partly filled voxel its force is taken [centroid]"),
      integer("simulation.reserved_blocks", "--reserved_blocks", s.config.reserved_blocks, 1, 1e6,
              "blocks kept ready for cutting; they are refilled between steps [2048]"),
      integer("simulation.voxel_budget", "--voxel_budget", s.config.voxel_budget, 0, 1e9,
              "most voxels that a step evaluates, the others take turns; 0: all [0]"),
  };
  for (std::vector<Setting> more : {settings_of(s.force), settings_of(s.effects)})
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return all;
}

SimulationConfig make_config(const SimulationSettings& settings) {
  SimulationConfig config = settings.config;
  config.removal = settings.removal.value_or(config.removal);
  config.quadrature = settings.quadrature.value_or(config.quadrature);
  config.update_rate = settings.rate_Hz;
  apply(settings.force, config);
  config.effects = make_effects(settings.effects, config.update_rate);
  return config;
}

}  // namespace hapticut::cli
