// SPDX-License-Identifier: Apache-2.0
#include "simulation/newton_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

namespace hapticut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The search ends when a correction moves no point of the head farther than kSolved; or, after one more correction,
// when the residual is small: below kNearBalance at first, below kFarBalance after kPatient steps or without progress.
constexpr double kNearBalance = 2e-4;   // [N] absolute part
constexpr double kNearFraction = 2e-4;  // [1] part of the maximum force
constexpr int kPatient = 6;
// A fraction of a correction must reduce the residual by at least this part of it, or a smaller fraction is tried.
constexpr double kMinDescent = 1e-4;                // [1]
constexpr double kMinFraction = 0.01, kHalf = 0.5;  // [1] of the fraction before
constexpr int kMaxTries = 6;
constexpr double kSmallMotion = 1e-4;  // [voxels] by which a slope is measured

}  // namespace

VirtualCoupling::NewtonSearch::NewtonSearch(VirtualCoupling& coupling, const Part& part, const Twist& hand)
    : coupling_(coupling),
      part_(part),
      hand_(hand),
      lever_(coupling.reach()),
      left_(coupling.gains_.newton_steps - coupling.result_.newton_steps - kMinSteps * part.left) {}

Twist VirtualCoupling::NewtonSearch::find() noexcept {
  const Twist before = coupling_.result_.V_WH;
  Twist tool = before, from = before, best_tool = before;
  if (!coupling_.has_torque()) tool.angular = twist_between(coupling_.result_.X_WH, part_.X_WD, part_.dt).angular;
  const double solved = kSolved * coupling_.simulation_->workpiece().voxel_size() / part_.dt;  // [m/s]
  Vector6 correction = Vector6::Zero();
  double fraction = 1, residual_before = kInfinity;  // [1] of the correction, [N]
  Residual best;
  best.size = kInfinity;
  bool slid = false, from_rest = false, is_measured = false, from_air = false;
  int tries = 0;

  for (int n = 0; left_ > 0; ++n) {
    Residual residual = residual_at(tool);
    if (residual.size < best.size) best = residual, best_tool = tool;
    const bool gains = residual.size <= (1 - kMinDescent * fraction) * residual_before;
    if (!gains && ++tries <= kMaxTries) {
      const double onward = residual.of.dot(correction), slope = correction.dot(residual.slope * correction);
      const double of_fraction = onward < 0 && slope > 0 ? 1 + onward / (slope * fraction) : 0;
      fraction *= of_fraction > kMinFraction ? std::min(of_fraction, kHalf) : kHalf;
      tool = moved(from, fraction * correction);
      continue;
    }
    if (!gains) {
      if (best.size < kFarBalance + kFarFraction * best.max_force || left_ < 6) return best_tool;
      if (is_measured) {
        if (std::exchange(from_air, true)) return best_tool;
        is_measured = false;
        tool = without_contact(best_tool, best);
        correction.setZero();
        residual_before = kInfinity;
        continue;
      }
      is_measured = true;
      tool = best_tool, residual = best;
      residual.slope = measure_slope(tool, residual);
    } else {
      is_measured = false;
    }
    const Vector6 last = correction;
    correction = correct(residual);
    if (gains && slid && residual.sliding && !from_rest &&
        correction.head<3>().dot(last.head<3>()) < -0.5 * last.head<3>().squaredNorm()) {
      // It alternates between sliding to and fro: the head sticks or nearly sticks, which is found from rest.
      from_rest = true;
      tool.linear.setZero();
      if (coupling_.has_torque()) tool.angular.setZero();
      correction.setZero();
      residual_before = kInfinity;
      continue;
    }
    from = tool, residual_before = residual.size, slid = residual.sliding;
    fraction = 1, tries = 0;
    tool = moved(from, correction);
    const double balance = n < kPatient ? kNearBalance + kNearFraction * residual.max_force
                                        : kFarBalance + kFarFraction * residual.max_force;
    if (speed_of(correction) < solved || residual.size < balance) return tool;
  }
  return best_tool;
}

