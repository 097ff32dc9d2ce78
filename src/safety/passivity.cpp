// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/passivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/effects/output_limits.hpp"

namespace hapticut {
namespace {

constexpr double kMaxStillTime = 0.02;   // [s] motion of the hand that one step of the encoders may stand for
constexpr double kMeanTime = 0.01;       // [s] and
constexpr double kMeanPath = 0.5e-3;     // [m] over which the hand's velocity is averaged
constexpr double kPayTime = 0.02;        // [s] time in which a debt is paid back
constexpr double kGentleChange = 0.018;  // [N] per tick, which a hand does not feel
constexpr double kGentleSpeed = 0.15;    // [m/s] up to which it would feel more

constexpr double kSlopeTime = 0.005;    // [s] over which the change of the force is averaged
constexpr double kSmoothChange = 0.05;  // [N] per tick, up to which a force is smooth
constexpr double kAlong = 4;            // [1] times the change of a force beyond that, which hides another change

constexpr double kStrikeTime = 0.1;    // [s] after a touch, in which a wall may act on a hand
constexpr double kStrikeSpeed = 0.07;  // [m/s] minimum speed of the hand
constexpr double kStrikeShare = 0.8;   // [1] minimum stiffness of that wall over the device's
constexpr double kStrikes = std::numeric_limits<double>::infinity();  // [1] roughness of its force

/// [1] How far beyond that of a smooth force a change per tick is.
double roughness(double change) { return kAlong * std::max(0.0, change / kSmoothChange - 1); }

/// [N] per tick
double gentle_change_at(double speed) {
  const double fast = std::max(1.0, speed / kGentleSpeed), cube = fast * fast * fast;
  return kGentleChange * cube * cube;
}

/// [1] The largest share of a change that can come on top of another within a length, which is not below the other's.
double share_within(const Eigen::Matrix<double, 6, 1>& other, const Eigen::Matrix<double, 6, 1>& added, double length) {
  const double a = added.squaredNorm(), b = other.dot(added), c = other.squaredNorm() - length * length;
  if (a + 2 * b + c <= 0) return 1;
  return std::clamp((std::sqrt(std::max(0.0, b * b - a * c)) - b) / a, 0.0, 1.0);
}

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
  stored_ = damping_force_ = commanded_ = motor_work_ = stands_ = touched_ = rough_ = 0;
  time_ = kMeanTime;  // at rest
  path_.setZero();
  velocity_.setZero();
  reduction_.setZero();
  damping_.setZero();
  last_contact_.setZero();
  slope_.setZero();
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

/// [N] The contact's share of what the device applied since the last tick, after the delay.
PassivityController::Vector6 PassivityController::contact_that_acted(const Tick& tick) noexcept {
  Vector6 acted = compared(tick.applied);
  const double applied = acted.norm();
  acted -= (applied < commanded_ ? applied / commanded_ : 1.0) * effects_;
  commanded_ = compared(tick.commanded).norm();
  effects_ = compared(tick.effects);
  if (options_.delay > 0) {
    std::swap(acted, delayed_[std::size_t(next_)]);
    next_ = (next_ + 1) % options_.delay;
  }
  return acted;
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

// Mean velocity of the hand and mean power of the motor; over the less, the faster the force changes; the present
// ones where the hand strikes a wall.
void PassivityController::follow(const Vector6& motion, double motor, const Vector6& of_contact, double dt) noexcept {
  const double moved = motion.norm();
  stands_ = moved > 0 ? 0 : stands_ + dt;
  const Vector6 change = of_contact - last_contact_;
  slope_ += std::min(1.0, dt / kSlopeTime) * (change / dt - slope_);
  touched_ = of_contact.norm() < options_.free ? 0 : touched_ + dt;
  const double speed = moved / dt;
  const bool strikes =
      touched_ < kStrikeTime && speed > kStrikeSpeed && slope_.norm() > kStrikeShare * options_.stiffness * speed;
  rough_ = strikes ? kStrikes : roughness(std::min(change.norm(), slope_.norm() * dt));
  const double kept = 1 / (1 + (1 + rough_) * (dt / kMeanTime + moved / kMeanPath));
  path_ = kept * path_ + motion;
  motor_work_ = kept * motor_work_ + motor;
  time_ = kept * time_ + dt;
  velocity_ = path_ / time_;
}

void PassivityController::change_towards(const Vector6& reduction, const Vector6& damping,
                                         const Vector6& of_contact) noexcept {
  const double speed = velocity_.norm();
  const Vector6 less = reduction - reduction_, more = damping - damping_;
  const Vector6 of_force = of_contact - last_contact_;
  last_contact_ = of_contact;
  const double change = (less + more).norm(), gentle = gentle_change_at(speed);
  const double max_change = gentle + rough_ * kSmoothChange;
  double share = change > max_change ? max_change / change : 1.0;
  if (rough_ < kStrikes) share *= share_within(of_force, share * (less + more), of_force.norm() + gentle);
  reduction_ += share * less;
  damping_ += share * more;

  // The push may have become smaller than its reduction.
  const double square = reduction_.squaredNorm(), push = -of_contact.dot(reduction_);
  if (push < square) reduction_ *= std::max(0.0, push) / square;
  // A damping never pushes the hand on.
  const double on = damping_.dot(velocity_);
  if (on > 0) damping_ -= on / (speed * speed) * velocity_;
  const double most = options_.max_damping * speed, damped = damping_.norm();
  if (damped > most) damping_ *= most / damped;
}

Wrench PassivityController::control(const Tick& tick) noexcept {
  damping_force_ = 0;
  if (!options_.enabled) return tick.commanded;
  Vector6 motion;
  motion << tick.motion, lever_ * tick.rotation;
  const Vector6 of_contact = compared(tick.commanded) - compared(tick.effects);
  const Vector6 acted = contact_that_acted(tick);
  const double motor = tick.motor.value_or(0);
  double work = work_of(acted, motion, tick.dt);
  if (tick.motor && !tick.in_air) work = std::max(work, acted.dot(motion));
  follow(motion, motor, of_contact, tick.dt);

  const bool free = of_contact.norm() < options_.free;
  const double held_stiffness = (0.5 + options_.delay) * options_.stiffness;
  const double max_stored = std::min(options_.credit, tick.stored.value_or(options_.credit));
  stored_ = free ? 0 : std::min(stored_ - work + held_stiffness * motion.squaredNorm() + motor, max_stored);

  Vector6 reduction = Vector6::Zero(), damping = Vector6::Zero();
  const double speed = velocity_.norm();
  if (!free && speed >= options_.min_speed && stands_ < kMaxStillTime) {
    const double pay_time = std::max(tick.dt, kPayTime / (1 + rough_));
    const double left = stored_ + options_.allowance;
    if (left < 0)
      damping = -std::min({-left / (pay_time * speed), max_force_, options_.max_damping * speed}) / speed * velocity_;
    if (tick.motor) {
      const double covered =
          motor_work_ / time_ + std::max(0.0, left) / pay_time + held_stiffness * speed * speed * tick.dt;
      reduction = -std::max(0.0, of_contact.dot(velocity_) - covered) / (speed * speed) * velocity_;
    }
  }
  change_towards(reduction, damping, of_contact);
  const Vector6 added = reduction_ + damping_;
  damping_force_ = added.norm();
  const Vec3 torque = lever_ * added.tail<3>();
  return {tick.commanded.force + added.head<3>(), tick.commanded.torque + saturated(torque, max_torque_)};
}

}  // namespace hapticut
