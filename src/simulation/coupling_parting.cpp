// SPDX-License-Identifier: Apache-2.0
// When the tool of a coupling is parted from its hand, and when it goes with it again.
#include <algorithm>
#include <numbers>

#include "hapticut/simulation/coupling.hpp"
#include "simulation/hand_motion.hpp"

namespace hapticut {

namespace {

constexpr double kMaxRotation = 0.9 * std::numbers::pi;  // [rad] of a hand against its tool

}  // namespace

/// The hand takes the tool: it brought it to its speed before, and stretched the spring.
void VirtualCoupling::begin_grip(const Pose& pose, const Twist& velocity, double dt) noexcept {
  X_WD_ = advance(pose, velocity, -dt);
  result_.energy = {};
  result_.energy.kinetic = kinetic_energy(result_.V_WH);
  result_.energy.spring = spring_energy(pull(result_.X_WH, result_.V_WH, X_WD_, velocity));
  result_.energy.hand_work = result_.energy.turnover = result_.energy.kinetic + result_.energy.spring;
  simulation_->release_hand();
}

/// What the tool is in after an exchange, it has not cut its way into.
void VirtualCoupling::part_after_exchange() noexcept {
  if (!simulation_->starts_afresh() || (!held_ && simulation_->steps() == 0)) return;
  waits_ = true;
  rejoin_ = Rejoin::free;
}

void VirtualCoupling::Way::add(const Twist& velocity, double dt) noexcept {
  constexpr double kMemory = 0.1;  // [s]
  const double kept = std::max(0.0, 1 - dt / kMemory);
  linear = kept * linear + velocity.linear.norm() * dt;
  angular = kept * angular + velocity.angular.norm() * dt;
  time = kept * time + dt;
}

/// Whether the velocities say what the poses do. An estimate of a device lags and is noisy, but it does not say many
/// times the way, as a velocity in mm/s or in degrees does, with which the damper would push the tool.
bool VirtualCoupling::velocity_fits(const Pose& pose, const Twist& velocity, double dt) noexcept {
  constexpr double kTold = 30;                              // [1] times the way of the poses
  constexpr double kNoiseLinear = 0.2, kNoiseAngular = 20;  // [m/s], [rad/s] that an estimate may say of a hand at rest
  if (given_) by_pose_.add(twist_between(*given_, pose, dt), dt);
  if (given_) by_velocity_.add(velocity, dt);
  given_ = pose;
  return by_velocity_.linear <= kNoiseLinear * by_velocity_.time + kTold * by_pose_.linear &&
         by_velocity_.angular <= kNoiseAngular * by_velocity_.time + kTold * by_pose_.angular;
}

/// Whether no motion of a hand leads to a pose from the last one.
bool VirtualCoupling::is_jump(const Pose& pose, double dt) const noexcept {
  return !is_path_of_a_hand(X_WD_, pose, dt) || !is_rotation_of_a_hand(X_WD_, pose, dt);
}

/// Whether the hand has turned so far from the tool that with a little more the torque would have the other sign.
bool VirtualCoupling::is_rotated_away(const Pose& pose) const noexcept {
  return turns() && rotated_beyond(result_.X_WH, pose, kMaxRotation);
}

/// Whether the hand is about where it was when the tool was left.
bool VirtualCoupling::is_near(const Pose& pose) const noexcept {
  return (pose.translation - X_WD_.translation).norm() + rotation_between(X_WD_, pose) * reach() <= kNear;
}

/// Whether a tool that waits may be pulled after its hand from where it is.
bool VirtualCoupling::may_continue_from_here(const Pose& pose) const noexcept {
  return held_ && is_near(pose) && !is_rotated_away(pose) &&
         (rejoin_ == Rejoin::near || !simulation_->touches(result_.X_WH));
}

/// [m] of the farthest point of the head from the handle
double VirtualCoupling::reach() const noexcept {
  return simulation_->tool().head().reach() + simulation_->tool().X_HT().translation.norm();
}

void VirtualCoupling::park(Rejoin rejoin) noexcept {
  begin_tick();
  if (rejoin == Rejoin::free) rejoin_ = rejoin;
  wait(StepStatus::ok);
}

/// Nothing is given to the hand, and the tool stays.
const CoupledResult& VirtualCoupling::wait(StepStatus status) noexcept {
  waits_ = true;
  simulation_->release_hand();
  result_.hand = result_.coupling = {};
  result_.V_WH = {};
  result_.status |= status;
  return result_;
}

}  // namespace hapticut
