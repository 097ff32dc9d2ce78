// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/effects/vibration.hpp"

namespace hapticut {

/// How the force of a cut changes while the cutter turns: once per turn, because the head runs out of true, and with
/// each tooth that passes.
///
///     F_vib = F (a_1 sin(phi) + a_z sin(z phi)),   phi advances by the angle that the spindle turns, z: lips
///
/// F is the force of the model or of the coupling. Over a turn the mean is zero, and so is the work on a hand that
/// moves steadily; the variance is F^2 (a_1^2 + a_z^2)/2 (`closed_forms::tooth_passing_variation`). A part that is
/// faster than 0.45 of the rate of the steps is left out, because samples could not show it: at 1 kHz turns above
/// 27 000 rpm, and teeth above 27 000 rpm over z. A cutter with one lip, as of diamonds, has turns only.
struct ToothPassing {
  /// [1] a_1, amplitude of the change once per turn, over the force.
  /// Assumed; no source gives it. Run-out is 3.5 ... 7.8 um (Kim et al. 2019), and 20 ... 50 um with welded shanks
  /// (Watson et al. 1995).
  double once_per_turn = 0.05;
  double per_tooth = 0.02;  ///< [1] a_z, amplitude of the change with each tooth, over the force; assumed
};

constexpr auto fields_of(Of<ToothPassing>) {
  using T = ToothPassing;
  return std::tuple{
      field("once_per_turn", &T::once_per_turn, "1", Range::between(0, 1),
            "a_1, amplitude of the change once per turn, over the force"),
      field("per_tooth", &T::per_tooth, "1", Range::between(0, 1),
            "a_z, amplitude of the change with each tooth, over the force; assumed"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const ToothPassing& teeth) { require_fields_within(teeth, "ToothPassing::"); }

/// The angle of the cutter from step to step.
class CutterAngle {
 public:
  /// What this step adds to the force, as a factor of it.
  /// @param turn  [rad] angle that the spindle turns in the step
  /// @param lips  [1] z; one is not a tooth, but all grains together
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] double advance(const ToothPassing& teeth, double turn, int lips) noexcept {
    constexpr double kFull = 2 * units::kPi;
    angle_ = std::fmod(angle_ + std::fmod(turn, kFull), kFull);
    const double turns = std::abs(turn) / kFull;
    double factor = 0;
    if (turns < kMaxVibration) factor += teeth.once_per_turn * std::sin(angle_);
    if (lips > 1 && lips * turns < kMaxVibration) factor += teeth.per_tooth * std::sin(lips * angle_);
    return factor;
  }

 private:
  friend struct SimulationMemory;
  double angle_ = 0;  // [rad] phi
};

}  // namespace hapticut
