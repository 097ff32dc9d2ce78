// SPDX-License-Identifier: Apache-2.0
// When the tool of a coupling is separated from its hand, and when it rejoins it.
#include <algorithm>
#include <numbers>

#include "hapticut/simulation/coupling.hpp"
#include "simulation/hand_motion.hpp"

namespace hapticut {

namespace {

constexpr double kMaxLag = 0.9 * std::numbers::pi;  // [rad] between hand and tool

}  // namespace

/// The hand takes the tool. The energies of its speed and of the stretched spring count as work of the hand.
void VirtualCoupling::begin_grip(const Pose& X_WD, const Twist& V_WD, double dt) noexcept {
  X_WD_ = advance(X_WD, V_WD, -dt);
  remainder_ = {};
  result_.energy = {};
  result_.energy.kinetic = kinetic_energy(result_.V_WH);
  result_.energy.spring = spring_energy(forces_at(result_.X_WH, result_.V_WH, X_WD_, V_WD));
  result_.energy.hand_work = result_.energy.turnover = result_.energy.kinetic + result_.energy.spring;
  simulation_->release_hand();
}

/// After an exchange the tool waits, because it has not cut its way into the material that it is in.
void VirtualCoupling::separate_after_exchange() noexcept {
  if (!simulation_->next_step_is_first() || (!gripped_ && simulation_->steps() == 0)) return;
  waits_ = true;
  rejoin_ = Rejoin::free;
}

void VirtualCoupling::Distance::add(const Twist& velocity, double dt) noexcept {
  constexpr double kMemory = 0.1;  // [s]
  const double kept = std::max(0.0, 1 - dt / kMemory);
  linear = kept * linear + velocity.linear.norm() * dt;
  angular = kept * angular + velocity.angular.norm() * dt;
  time = kept * time + dt;
}

/// Whether the velocities fit the poses. The estimate of a device lags and is noisy, but it is not many times the
/// velocity of the poses, as a velocity in mm/s or in degrees is. Such a velocity would make the damper push the tool.
bool VirtualCoupling::velocity_fits(const Pose& X_WD, const Twist& V_WD, double dt) noexcept {
  constexpr double kMaxRatio = 30;                          // [1] times the distance of the poses
  constexpr double kNoiseLinear = 0.2, kNoiseAngular = 20;  // [m/s], [rad/s] noise of an estimate for a hand at rest
  if (given_) by_pose_.add(twist_between(*given_, X_WD, dt), dt);
  if (given_) by_velocity_.add(V_WD, dt);
  given_ = X_WD;
  return by_velocity_.linear <= kNoiseLinear * by_velocity_.time + kMaxRatio * by_pose_.linear &&
         by_velocity_.angular <= kNoiseAngular * by_velocity_.time + kMaxRatio * by_pose_.angular;
}

/// Whether two poses are too far from each other for a motion of a hand.
bool VirtualCoupling::is_jump(const Pose& from, const Pose& to, double dt) noexcept {
  return !is_path_of_a_hand(from, to, dt) || !is_rotation_of_a_hand(from, to, dt);
}

/// Whether the hand is rotated so far from the tool that with a little more the torque would change its sign.
bool VirtualCoupling::is_rotated_away(const Pose& X_WD) const noexcept {
  return has_torque() && rotated_beyond(result_.X_WH, X_WD, kMaxLag);
}

/// Whether the hand is near its pose at which the tool was parked.
bool VirtualCoupling::is_near(const Pose& X_WD) const noexcept {
  return (X_WD.translation - X_WD_.translation).norm() + rotation_between(X_WD_, X_WD) * reach() <= kNear;
}

/// Whether a tool that waits may follow its hand from where it is.
bool VirtualCoupling::may_continue_from_here(const Pose& X_WD) const noexcept {
  return gripped_ && is_near(X_WD) && !is_rotated_away(X_WD) &&
         (rejoin_ == Rejoin::near || !simulation_->touches(result_.X_WH));
}

/// [m] Maximum distance of the head's points from the handle.
double VirtualCoupling::reach() const noexcept {
  return simulation_->tool().head().reach() + simulation_->tool().X_HT().translation.norm();
}

void VirtualCoupling::park(Rejoin rejoin) noexcept {
  begin_tick();
  given_.reset();
  if (rejoin == Rejoin::free) rejoin_ = rejoin;
  suspend(StepStatus::ok);
}

/// Gives the hand no force, and keeps the tool where it is.
const CoupledResult& VirtualCoupling::suspend(StepStatus status) noexcept {
  waits_ = true;
  simulation_->release_hand();
  result_.hand = result_.coupling = {};
  result_.V_WH = remainder_ = {};
  result_.status |= status;
  return result_;
}

}  // namespace hapticut
