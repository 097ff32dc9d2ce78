// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/output.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

void require_finite(const Vec3& v, const char* name) {
  if (!is_finite(v)) throw Error(std::string(name) + " holds a number that is not finite. Give three numbers.");
}

/// Positive; infinity means no limit.
void require_limit(double value, const char* name) {
  if (!(value > 0))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be > 0. Leave it at infinity for no limit.");
}

}  // namespace

void validate(const Gravity& gravity) {
  require_not_negative(gravity.mass, "Gravity::mass [kg]");
  require_finite(gravity.center_of_mass, "Gravity::center_of_mass [m]");
  require_finite(gravity.acceleration, "Gravity::acceleration [m/s^2]");
}

void validate(const Vibration& vibration, double update_rate) {
  require_positive(vibration.frequency, "Vibration::frequency [Hz]");
  require_not_negative(vibration.amplitude, "Vibration::amplitude [N]");
  require_not_negative(vibration.amplitude_per_watt, "Vibration::amplitude_per_watt [N/W]");
  require_not_negative(vibration.largest_amplitude, "Vibration::largest_amplitude [N]");
  if (vibration.amplitude > vibration.largest_amplitude)
    throw Error("Vibration::amplitude = " + format_number(vibration.amplitude) +
                " N; must not exceed largest_amplitude = " + format_number(vibration.largest_amplitude) +
                " N. Lower it, or raise largest_amplitude.");
  if (vibration.frequency >= kFastestVibration * update_rate)
    throw Error("Vibration::frequency = " + format_number(vibration.frequency) + " Hz; must be below " +
                format_number(kFastestVibration * update_rate) + " Hz, 0.45 of the update rate of " +
                format_number(update_rate) +
                " Hz: sampled more coarsely a sine beats, and at half the rate it may be zero at every sample. Lower "
                "it, or raise SimulationConfig::update_rate and call the step as often.");
}

void validate(const DeltaFilter& filter) {
  require_positive(filter.delta, "DeltaFilter::delta [N]");
  require_positive(filter.epsilon, "DeltaFilter::epsilon [N]");
  if (filter.epsilon > filter.delta)
    throw Error("DeltaFilter::epsilon = " + format_number(filter.epsilon) + " N; must not exceed delta = " +
                format_number(filter.delta) + " N, or the force would overshoot. Lower it, or raise delta.");
}

void validate(const OutputLimits& limits) {
  require_limit(limits.largest_force, "OutputLimits::largest_force [N]");
  require_limit(limits.largest_torque, "OutputLimits::largest_torque [N m]");
  require_limit(limits.force_growth, "OutputLimits::force_growth [N/s]");
  require_limit(limits.torque_growth, "OutputLimits::torque_growth [N m/s]");
  require_not_negative(limits.ramp_time, "OutputLimits::ramp_time [s]");
}

void validate(const Effects& effects, double update_rate) {
  if (effects.gravity) validate(*effects.gravity);
  if (effects.vibration) validate(*effects.vibration, update_rate);
  if (effects.delta_filter) validate(*effects.delta_filter);
  validate(effects.limits);
}

}  // namespace hapticut
