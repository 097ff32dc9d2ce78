// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/passivity.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kFaster = 1.25;        // [1] speed that the hand may reach in the next tick, over its speed now
constexpr double kMaxStillTime = 0.02;  // [s] of hand motion that one step of the encoders may stand for

}  // namespace

PassivityController::PassivityController(const PassivityOptions& options, double max_force, double lever,
                                         double max_torque)
    : options_(options),
      max_force_(options.max_force > 0 ? options.max_force : max_force),
      lever_(lever),
      max_torque_(max_torque) {
  require_fields_within(options, "PassivityOptions::");
  if (options_.credit == 0) options_.credit = std::numeric_limits<double>::infinity();
  if (options_.max_damping == 0) options_.max_damping = std::numeric_limits<double>::infinity();
  restart();
}

void PassivityController::restart() noexcept {
  stored_ = damping_force_ = commanded_ = 0;
  effects_.setZero();
  mean_.setZero();
  still_.setZero();
  next_ = 0;
  delayed_.fill(Vector6::Zero());
}

PassivityController::Vector6 PassivityController::compared(const Wrench& wrench) const noexcept {
  Vector6 all = Vector6::Zero();
  all.head<3>() = wrench.force;
  if (lever_ > 0) all.tail<3>() = wrench.torque / lever_;
  return all;
}

/// [J] that the hand gets from `acted`
double PassivityController::work_of(const Vector6& acted, const Vector6& motion, double dt) noexcept {
  const double max_still = std::max(1.0, kMaxStillTime / dt);
  double work = 0;
  for (int axis = 0; axis < 6; ++axis) {
    still_[axis] = std::min(still_[axis] + 1, max_still);
    mean_[axis] += (acted[axis] - mean_[axis]) / still_[axis];
    if (motion[axis] == 0) continue;
    work += mean_[axis] * motion[axis];
    still_[axis] = 0;
  }
  return work;
}

Wrench PassivityController::control(const Tick& tick) noexcept {
  damping_force_ = 0;
  if (!options_.enabled) return tick.commanded;
  Vector6 acted = compared(tick.applied), motion = Vector6::Zero();
  const double applied = acted.norm();
  acted -= (applied < commanded_ ? applied / commanded_ : 1.0) * effects_;
  commanded_ = compared(tick.commanded).norm();
  effects_ = compared(tick.effects);
  const Vector6 of_contact = compared(tick.commanded) - effects_;
  motion << tick.motion, lever_ * tick.rotation;
  if (options_.delay > 0) {
    std::swap(acted, delayed_[std::size_t(next_)]);
    next_ = (next_ + 1) % options_.delay;
  }
  double work = work_of(acted, motion, tick.dt);
  if (tick.motor && !tick.in_air) work = std::max(work, acted.dot(motion));
  if (of_contact.norm() < options_.free) {
    stored_ = 0;
    return tick.commanded;
  }
  const double moved = motion.norm(), speed = moved / tick.dt;
  const double held = (0.5 + options_.delay) * options_.stiffness * moved * moved;
  const double max_stored = std::min(options_.credit, tick.stored.value_or(options_.credit));
  stored_ = std::min(stored_ - work + held + tick.motor.value_or(0), max_stored);

  if (speed < options_.min_speed) return tick.commanded;
  const double left = stored_ + options_.allowance;
  if (left < 0) damping_force_ = std::min({-left / moved, max_force_, options_.max_damping * speed});
  if (tick.motor) {
    const double work_ahead = kFaster * of_contact.dot(motion);  // [J] in the next tick
    damping_force_ += std::max(0.0, (work_ahead - std::max(0.0, left) - held) / (kFaster * moved));
  }
  const double along = damping_force_ / moved, torque = lever_ * lever_ * along * tick.rotation.norm();
  const double reduction = torque > max_torque_ ? max_torque_ / torque : 1.0;
  return {tick.commanded.force - along * tick.motion,
          tick.commanded.torque - reduction * lever_ * lever_ * along * tick.rotation};
}

}  // namespace hapticut
