// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/force/effects/axis_mask.hpp"
#include "hapticut/force/effects/delta_filter.hpp"
#include "hapticut/force/effects/gravity.hpp"
#include "hapticut/force/effects/output_limits.hpp"
#include "hapticut/force/effects/tooth_passing.hpp"
#include "hapticut/force/effects/vibration.hpp"

/// Effects that are added to the force of the model, and limits of the output to the hand. They do not enter the energy
/// ledger, which describes the model.
namespace hapticut {

/// All effects, off by default.
struct Effects {
  std::optional<Gravity> gravity;           ///< weight of the tool
  std::optional<Vibration> vibration;       ///< vibration along the spindle while it cuts
  std::optional<ToothPassing> teeth;        ///< change of the force while the cutter turns
  std::optional<DeltaFilter> delta_filter;  ///< the force filter of the thesis
  AxisMask enabled;                         ///< components of the output that are on
  OutputLimits limits;                      ///< size and growth of the output
};

constexpr auto fields_of(Of<Effects>) {
  return std::tuple{
      field("gravity", &Effects::gravity, "weight of the tool"),
      field("vibration", &Effects::vibration, "vibration along the spindle while it cuts"),
      field("teeth", &Effects::teeth, "change of the force while the cutter turns"),
      field("delta_filter", &Effects::delta_filter, "the force filter of the thesis"),
      field("enabled", &Effects::enabled, "components of the output that are on"),
      field("limits", &Effects::limits, "size and growth of the output"),
  };
}

/// @param update_rate  [Hz] of the step
/// @throws Error naming the field, its value and the allowed range
void validate(const Effects& effects, double update_rate);

/// The state of a step that the effects use.
struct EffectsInput {
  Pose X_WH;              ///< pose of the handle
  Pose X_WT;              ///< pose of the head
  bool touching = false;  ///< the head spins in material
  double power = 0;       ///< [W] power of the spindle
  double dt = 0;          ///< [s]
  double lever = 1;       ///< [1] see `lever_at_handle`
  double turn = 0;        ///< [rad] angle that the spindle turns in the step
  int lips = 1;           ///< [1] lips of the cutter
};

/// Applies the effects from step to step, in this order: gravity, vibration, teeth, delta filter, mask, saturation,
/// growth limit, start-up ramp.
class Output {
 public:
  /// Computes the output to the hand until the next call.
  /// @param wrench  about Ho, in W: force and torque of the model, or of the coupling
  /// @return about Ho, in W
  /// @realtime no allocation, no lock; O(1)
  const Wrench& give(const Effects& effects, const EffectsInput& at, const Wrench& wrench) noexcept {
    given_ = limited(effects.limits, with_effects(effects, at, wrench), at.dt);
    return given_;
  }

  /// The last output to the hand.
  [[nodiscard]] const Wrench& given() const noexcept { return given_; }

  /// Gives no output in this step. Growth starts from zero again.
  void drop() noexcept {
    full_ = given_ = {};
    unlimited_force_ = Vec3::Zero();
  }

  /// Restarts the start-up ramp.
  void restart() noexcept { *this = {}; }

 private:
  friend struct SimulationMemory;
  [[nodiscard]] Wrench with_effects(const Effects& effects, const EffectsInput& at, Wrench wrench) noexcept {
    const Wrench model = wrench;
    const Vec3 arm = at.lever * (at.X_WT.translation - at.X_WH.translation);
    if (effects.gravity) {
      const Wrench weight = gravity_wrench(*effects.gravity, at.X_WH.rotation);
      wrench.force += weight.force;
      wrench.torque += weight.torque;
    }
    if (effects.vibration) {
      const double shake = vibration_.advance(*effects.vibration, at.touching, at.power, at.dt);
      const Vec3 force = shake * at.X_WT.rotation.col(2);
      wrench.force += force;
      wrench.torque += arm.cross(force);
    }
    if (effects.teeth && at.touching) {
      const double factor = cutter_.advance(*effects.teeth, at.turn, at.lips);
      wrench.force += factor * model.force;
      wrench.torque += factor * model.torque;
    }
    if (effects.delta_filter) {
      const Vec3 force = filtered(*effects.delta_filter, unlimited_force_, wrench.force);
      wrench.torque += arm.cross(force - wrench.force);
      wrench.force = force;
    }
    unlimited_force_ = wrench.force;
    return masked(effects.enabled, wrench);
  }

  [[nodiscard]] Wrench limited(const OutputLimits& limits, Wrench wrench, double dt) noexcept {
    running_ += dt;
    const double ramp = limits.ramp_time > 0 ? std::min(1.0, running_ / limits.ramp_time) : 1.0;
    wrench.force = saturated(wrench.force, limits.max_force);
    wrench.torque = saturated(wrench.torque, limits.max_torque);
    const auto grown = [dt](const Vec3& from, const Vec3& to, double rate) {
      return std::isinf(rate) ? to : growth_limited(from, to, rate * dt);
    };
    full_.force = grown(full_.force, wrench.force, limits.force_growth);
    full_.torque = grown(full_.torque, wrench.torque, limits.torque_growth);
    return {ramp * full_.force, ramp * full_.torque};
  }

  VibrationPhase vibration_;
  CutterAngle cutter_;
  Vec3 unlimited_force_ = Vec3::Zero();  // [N] with effects, before the mask
  Wrench full_;                          // within the limits, before the ramp
  Wrench given_;
  double running_ = 0;  // [s]
};

}  // namespace hapticut
