// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/closed_loop.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

constexpr int kFineSteps = 50;  // steps in a tick, when events within it matter

// [1] weight of the old value in a first-order low-pass.
double memory(double cutoff, double period) { return cutoff > 0 ? std::exp(-2 * units::kPi * cutoff * period) : 0; }

void require_finite(const Wrench& wrench, double time) {
  if (wrench.force.allFinite() && wrench.torque.allFinite()) return;
  throw Error("the wrench at " + format_number(time) +
              " s of the closed loop is not finite; a force model must return finite numbers.");
}

Vec3 shortened(const Vec3& v, double max_length) {
  const double length = v.norm();
  return length > max_length ? Vec3(v * (max_length / length)) : v;
}

}  // namespace

Wrench LinearWall::operator()(const DeviceState& state) {
  const double penetration = height - state.X_BS.translation.z();
  const double elapsed = state.time - last_time_;
  if (started_ && elapsed > 0) {
    const double a = memory(filter, elapsed);
    speed_ = a * speed_ + (1 - a) * (penetration - last_) / elapsed;
  }
  started_ = true;
  last_ = penetration;
  last_time_ = state.time;
  Wrench wrench;
  if (one_sided && penetration <= 0) return wrench;
  const double force = stiffness * penetration + damping * speed_;
  wrench.force.z() = one_sided ? std::max(0.0, force) : force;
  return wrench;
}

ClosedLoop::ClosedLoop(const ClosedLoopConfig& config)
    : config_(config),
      plant_(config.device, config.hand,
             {config.period, config.period / kFineSteps, config.dry_friction, config.encoder, config.rotation}) {
  require_between(config.delay, 0, kMaxDelay, "ClosedLoopConfig::delay [ticks]");
  require_not_negative(config.velocity_filter, "ClosedLoopConfig::velocity_filter [Hz]");
  reset({});
}

void ClosedLoop::reset(const Pose& X_BS) {
  plant_.reset(X_BS);
  delayed_.fill({});
  next_ = 0;
  applied_ = written_ = {};
  state_ = {};
  smooth_velocity_ = {};
  started_ = false;
  time_ = generated_energy_ = device_dissipation_ = 0;
}

const DeviceState& ClosedLoop::read() {
  const Pose X_BS = plant_.measured_pose();
  if (started_) {
    const Twist raw = twist_between(X_BS_read_, X_BS, config_.period);
    const double a = memory(config_.velocity_filter, config_.period);
    smooth_velocity_.linear = a * smooth_velocity_.linear + (1 - a) * raw.linear;
    smooth_velocity_.angular = a * smooth_velocity_.angular + (1 - a) * raw.angular;
  }
  started_ = true;
  X_BS_read_ = X_BS;
  state_.X_BS = X_BS;
  state_.velocity = smooth_velocity_;
  state_.time = time_;
  ++state_.sequence;
  return state_;
}

void ClosedLoop::apply(const Wrench& wrench) {
  applied_ = wrench;
  if (config_.saturation) {
    applied_.force = shortened(applied_.force, config_.device.peak_force);
    applied_.torque = rendered_torque(config_.device, X_BS_read_.rotation.col(2), applied_.torque);
  }
  if (config_.delay == 0) return;
  std::swap(applied_, delayed_[std::size_t(next_)]);
  next_ = (next_ + 1) % config_.delay;
}

void ClosedLoop::write(const Wrench& wrench) {
  require_finite(wrench, time_);
  apply(written_ = wrench);
  advance([this] { plant_.advance(applied_); });
}

void ClosedLoop::write(const Wrench& wrench, const std::function<void(const Plant&, const Wrench& applied)>& observer) {
  if (!observer) return write(wrench);
  require_finite(wrench, time_);
  apply(written_ = wrench);
  advance([&] {
    for (int n = 0; n < kFineSteps; ++n) {
      plant_.advance_fine(applied_);
      observer(plant_, applied_);
    }
  });
}

void ClosedLoop::miss_tick(double scale) {
  require_between(scale, 0, 1, "the scale of the last wrench");
  apply({scale * written_.force, scale * written_.torque});
  advance([this] { plant_.advance(applied_); });
}

void ClosedLoop::tick(const ForceModel& model) {
  if (!model) throw Error("ClosedLoop::tick"_name + " needs a force model, but none was given.");
  write(model(read()));
}

template <typename Motion>
void ClosedLoop::advance(const Motion& motion) {
  const Pose before = plant_.pose();
  const Vec3 v_before = plant_.velocity().linear;
  motion();
  const Pose after = plant_.pose();
  const Vec3 v_after = plant_.velocity().linear;
  generated_energy_ += applied_.force.dot(after.translation - before.translation) +
                       applied_.torque.dot(vector_from_rotation(after.rotation * before.rotation.transpose()));
  // Simpson's rule over a tick in which the velocity is nearly linear.
  const Vec3 v_mid = (v_before + v_after) / 2;
  device_dissipation_ += config_.device.damping * config_.period / 6 *
                         (v_before.squaredNorm() + 4 * v_mid.squaredNorm() + v_after.squaredNorm());
  time_ += config_.period;
}

}  // namespace hapticut
