// SPDX-License-Identifier: Apache-2.0
#include "settings/simulation_settings.hpp"

#include "hapticut/core/errors.hpp"
#include "hapticut/simulation/thesis_mode.hpp"

namespace hapticut::settings {
namespace {

/// Sets the model of the thesis for all settings that have no value.
void fill_in_thesis_mode(SimulationSettings& s) {
  ThesisMode mode;
  mode.update_rate = s.rate_Hz;
  const SimulationConfig thesis = thesis_mode(mode);
  ForceSettings& force = s.force;
  if (!force.law) force.law = ForceSettings::Law::thesis;
  if (!force.handle_torque) force.handle_torque = thesis.handle_torque;
  if (!s.quadrature && force.law == ForceSettings::Law::thesis) s.quadrature = thesis.quadrature;
  s.effects.thesis_filter = true;
  std::optional<double>& frequency = s.effects.vibration[&Vibration::frequency];
  if (const auto& vibration = thesis.effects.vibration; vibration && !frequency) {
    frequency = vibration->frequency;
    std::optional<double>& amplitude = s.effects.vibration[&Vibration::amplitude];
    if (!amplitude) amplitude = vibration->amplitude;
  }
}

}  // namespace

std::vector<Setting> settings_of(SimulationSettings& s) {
  const SimulationConfig limits;
  std::vector<Setting> all = {
      number("simulation.rate_Hz", "--rate", s.rate_Hz, Range::between(1 / limits.max_dt, 1 / limits.min_dt),
             "steps per second [1000]"),
      boolean("simulation.thesis_mode", "--thesis_mode", s.thesis_mode,
              "the whole model of the thesis: law, handle torque and filter; vibration at 1112 Hz and above; "
              "other settings override it [false]"),
      boolean(
          "simulation.texture", "--texture", s.texture,
          "a hand feels the grain of the materials and the turns of the cutter [true for loop and view with the law "
          "foundation, else false]"),
      integer("simulation.grain_seed", "--grain_seed", s.config.grain_seed, 0, 4294967295.0,
              "another seed gives another grain with the same statistics [1]"),
      number("simulation.reference_stiffness_N_per_m4", "--reference_stiffness", s.config.reference_stiffness,
             range_of(&SimulationConfig::reference_stiffness),
             "foundation stiffness, N/m^4, of a material with relative stiffness 1; 0: chosen from the radius of the "
             "head [0]"),
      number("simulation.contact_damping_s_per_m", "--contact_damping", s.config.contact_damping,
             range_of(&SimulationConfig::contact_damping),
             "damping of the contact, s/m, added to the damping of each material [300 for law foundation with a "
             "coupling, else 0]"),
      choice("simulation.removal", "--removal", s.removal, "removal law [constant_energy]"),
      choice("simulation.quadrature", "--quadrature", s.quadrature,
             "point in a partly filled voxel where the force is evaluated [automatic: sub_voxel, or centroid for laws "
             "evaluated at points]"),
      integer("simulation.reserved_blocks", "--reserved_blocks", s.config.reserved_blocks, 1, 1e6,
              "memory blocks kept free for cutting; refilled between steps [2048]"),
      boolean("simulation.list_removed_voxels", "--list_removed_voxels", s.config.list_removed_voxels,
              "list the voxels that each step removes, for recordings and the report of drill [true]"),
      boolean("simulation.remove_loose_pieces", "--remove_loose_pieces", s.remove_loose_pieces,
              "removes pieces that the tool has cut loose from their body [false]"),
      integer("simulation.voxel_budget", "--voxel_budget", s.config.voxel_budget, 0, 1e9,
              "maximum number of voxels evaluated per sub-step, at least 4096; if the head touches more, every n-th "
              "strip of 16 voxels is evaluated and weighted by n; 0: no limit [0]"),
  };
  return together({std::move(all), settings_of(s.force), settings_of(s.effects)});
}

SimulationConfig make_config(const SimulationSettings& given) {
  constexpr auto foundation = ForceSettings::Law::foundation;
  SimulationSettings settings = given;
  if (settings.thesis_mode) fill_in_thesis_mode(settings);
  SimulationConfig config = settings.config;
  config.removal = settings.removal.value_or(config.removal);
  if (config.removal == RemovalLaw::elastic_release && settings.force.law.value_or(foundation) != foundation)
    throw Error("simulation.removal"_name +
                " = elastic_release; only the foundation law has it. Leave it out, or choose " + "force.law"_name +
                " foundation.");
  config.quadrature = settings.quadrature.value_or(config.quadrature);
  config.update_rate = settings.rate_Hz;
  apply(settings.force, config);
  config.grain = settings.texture.value_or(settings.texture_by_default && config.law->is_foundation());
  config.effects = make_effects(settings.effects, config.update_rate, config.grain);
  return config;
}

}  // namespace hapticut::settings
