// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/pose_gate.hpp"

#include <limits>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kRest = 0.1;          // [s] after which the orientation of a resting stylus is stored again
constexpr double kSumRounding = 1e-9;  // [s] rounding error of a sum of periods

}  // namespace

PoseGate::PoseGate(const DeviceCapabilities& capabilities, const PoseGateOptions& options)
    : options_(options),
      low_(capabilities.workspace_low - Vec3::Constant(options.workspace_margin)),
      high_(capabilities.workspace_high + Vec3::Constant(options.workspace_margin)),
      bounded_((capabilities.workspace_high - capabilities.workspace_low).minCoeff() > 0) {
  require_fields_within(options, "PoseGateOptions::");
  if (capabilities.simulated) options_.frozen_rotation = std::numeric_limits<double>::infinity();
}

void PoseGate::restart() noexcept {
  started_ = false;
  elapsed_ = 0;
  bad_ = contradicted_ = 0;
  resting_.reset();
}

std::optional<SafetyEvent> PoseGate::objection(const DeviceState& reading, double& value) noexcept {
  const Pose& X = reading.X_BS;
  if (!reading.valid) return SafetyEvent::reading_invalid;
  if (!is_finite(X) || !is_finite(reading.velocity.linear) || !is_finite(reading.velocity.angular))
    return SafetyEvent::pose_not_finite;
  if (!is_rotation(X.rotation, options_.rotation_tolerance)) return SafetyEvent::pose_not_a_rotation;
  if (bounded_ && ((X.translation.array() < low_.array()).any() || (X.translation.array() > high_.array()).any())) {
    value = X.translation.norm();
    return SafetyEvent::pose_outside_workspace;
  }
  if (!started_) return {};
  value = (X.translation - state_.X_BS.translation).norm();
  if (value > options_.max_speed * elapsed_) return SafetyEvent::pose_jump;
  value = vector_from_rotation(X.rotation * state_.X_BS.rotation.transpose()).norm();
  if (value > options_.max_angular_speed * elapsed_) return SafetyEvent::pose_rotation_jump;
  return {};
}

bool PoseGate::is_frozen(const DeviceState& reading, double dt) noexcept {
  if (!resting_ || reading.X_BS.translation != X_BS_still_.translation) {
    X_BS_still_ = reading.X_BS;
    resting_ = 0;
    contradicted_ = 0;
    return false;
  }
  const bool rotated =
      vector_from_rotation(reading.X_BS.rotation * X_BS_still_.rotation.transpose()).norm() > options_.frozen_rotation;
  const bool moves = reading.velocity.linear.norm() > options_.frozen_speed;
  if (rotated || moves) return (contradicted_ += dt) >= options_.frozen - kSumRounding;
  contradicted_ = 0;
  if ((*resting_ += dt) >= kRest - kSumRounding) {  // a slower rotation does not count
    X_BS_still_ = reading.X_BS;
    resting_ = 0;
  }
  return false;
}

PoseGate::Verdict PoseGate::check(const DeviceState& reading, double dt, SafetyLog& log) noexcept {
  if (started_ && reading.epoch != state_.epoch) {
    log.report(SafetyEvent::recalibrated, reading.epoch);
    restart();
  }
  elapsed_ += dt;
  double value = 0;
  std::optional<SafetyEvent> bad;
  if (started_ && reading.sequence == state_.sequence)
    bad = SafetyEvent::reading_stale;
  else
    bad = objection(reading, value);

  // The driver's own state is copied in any case.
  state_.time = reading.time;
  state_.fault = reading.fault;
  state_.temperature = reading.temperature;
  if (bad) {
    log.report(*bad, value);
    // A jump does not become plausible by waiting. A missing reading does give the hand time to move.
    if (*bad == SafetyEvent::pose_jump || *bad == SafetyEvent::pose_rotation_jump) elapsed_ -= dt;
    state_.velocity = {};
    const bool lost = !started_ || (bad_ += dt) > options_.hold + kSumRounding;
    state_.valid = !lost;
    if (lost) return Verdict::lost;
    return *bad == SafetyEvent::reading_stale ? Verdict::repeated : Verdict::held;
  }
  if (is_frozen(reading, dt)) {
    log.report(SafetyEvent::pose_frozen, contradicted_);
    state_.velocity = {};
    state_.valid = false;
    return Verdict::lost;
  }
  state_ = reading;
  state_.X_BS.rotation = orthonormalized(reading.X_BS.rotation);
  started_ = true;
  elapsed_ = 0;
  bad_ = 0;
  return Verdict::accepted;
}

}  // namespace hapticut
