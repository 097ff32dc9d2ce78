// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/thesis_mode.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

SimulationConfig thesis_mode(const ThesisMode& mode) {
  constexpr double kFrequency = 500, kAmplitude = 0.3;  // [Hz], [N]: case study 6.5
  require_not_negative(mode.tool_mass, "ThesisMode::tool_mass [kg]");
  SimulationConfig config;
  config.law = std::make_shared<ThesisLaw>(mode.law);
  config.quadrature = Quadrature::voxel_center;
  config.deep_contact = false;
  config.handle_torque = HandleTorque::thesis;
  config.handle_torque_scale = mode.handle_torque_scale;
  config.update_rate = mode.update_rate;
  if (mode.tool_mass > 0) config.effects.gravity = Gravity{mode.tool_mass, mode.center_of_mass};
  if (kFrequency < kMaxVibration * mode.update_rate) {
    Vibration vibration;
    vibration.frequency = kFrequency;
    vibration.amplitude = kAmplitude;
    config.effects.vibration = vibration;
  }
  config.effects.delta_filter = DeltaFilter{};
  validate(config);
  return config;
}

}  // namespace hapticut