VirtualCoupling::NewtonSearch::Residual VirtualCoupling::NewtonSearch::residual_at(const Twist& tool) noexcept {
  const CouplingGains& gains = coupling_.gains_;
  const Twist& before = coupling_.result_.V_WH;
  const double dt = part_.dt;
  --left_;
  ++coupling_.result_.newton_steps;
  Pose X_WH = advance(coupling_.result_.X_WH, tool, dt);
  if (!coupling_.has_torque()) X_WH.rotation = part_.X_WD.rotation;
  const ContactProbe contact = coupling_.simulation_->probe(
      X_WH, tool, dt, coupling_.has_torque() ? ProbedMotions::all : ProbedMotions::translations);
  const Pull p = coupling_.pull(X_WH, tool, part_.X_WD, hand_);
  Residual residual;
  residual.of << contact.wrench.force + p.wrench.force + p.brake - gains.mass / dt * (tool.linear - before.linear),
      contact.wrench.torque + p.wrench.torque - gains.inertia / dt * (tool.angular - before.angular);
  if (!coupling_.has_torque()) residual.of.tail<3>().setZero();
  residual.size = residual.of.head<3>().norm() + residual.of.tail<3>().norm() / lever_;
  residual.max_force = std::max(contact.wrench.force.norm(), p.wrench.force.norm());
  residual.sliding = contact.sliding;
  residual.of_contact << contact.wrench.force, contact.wrench.torque;
  residual.slope_of_contact = dt * contact.stiffness;
  residual.slope = residual.slope_of_contact;
  residual.slope.topLeftCorner<3, 3>() += (gains.damping + dt * gains.stiffness) * p.linear.slope + p.brake_slope;
  residual.slope.bottomRightCorner<3, 3>() += (gains.angular_damping + dt * gains.angular_stiffness) * p.angular.slope;
  residual.slope.diagonal().head<3>().array() += gains.mass / dt;
  residual.slope.diagonal().tail<3>().array() += gains.inertia / dt;
  return residual;
}

/// Measures the slope by a small motion along each axis.
Stiffness VirtualCoupling::NewtonSearch::measure_slope(const Twist& tool, const Residual& residual) noexcept {
  const double faster = kSmallMotion * coupling_.simulation_->workpiece().voxel_size() / part_.dt;  // [m/s]
  Stiffness slope = residual.slope;
  for (int axis = 0; axis < (coupling_.has_torque() ? 6 : 3); ++axis) {
    Vector6 by = Vector6::Zero();
    by[axis] = axis < 3 ? faster : faster / lever_;
    slope.col(axis) = (residual.of - residual_at(moved(tool, by)).of) / by[axis];
  }
  return slope;
}

VirtualCoupling::NewtonSearch::Vector6 VirtualCoupling::NewtonSearch::correct(const Residual& residual) const noexcept {
  if (coupling_.has_torque()) return residual.slope.partialPivLu().solve(residual.of);
  Vector6 correction = Vector6::Zero();
  correction.head<3>() = Mat3(residual.slope.topLeftCorner<3, 3>()).partialPivLu().solve(Vec3(residual.of.head<3>()));
  return correction;
}

/// The twist in balance if there were no contact.
Twist VirtualCoupling::NewtonSearch::without_contact(const Twist& tool, const Residual& residual) const noexcept {
  Residual rest = residual;
  rest.of -= residual.of_contact;
  rest.slope -= residual.slope_of_contact;
  return moved(tool, correct(rest));
}

Twist VirtualCoupling::NewtonSearch::moved(const Twist& from, const Vector6& by) const noexcept {
  return {from.linear + by.head<3>(), from.angular + by.tail<3>()};
}

/// [m/s] Upper bound on the speed of the farthest point of the head.
double VirtualCoupling::NewtonSearch::speed_of(const Vector6& correction) const noexcept {
  return correction.head<3>().norm() + correction.tail<3>().norm() * lever_;
}

}  // namespace hapticut
