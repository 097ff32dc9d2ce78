// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/output.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {
void validate(const Gravity& gravity) { require_fields_within(gravity, "Gravity::"); }

void validate(const Vibration& vibration, double update_rate) {
  require_fields_within(vibration, "Vibration::");
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
  require_fields_within(filter, "DeltaFilter::");
  if (filter.epsilon > filter.delta)
    throw Error("DeltaFilter::epsilon = " + format_number(filter.epsilon) + " N; must not exceed delta = " +
                format_number(filter.delta) + " N, or the force would overshoot. Lower it, or raise delta.");
}

void validate(const OutputLimits& limits) { require_fields_within(limits, "OutputLimits::"); }

void validate(const Effects& effects, double update_rate) {
  if (effects.gravity) validate(*effects.gravity);
  if (effects.vibration) validate(*effects.vibration, update_rate);
  if (effects.delta_filter) validate(*effects.delta_filter);
  validate(effects.limits);
}

}  // namespace hapticut
