// SPDX-License-Identifier: Apache-2.0
#include "page/session/pointer_hand.hpp"

#include <cmath>

#include "hapticut/force/effects/output_limits.hpp"

namespace hapticut::apps {
namespace {

constexpr double kFollow = 10e-3;       // [s] time constant
constexpr double kMaxHandSpeed = 0.2;   // [m/s]
constexpr double kMaxAngularSpeed = 6;  // [rad/s]

DeviceCapabilities capabilities_of_a_pointer(const Box& around) {
  DeviceCapabilities c;
  c.model = "pointer";
  c.vendor = "page";
  c.input_degrees_of_freedom = 6;
  c.output_degrees_of_freedom = 3;
  c.peak_force = 30;
  c.stiffness = 2000;
  c.damping = 20;
  c.workspace_low = around.min;
  c.workspace_high = around.max;
  c.hard_realtime = false;
  c.simulated = true;
  return c;
}

/// One tick of a critically damped follower, exact for a constant target.
void follow(Vec3& offset, Vec3& velocity, double dt) {
  const double w = 1 / kFollow, decay = std::exp(-w * dt);
  const Vec3 slope = velocity + w * offset;
  const Vec3 after = (offset + slope * dt) * decay;
  velocity = (velocity - w * slope * dt) * decay;
  offset = after;
}

}  // namespace

PointerHand::PointerHand(const Box& around)
    : PolledDevice("pointer", capabilities_of_a_pointer(around)), around_(around) {}

void PointerHand::put(const Pose& X_WT) {
  X_WT_ = X_WT;
  velocity_ = {};
  target_.write({X_WT, false});
}

void PointerHand::begin_run(const RunOptions& options) {
  period_ = options.guard.period;
  simulated_ = options.simulated_time;
  tick_ = 0;
  velocity_ = {};
}

bool PointerHand::read(DeviceState& state) noexcept {
  const auto& [target_pose, pressed] = target_.latest();
  const Vec3 target = target_pose.translation.cwiseMax(around_.min).cwiseMin(around_.max);
  Vec3 offset = X_WT_.translation - target;
  Vec3 rotation = -twist_between(X_WT_, target_pose, 1).angular;
  Vec3 linear = velocity_.linear, angular = velocity_.angular;
  follow(offset, linear, period_);
  follow(rotation, angular, period_);
  const Vec3 before = X_WT_.translation;
  const Vec3 step = saturated(target + offset - before, kMaxHandSpeed * period_);
  X_WT_.translation = before + step;
  velocity_.linear = saturated(linear, kMaxHandSpeed);
  velocity_.angular = saturated(angular, kMaxAngularSpeed);
  X_WT_.rotation = orthonormalized(Mat3(rotation_from_vector(Vec3(velocity_.angular * period_)) * X_WT_.rotation));

  const double now = monotonic_time();
  if (tick_ == 0) begin_ = now;
  state = {};
  state.X_BS = X_WT_;
  state.velocity = velocity_;
  state.buttons = pressed ? 1U << unsigned(kPress) : 0;
  state.time = simulated_ ? double(tick_) * period_ : now - begin_;
  state.sequence = ++tick_;
  return true;
}

}  // namespace hapticut::apps
