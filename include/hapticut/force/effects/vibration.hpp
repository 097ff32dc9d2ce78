// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// The vibration that the hand feels along the spindle's axis while the spinning head touches material (thesis 5.10).
///
///     F = A sin(phase),  phase advances by 2 pi f dt a step
///     A = min(amplitude + amplitude_per_watt P, max_amplitude),   P: power of the spindle
///
/// The thesis's sin(f t) oscillates at f/2pi, and sin(2 pi f t) with 500 Hz, sampled at 1 kHz, is zero at every sample.
/// Hence the accumulated phase, and the bound on the frequency (D9).
struct Vibration {
  /// [Hz] frequency of a vibration along the spindle axis during cutting; below 0.45 of the update rate
  double frequency = 150;
  double amplitude = 0.3;         ///< [N] amplitude of the vibration without a load
  double amplitude_per_watt = 0;  ///< [N/W] growth of the amplitude with the power of the spindle
  double max_amplitude = 0.5;     ///< [N] upper limit of the amplitude; not below `amplitude`
};

constexpr auto fields_of(Of<Vibration>) {
  using V = Vibration;
  return std::tuple{
      field("frequency", &V::frequency, "Hz", Range::positive(),
            "frequency of a vibration along the spindle axis during cutting; below 0.45 of the update rate"),
      field("amplitude", &V::amplitude, "N", Range::not_negative(), "amplitude of the vibration without a load"),
      field("amplitude_per_watt", &V::amplitude_per_watt, "N/W", Range::not_negative(),
            "growth of the amplitude with the power of the spindle"),
      field("max_amplitude", &V::max_amplitude, "N", Range::not_negative(), "upper limit of the amplitude"),
  };
}

/// [1] Part of the update rate: a sine sampled less than 1/0.45 times a period beats visibly, and at 0.5 may vanish.
inline constexpr double kMaxVibration = 0.45;

/// @param update_rate  [Hz] of the step
/// @throws Error naming the field, its value and the allowed range
inline void validate(const Vibration& vibration, double update_rate) {
  require_fields_within(vibration, "Vibration::");
  if (vibration.amplitude > vibration.max_amplitude)
    throw Error("Vibration::amplitude"_name + " = " + format_number(vibration.amplitude, vibration.max_amplitude) +
                " N; must not exceed max_amplitude = " + format_number(vibration.max_amplitude, vibration.amplitude) +
                " N. Lower it, or raise max_amplitude.");
  if (vibration.frequency >= kMaxVibration * update_rate)
    throw Error("Vibration::frequency"_name + " = " + format_number(vibration.frequency, kMaxVibration * update_rate) +
                " Hz; must be below " + format_number(kMaxVibration * update_rate, vibration.frequency) +
                " Hz, 0.45 of the update rate of " + format_number(update_rate) +
                " Hz: sampled more coarsely a sine beats, and at half the rate it may be zero at every sample. Lower "
                "it, or raise " +
                "SimulationConfig::update_rate"_name + " and call the step as often.");
}

/// The phase of a vibration from step to step.
class VibrationPhase {
 public:
  /// The force of this step along +z of T.
  /// @param touching  the head spins in material; otherwise there is no force, and the phase starts again
  /// @param power     [W] >= 0 of the spindle
  /// @param dt        [s] a step too long for the frequency gives no force
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] double advance(const Vibration& vibration, bool touching, double power, double dt) noexcept {
    if (!touching || vibration.frequency * dt >= kMaxVibration) {
      phase_ = 0;
      return 0;
    }
    phase_ = std::fmod(phase_ + 2 * units::kPi * vibration.frequency * dt, 2 * units::kPi);
    const double wanted = vibration.amplitude + vibration.amplitude_per_watt * std::max(0.0, power);
    return std::min(wanted, vibration.max_amplitude) * std::sin(phase_);
  }

 private:
  friend struct SimulationMemory;
  double phase_ = 0;  // [rad]
};

}  // namespace hapticut
