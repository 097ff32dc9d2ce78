// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/plant.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

enum Row { kTip, kTipSpeed, kHand, kHandSpeed };

constexpr double kFrictionStep = 10e-6;  // [s] maximum
constexpr double kRotationStep = 50e-6;  // [s] maximum; the stiffest gimbal has a period of 3 ms
constexpr double kAtRest = 1e-6;         // [m/s] below which dry friction holds

// The speed after a step under a driving force. Dry friction opposes the motion; it can stop it but not reverse it.
double speed_with_friction(double speed, double drive, double friction, double step, double mass) {
  const bool resting = std::abs(speed) < kAtRest;
  if (resting && std::abs(drive) <= friction) return 0;
  const double direction = (resting ? drive : speed) > 0 ? 1 : -1;
  const double next = speed + step * (drive - friction * direction) / mass;
  return !resting && next * speed < 0 && std::abs(drive) <= friction ? 0 : next;
}

}  // namespace

Plant::Plant(const DeviceModel& device, const HandModel& hand, const PlantOptions& options)
    : device_(device),
      hand_(hand),
      options_(options),
      tip_mass_(device.mass + (hand.pad_stiffness > 0 ? 0 : hand.mass)),
      tip_damping_(device.damping + (hand.pad_stiffness > 0 ? 0 : hand.damping)) {
  require_fields_within(options, "PlantOptions::");
  require_fields_within(device, "DeviceModel::");
  require_fields_within(hand, "HandModel::");
  if (has_pad()) require_positive(hand.mass, "HandModel::mass [kg]");
  tick_ = propagator(options.period);
  fine_ = propagator(options.fine_step);
}

Plant::Propagator Plant::propagator(double step) const {
  // Unknowns: the four rows, then the force and the set point, which are constant during the step.
  Eigen::Matrix<double, 6, 6> rates = Eigen::Matrix<double, 6, 6>::Zero();
  enum Input { kForce = 4, kTarget = 5 };
  rates(kTip, kTipSpeed) = 1;
  rates(kTipSpeed, kForce) = 1 / tip_mass_;
  rates(kTipSpeed, kTipSpeed) = -tip_damping_ / tip_mass_;
  if (has_pad()) {
    const double k = hand_.pad_stiffness, b = hand_.pad_damping;
    rates.row(kTipSpeed).head<4>() += Eigen::RowVector4d(-k, -b, k, b) / tip_mass_;
    rates(kHand, kHandSpeed) = 1;
    rates.row(kHandSpeed) << k, b, -k - hand_.stiffness, -b - hand_.damping, 0, hand_.stiffness;
    rates.row(kHandSpeed) /= hand_.mass;
  } else {
    rates(kTipSpeed, kTip) = -hand_.stiffness / tip_mass_;
    rates(kTipSpeed, kTarget) = hand_.stiffness / tip_mass_;
  }
  const Eigen::Matrix<double, 6, 6> solution = (rates * step).exp();
  return {solution.topLeftCorner<4, 4>(), solution.block<4, 1>(0, kForce), solution.block<4, 1>(0, kTarget)};
}

void Plant::reset(const Pose& X_BS) {
  axes_.setZero();
  axes_.row(kTip) = X_BS.translation.transpose();
  axes_.row(kHand) = X_BS.translation.transpose();
  R_BS_ = X_BS.rotation;
  angular_velocity_.setZero();
  X_BS_target_ = X_BS;
}

void Plant::set_target(const Pose& X_BS) {
  X_BS_target_ = X_BS;
  if (!options_.rotation) R_BS_ = X_BS.rotation;
}

void Plant::set_velocity(const Vec3& velocity) {
  axes_.row(kTipSpeed) = velocity.transpose();
  axes_.row(kHandSpeed) = velocity.transpose();
}

void Plant::advance(const Wrench& wrench) { move(options_.period, tick_, wrench); }

void Plant::advance_fine(const Wrench& wrench) { move(options_.fine_step, fine_, wrench); }

void Plant::move(double duration, const Propagator& propagator, const Wrench& wrench) {
  if (options_.dry_friction)
    translate_with_friction(duration, wrench.force);
  else
    translate(propagator, wrench.force);
  if (options_.rotation) rotate(duration, wrench.torque);
}

void Plant::translate(const Propagator& p, const Vec3& force) {
  const Axes next = p.state * axes_ + p.force * force.transpose() + p.target * X_BS_target_.translation.transpose();
  axes_ = next;
}

void Plant::translate_with_friction(double duration, const Vec3& force) {
  const int steps = int(std::ceil(duration / kFrictionStep - 1e-9));
  const double step = duration / steps;
  for (int axis = 0; axis < 3; ++axis) {
    double x = axes_(kTip, axis), v = axes_(kTipSpeed, axis), hand = axes_(kHand, axis), w = axes_(kHandSpeed, axis);
    const double target = X_BS_target_.translation[axis];
    for (int n = 0; n < steps; ++n) {  // half a drift, kick, half a drift: exact for a constant force
      x += v * step / 2;
      hand += w * step / 2;
      const double pad = hand_.pad_stiffness * (hand - x) + hand_.pad_damping * (w - v);
      const double pull = has_pad() ? pad : hand_.stiffness * (target - x);
      v = speed_with_friction(v, force[axis] + pull - tip_damping_ * v, device_.dry_friction, step, tip_mass_);
      if (has_pad()) w += step * (hand_.stiffness * (target - hand) - hand_.damping * w - pad) / hand_.mass;
      x += v * step / 2;
      hand += w * step / 2;
    }
    axes_.col(axis) << x, v, hand, w;
  }
}

void Plant::rotate(double duration, const Vec3& torque) {
  const int steps = int(std::ceil(duration / kRotationStep - 1e-9));
  const double step = duration / steps;
  const double inertia = device_.rotational_inertia + hand_.inertia;
  const double damping = device_.rotational_damping + hand_.angular_damping;
  for (int n = 0; n < steps; ++n) {
    R_BS_ = rotation_from_vector(angular_velocity_ * step / 2) * R_BS_;
    const Vec3 away = vector_from_rotation(R_BS_ * X_BS_target_.rotation.transpose());
    angular_velocity_ += step / inertia * (torque - hand_.angular_stiffness * away - damping * angular_velocity_);
    R_BS_ = orthonormalized(rotation_from_vector(angular_velocity_ * step / 2) * R_BS_);
  }
}

Pose Plant::pose() const { return {R_BS_, axes_.row(kTip).transpose()}; }

Pose Plant::measured_pose() const {
  Pose X = pose();
  const double q = device_.encoder_step;
  if (options_.encoder && q > 0) X.translation = ((X.translation / q).array() + 0.5).floor().matrix() * q;
  return X;
}

Twist Plant::velocity() const { return {axes_.row(kTipSpeed).transpose(), angular_velocity_}; }

double Plant::kinetic_energy() const {
  const double hand = has_pad() ? hand_.mass * axes_.row(kHandSpeed).squaredNorm() : 0;
  return 0.5 * (tip_mass_ * axes_.row(kTipSpeed).squaredNorm() + hand);
}

}  // namespace hapticut
