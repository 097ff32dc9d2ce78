// SPDX-License-Identifier: Apache-2.0
#include "settings/effects_settings.hpp"

#include "hapticut/core/units.hpp"
#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

/// Three switches, one for each axis.
Setting axes(std::string key, std::string flag, std::vector<double>& target, std::string meaning) {
  Setting setting = numbers(std::move(key), std::move(flag), target, 3, Range::between(0, 1), std::move(meaning));
  setting.allowed = "3 numbers, each 0 or 1";
  setting.assign = [&target](const Value& value) {
    const auto& given = std::get<std::vector<double>>(value);
    if (given.size() != 3) return false;
    for (const double one : given)
      if (one != 0 && one != 1) return false;
    target = given;
    return true;
  };
  return setting;
}

std::array<bool, 3> switches(const std::vector<double>& given) {
  if (given.empty()) return {true, true, true};
  return {given[0] != 0, given[1] != 0, given[2] != 0};
}

std::optional<Gravity> make_gravity(const EffectsSettings& s) {
  if (!s.mass_kg) {
    refuse(s.center_of_mass_mm, "effects.center_of_mass_mm", "a tool without effects.mass_kg",
           "set " + "effects.mass_kg"_name);
    refuse(s.gravity_m_per_s2, "effects.gravity_m_per_s2", "a tool without effects.mass_kg",
           "set " + "effects.mass_kg"_name);
    return std::nullopt;
  }
  Gravity gravity;
  gravity.mass = *s.mass_kg;
  if (s.center_of_mass_mm) gravity.center_of_mass = *s.center_of_mass_mm * units::mm;
  gravity.acceleration = s.gravity_m_per_s2.value_or(gravity.acceleration);
  return gravity;
}

std::optional<Vibration> make_vibration(const EffectsSettings& s, double update_rate) {
  if (!s.vibration_Hz) {
    for (const auto& [key, value] :
         {std::pair("effects.vibration_N", s.vibration_N), std::pair("effects.vibration_N_per_W", s.vibration_N_per_W),
          std::pair("effects.vibration_max_N", s.vibration_max_N)})
      refuse(value, key, "a tool without effects.vibration_Hz", "set " + "effects.vibration_Hz"_name);
    return std::nullopt;
  }
  Vibration vibration;
  vibration.frequency = *s.vibration_Hz;
  vibration.amplitude = s.vibration_N.value_or(vibration.amplitude);
  vibration.amplitude_per_watt = s.vibration_N_per_W.value_or(vibration.amplitude_per_watt);
  vibration.max_amplitude = s.vibration_max_N.value_or(std::max(vibration.max_amplitude, vibration.amplitude));
  if (vibration.frequency >= kMaxVibration * update_rate)
    throw Error("effects.vibration_Hz = " + format_number(vibration.frequency, kMaxVibration * update_rate) +
                "; must be a number > 0 and below " + format_number(kMaxVibration * update_rate, vibration.frequency) +
                ", 0.45 of simulation.rate_Hz = " + format_number(update_rate) +
                ": a sine that is sampled more coarsely beats, and at half the rate every sample may be 0. Lower the "
                "frequency, or raise simulation.rate_Hz.");
  require_at_most(vibration.amplitude, "effects.vibration_N", vibration.max_amplitude, "effects.vibration_max_N");
  return vibration;
}

std::optional<DeltaFilter> make_filter(const EffectsSettings& s) {
  if (!s.thesis_filter) {
    for (const auto& [key, value] : {std::pair("effects.filter_delta_N", s.filter_delta_N),
                                     std::pair("effects.filter_epsilon_N", s.filter_epsilon_N)})
      refuse(value, key, "an output without effects.thesis_filter", "set " + "effects.thesis_filter"_name);
    return std::nullopt;
  }
  DeltaFilter filter;
  filter.delta = s.filter_delta_N.value_or(filter.delta);
  filter.epsilon = s.filter_epsilon_N.value_or(filter.epsilon);
  require_at_most(filter.epsilon, "effects.filter_epsilon_N", filter.delta, "effects.filter_delta_N");
  return filter;
}

}  // namespace

std::vector<Setting> settings_of(EffectsSettings& s) {
  std::vector<Setting> settings = {
      number("effects.mass_kg", "--mass_kg", s.mass_kg, range_of(&Gravity::mass),
             "mass of the tool minus mass of the device's stylus; its weight acts on the hand [no weight]"),
      vector("effects.center_of_mass_mm", "--center_of_mass_mm", s.center_of_mass_mm, Range::any(),
             "centre of this mass, from the hand, in the axes of the handle [0,0,0]"),
      vector("effects.gravity_m_per_s2", "--gravity_m_per_s2", s.gravity_m_per_s2, Range::any(),
             "gravitational acceleration [0,0,-9.80665]"),
      number("effects.vibration_Hz", "--vibration_Hz", s.vibration_Hz, range_of(&Vibration::frequency),
             "frequency of a vibration along the spindle axis during cutting; below 0.45 of simulation.rate_Hz [no "
             "vibration]"),
      number("effects.vibration_N", "--vibration_N", s.vibration_N, range_of(&Vibration::amplitude),
             "amplitude of the vibration [0.3]"),
      number("effects.vibration_N_per_W", "--vibration_N_per_W", s.vibration_N_per_W,
             range_of(&Vibration::amplitude_per_watt), "growth of this amplitude with the power of the spindle [0]"),
      number("effects.vibration_max_N", "--vibration_max_N", s.vibration_max_N, range_of(&Vibration::max_amplitude),
             "upper limit of this amplitude [0.5, or vibration_N if larger]"),
      boolean("effects.thesis_filter", "--thesis_filter", s.thesis_filter,
              "turns on the force filter of the thesis, Table 6.1 [false]"),
      number("effects.filter_delta_N", "--filter_delta_N", s.filter_delta_N, range_of(&DeltaFilter::delta),
             "thesis_filter: a force change per step up to this size passes unchanged [0.5]"),
      number("effects.filter_epsilon_N", "--filter_epsilon_N", s.filter_epsilon_N, range_of(&DeltaFilter::epsilon),
             "thesis_filter: force change per step when the calculated one is larger [0.005]"),
      axes("effects.force_axes", "--force_axes", s.force_axes,
           "turns the force along x, y, z of the workpiece on (1) or off (0) [1,1,1]"),
      axes("effects.torque_axes", "--torque_axes", s.torque_axes,
           "turns the torque about x, y, z of the workpiece on (1) or off (0) [1,1,1]"),
  };
  add_fields("effects", s.limits, &OutputLimits::ramp_time, settings);
  settings.push_back(number("effects.ramp_s", "--ramp_s", s.limits.ramp_time, range_of(&OutputLimits::ramp_time),
                            "time after the start in which the output grows to its full size [0]"));
  return settings;
}

Effects make_effects(const EffectsSettings& s, double update_rate) {
  Effects effects;
  effects.gravity = make_gravity(s);
  effects.vibration = make_vibration(s, update_rate);
  effects.delta_filter = make_filter(s);
  effects.enabled = {switches(s.force_axes), switches(s.torque_axes)};
  effects.limits = s.limits;
  return effects;
}

}  // namespace hapticut::settings
