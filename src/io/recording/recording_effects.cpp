// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/errors.hpp"
#include "io/recording/recording_settings.hpp"

namespace hapticut {
namespace {

/// Goes over the numbers of the effects in their order.
template <class Visit>
void visit_effects(Effects& e, bool& gravity, bool& vibration, bool& filter, Gravity& g, Vibration& v, DeltaFilter& f,
                   const Visit& visit) {
  visit("gravity", gravity);
  visit("gravity_mass_kg", g.mass);
  visit("gravity_center_x_m", g.center_of_mass.x());
  visit("gravity_center_y_m", g.center_of_mass.y());
  visit("gravity_center_z_m", g.center_of_mass.z());
  visit("gravity_x_m_per_s2", g.acceleration.x());
  visit("gravity_y_m_per_s2", g.acceleration.y());
  visit("gravity_z_m_per_s2", g.acceleration.z());
  visit("vibration", vibration);
  visit("vibration_frequency_Hz", v.frequency);
  visit("vibration_amplitude_N", v.amplitude);
  visit("vibration_amplitude_N_per_W", v.amplitude_per_watt);
  visit("vibration_largest_amplitude_N", v.largest_amplitude);
  visit("delta_filter", filter);
  visit("delta_filter_delta_N", f.delta);
  visit("delta_filter_epsilon_N", f.epsilon);
  visit("force_x", e.enabled.force[0]);
  visit("force_y", e.enabled.force[1]);
  visit("force_z", e.enabled.force[2]);
  visit("torque_x", e.enabled.torque[0]);
  visit("torque_y", e.enabled.torque[1]);
  visit("torque_z", e.enabled.torque[2]);
  visit("largest_force_N", e.limits.largest_force);
  visit("largest_torque_Nm", e.limits.largest_torque);
  visit("force_growth_N_per_s", e.limits.force_growth);
  visit("torque_growth_Nm_per_s", e.limits.torque_growth);
  visit("ramp_time_s", e.limits.ramp_time);
}

template <class Visit>
void visit_all(Effects& effects, const Visit& visit) {
  bool gravity = effects.gravity.has_value(), vibration = effects.vibration.has_value(),
       filter = effects.delta_filter.has_value();
  Gravity g = effects.gravity.value_or(Gravity{});
  Vibration v = effects.vibration.value_or(Vibration{});
  DeltaFilter f = effects.delta_filter.value_or(DeltaFilter{});
  visit_effects(effects, gravity, vibration, filter, g, v, f, visit);
  effects.gravity = gravity ? std::optional(g) : std::nullopt;
  effects.vibration = vibration ? std::optional(v) : std::nullopt;
  effects.delta_filter = filter ? std::optional(f) : std::nullopt;
}

double to_number(double value) { return value; }
double to_number(bool value) { return value ? 1 : 0; }
void from_number(double number, double& value) { value = number; }
void from_number(double number, bool& value) { value = number != 0; }

}  // namespace

EffectNumbers pack(const Effects& effects) noexcept {
  EffectNumbers numbers{};
  Effects copy = effects;
  std::size_t n = 0;
  visit_all(copy, [&](const char*, const auto& value) { numbers[n++] = to_number(value); });
  HAPTICUT_ASSERT(n == kEffectNumbers);
  return numbers;
}

Effects unpack(const EffectNumbers& numbers) {
  Effects effects;
  // What is absent is visited only when it is there: so make it all, and let the flags say what to keep.
  effects.gravity.emplace();
  effects.vibration.emplace();
  effects.delta_filter.emplace();
  std::size_t n = 0;
  visit_all(effects, [&](const char*, auto& value) { from_number(numbers[n++], value); });
  return effects;
}

std::string effect_names() {
  std::string names;
  Effects none;
  visit_all(none, [&](const char* name, const auto&) {
    if (!names.empty()) names += ',';
    names += name;
  });
  return names;
}

}  // namespace hapticut
