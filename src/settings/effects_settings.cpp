// SPDX-License-Identifier: Apache-2.0
#include "settings/effects_settings.hpp"

#include <algorithm>

#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

constexpr Keys kGravity{"effects", "", {{"mass", "mass", "no weight"}, {"acceleration", "gravity"}}};
constexpr Keys kVibration{"effects",
                          "vibration",
                          {{"frequency", "", "no vibration"},
                           {"amplitude", ""},
                           {"amplitude_per_watt", ""},
                           {"max_amplitude", "max", ", or vibration_N if larger"}}};
constexpr Keys kTeeth{"effects", "texture"};
constexpr Keys kFilter{"effects", "filter", {}, "thesis_filter: "};
constexpr Keys kLimits{"effects", "", {{"ramp_time", "ramp"}}};

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
  if (s.gravity[&Gravity::mass]) return s.gravity.make(kGravity, "gravity");
  s.gravity.refuse(kGravity, "a tool without " + "effects.mass_kg"_name, "set " + "effects.mass_kg"_name);
  return std::nullopt;
}

std::optional<Vibration> make_vibration(const EffectsSettings& s, double update_rate) {
  if (!s.vibration[&Vibration::frequency]) {
    s.vibration.refuse(kVibration, "a tool without " + "effects.vibration_Hz"_name,
                       "set " + "effects.vibration_Hz"_name);
    return std::nullopt;
  }
  Vibration vibration = s.vibration.make(kVibration, "the vibration");
  if (!s.vibration[&Vibration::max_amplitude])
    vibration.max_amplitude = std::max(vibration.max_amplitude, vibration.amplitude);
  if (vibration.frequency >= kMaxVibration * update_rate)
    throw Error("effects.vibration_Hz"_name + " = " + format_number(vibration.frequency, kMaxVibration * update_rate) +
                "; must be a number > 0 and below " + format_number(kMaxVibration * update_rate, vibration.frequency) +
                ", 0.45 of " + "simulation.rate_Hz"_name + " = " + format_number(update_rate) +
                ": a sine that is sampled more coarsely beats, and at half the rate every sample may be 0. Lower the "
                "frequency, or raise " +
                "simulation.rate_Hz"_name + ".");
  require_at_most(vibration.amplitude, "effects.vibration_N"_name, vibration.max_amplitude,
                  "effects.vibration_max_N"_name);
  return vibration;
}

std::optional<ToothPassing> make_teeth(const EffectsSettings& s, bool texture) {
  if (texture) return s.teeth.make(kTeeth, "the passing teeth");
  s.teeth.refuse(kTeeth, "a force without texture", "set " + "simulation.texture"_name);
  return std::nullopt;
}

std::optional<DeltaFilter> make_filter(const EffectsSettings& s) {
  if (!s.thesis_filter) {
    s.filter.refuse(kFilter, "an output without " + "effects.thesis_filter"_name,
                    "set " + "effects.thesis_filter"_name);
    return std::nullopt;
  }
  const DeltaFilter filter = s.filter.make(kFilter, "the filter");
  require_at_most(filter.epsilon, "effects.filter_epsilon_N"_name, filter.delta, "effects.filter_delta_N"_name);
  return filter;
}

}  // namespace

std::vector<Setting> settings_of(EffectsSettings& s) {
  std::vector<Setting> settings;
  s.gravity.add_settings(kGravity, settings);
  s.vibration.add_settings(kVibration, settings);
  s.teeth.add_settings(kTeeth, settings);
  settings.push_back(boolean("effects.thesis_filter", "--thesis_filter", s.thesis_filter,
                             "turns on the force filter of the thesis, Table 6.1 [false]"));
  s.filter.add_settings(kFilter, settings);
  settings.push_back(axes("effects.force_axes", "--force_axes", s.force_axes,
                          "turns the force along x, y, z of the workpiece on (1) or off (0) [1,1,1]"));
  settings.push_back(axes("effects.torque_axes", "--torque_axes", s.torque_axes,
                          "turns the torque about x, y, z of the workpiece on (1) or off (0) [1,1,1]"));
  s.limits.add_settings(kLimits, settings);
  return settings;
}

Effects make_effects(const EffectsSettings& s, double update_rate, bool texture) {
  Effects effects;
  effects.gravity = make_gravity(s);
  effects.vibration = make_vibration(s, update_rate);
  effects.teeth = make_teeth(s, texture);
  effects.delta_filter = make_filter(s);
  effects.enabled = {switches(s.force_axes), switches(s.torque_axes)};
  effects.limits = s.limits.make(kLimits, "the output");
  return effects;
}

}  // namespace hapticut::settings
