// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/passivity.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kFaster = 1.25;        // [1] times as fast as now the hand may go on
constexpr double kMaxStillTime = 0.02;  // [s] over which a step of the encoders may have been made

}  // namespace

PassivityController::PassivityController(const PassivityOptions& options, double greatest, double lever,
                                         double max_torque)
    : options_(options),
      max_(options.greatest > 0 ? options.greatest : greatest),
      lever_(lever),
      max_torque_(max_torque) {
  require_fields_within(options, "PassivityOptions::");
  if (options_.credit == 0) options_.credit = std::numeric_limits<double>::infinity();
  if (options_.max_damping == 0) options_.max_damping = std::numeric_limits<double>::infinity();
  restart();
}

void PassivityController::restart() noexcept {
  stored_ = taken_ = asked_ = 0;
  effects_.setZero();
  mean_.setZero();
  still_.setZero();
  next_ = 0;
  under_way_.fill(Vector6::Zero());
}

PassivityController::Vector6 PassivityController::compared(const Wrench& wrench) const noexcept {
  Vector6 all = Vector6::Zero();
  all.head<3>() = wrench.force;
  if (lever_ > 0) all.tail<3>() = wrench.torque / lever_;
  return all;
}

/// [J] what acted gives the hand
double PassivityController::work_of(const Vector6& acted, const Vector6& motion, double dt) noexcept {
  const double longest = std::max(1.0, kMaxStillTime / dt);
  double work = 0;
  for (int axis = 0; axis < 6; ++axis) {
    still_[axis] = std::min(still_[axis] + 1, longest);
    mean_[axis] += (acted[axis] - mean_[axis]) / still_[axis];
    if (motion[axis] == 0) continue;
    work += mean_[axis] * motion[axis];
    still_[axis] = 0;
  }
  return work;
}

Wrench PassivityController::control(const Tick& tick) noexcept {
  taken_ = 0;
  if (!options_.enabled) return tick.asked;
  Vector6 acted = compared(tick.applied), motion = Vector6::Zero();
  const double applied = acted.norm();
  acted -= (applied < asked_ ? applied / asked_ : 1.0) * effects_;
  asked_ = compared(tick.asked).norm();
  effects_ = compared(tick.effects);
  const Vector6 of_contact = compared(tick.asked) - effects_;
  motion << tick.motion, lever_ * tick.turn;
  if (options_.delay > 0) {
    std::swap(acted, under_way_[std::size_t(next_)]);
    next_ = (next_ + 1) % options_.delay;
  }
  double work = work_of(acted, motion, tick.dt);
  if (tick.motor && !tick.in_air) work = std::max(work, acted.dot(motion));
  if (of_contact.norm() < options_.free) {
    stored_ = 0;
    return tick.asked;
  }
  const double moved = motion.norm(), speed = moved / tick.dt;
  const double held = (0.5 + options_.delay) * options_.stiffness * moved * moved;
  const double most = std::min(options_.credit, tick.stored.value_or(options_.credit));
  stored_ = std::min(stored_ - work + held + tick.motor.value_or(0), most);

  if (speed < options_.slowest) return tick.asked;
  const double left = stored_ + options_.allowance;
  if (left < 0) taken_ = std::min({-left / moved, max_, options_.max_damping * speed});
  if (tick.motor) {
    const double pushes = kFaster * of_contact.dot(motion);  // [J] in the next tick
    taken_ += std::max(0.0, (pushes - std::max(0.0, left) - held) / (kFaster * moved));
  }
  const double along = taken_ / moved, turning = lever_ * lever_ * along * tick.turn.norm();
  const double share = turning > max_torque_ ? max_torque_ / turning : 1.0;
  return {tick.asked.force - along * tick.motion, tick.asked.torque - share * lever_ * lever_ * along * tick.turn};
}

}  // namespace hapticut
