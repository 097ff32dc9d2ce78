// SPDX-License-Identifier: Apache-2.0
#include "simulation/newton_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

namespace hapticut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The search ends when a correction moves no point of the head farther than kSolved; or after one more when little is
// lacking: kNearBalance at first, kFarBalance after kPatient steps, or where nothing is gained.
constexpr double kNearBalance = 2e-4;  // [N] by itself,
constexpr double kNearShare = 2e-4;    // [1] and of the largest force
constexpr int kPatient = 6;
// A share of a correction must gain so much of it, or a smaller one is tried.
constexpr double kMinDescent = 1e-4;             // [1]
constexpr double kShortest = 0.01, kHalf = 0.5;  // [1] of the share before
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
  Twist tool = before, from = before, nearest = before;
  if (!coupling_.turns()) tool.angular = twist_between(coupling_.result_.X_WH, part_.X_WD, part_.dt).angular;
  const double solved = kSolved * coupling_.simulation_->workpiece().voxel_size() / part_.dt;  // [m/s]
  Vector6 correction = Vector6::Zero();
  double share = 1, lacked = kInfinity;  // [1] of it that is tried, [N] without it
  Lack least;
  least.size = kInfinity;
  bool slid = false, from_rest = false, is_measured = false, from_air = false;
  int tries = 0;

  for (int n = 0; left_ > 0; ++n) {
    Lack lack = lack_at(tool);
    if (lack.size < least.size) least = lack, nearest = tool;
    const bool gains = lack.size <= (1 - kMinDescent * share) * lacked;
    if (!gains && ++tries <= kMaxTries) {
      const double onward = lack.of.dot(correction), slope = correction.dot(lack.slope * correction);
      const double of_it = onward < 0 && slope > 0 ? 1 + onward / (slope * share) : 0;
      share *= of_it > kShortest ? std::min(of_it, kHalf) : kHalf;
      tool = moved(from, share * correction);
      continue;
    }
    if (!gains) {
      if (least.size < kFarBalance + kFarShare * least.largest || left_ < 6) return nearest;
      if (is_measured) {
        if (std::exchange(from_air, true)) return nearest;
        is_measured = false;
        tool = without_contact(nearest, least);
        correction.setZero();
        lacked = kInfinity;
        continue;
      }
      is_measured = true;
      tool = nearest, lack = least;
      lack.slope = measure_slope(tool, lack);
    } else {
      is_measured = false;
    }
    const Vector6 last = correction;
    correction = correct(lack);
    if (gains && slid && lack.sliding && !from_rest &&
        correction.head<3>().dot(last.head<3>()) < -0.5 * last.head<3>().squaredNorm()) {
      // To and fro between sliding one way and the other: the head sticks, or nearly so, and that is found from rest.
      from_rest = true;
      tool.linear.setZero();
      if (coupling_.turns()) tool.angular.setZero();
      correction.setZero();
      lacked = kInfinity;
      continue;
    }
    from = tool, lacked = lack.size, slid = lack.sliding;
    share = 1, tries = 0;
    tool = moved(from, correction);
    const double balance =
        n < kPatient ? kNearBalance + kNearShare * lack.largest : kFarBalance + kFarShare * lack.largest;
    if (way_of(correction) < solved || lack.size < balance) return tool;
  }
  return nearest;
}

VirtualCoupling::NewtonSearch::Lack VirtualCoupling::NewtonSearch::lack_at(const Twist& tool) noexcept {
  const CouplingGains& gains = coupling_.gains_;
  const Twist& before = coupling_.result_.V_WH;
  const double dt = part_.dt;
  --left_;
  ++coupling_.result_.newton_steps;
  Pose X_WH = advance(coupling_.result_.X_WH, tool, dt);
  if (!coupling_.turns()) X_WH.rotation = part_.X_WD.rotation;
  const ContactProbe contact = coupling_.simulation_->probe(
      X_WH, tool, dt, coupling_.turns() ? ProbedMotions::all : ProbedMotions::translations);
  const Pull p = coupling_.pull(X_WH, tool, part_.X_WD, hand_);
  Lack lack;
  lack.of << contact.wrench.force + p.wrench.force + p.brake - gains.mass / dt * (tool.linear - before.linear),
      contact.wrench.torque + p.wrench.torque - gains.inertia / dt * (tool.angular - before.angular);
  if (!coupling_.turns()) lack.of.tail<3>().setZero();
  lack.size = lack.of.head<3>().norm() + lack.of.tail<3>().norm() / lever_;
  lack.largest = std::max(contact.wrench.force.norm(), p.wrench.force.norm());
  lack.sliding = contact.sliding;
  lack.of_contact << contact.wrench.force, contact.wrench.torque;
  lack.slope_of_contact = dt * contact.stiffness;
  lack.slope = lack.slope_of_contact;
  lack.slope.topLeftCorner<3, 3>() += (gains.damping + dt * gains.stiffness) * p.linear.slope + p.brake_slope;
  lack.slope.bottomRightCorner<3, 3>() += (gains.angular_damping + dt * gains.angular_stiffness) * p.angular.slope;
  lack.slope.diagonal().head<3>().array() += gains.mass / dt;
  lack.slope.diagonal().tail<3>().array() += gains.inertia / dt;
  return lack;
}

/// The slope by a small motion along each axis.
Stiffness VirtualCoupling::NewtonSearch::measure_slope(const Twist& tool, const Lack& lack) noexcept {
  const double faster = kSmallMotion * coupling_.simulation_->workpiece().voxel_size() / part_.dt;  // [m/s]
  Stiffness slope = lack.slope;
  for (int axis = 0; axis < (coupling_.turns() ? 6 : 3); ++axis) {
    Vector6 by = Vector6::Zero();
    by[axis] = axis < 3 ? faster : faster / lever_;
    slope.col(axis) = (lack.of - lack_at(moved(tool, by)).of) / by[axis];
  }
  return slope;
}

VirtualCoupling::NewtonSearch::Vector6 VirtualCoupling::NewtonSearch::correct(const Lack& lack) const noexcept {
  if (coupling_.turns()) return lack.slope.partialPivLu().solve(lack.of);
  Vector6 correction = Vector6::Zero();
  correction.head<3>() = Mat3(lack.slope.topLeftCorner<3, 3>()).partialPivLu().solve(Vec3(lack.of.head<3>()));
  return correction;
}

/// The twist in balance if there were no contact.
Twist VirtualCoupling::NewtonSearch::without_contact(const Twist& tool, const Lack& lack) const noexcept {
  Lack rest = lack;
  rest.of -= lack.of_contact;
  rest.slope -= lack.slope_of_contact;
  return moved(tool, correct(rest));
}

Twist VirtualCoupling::NewtonSearch::moved(const Twist& from, const Vector6& by) const noexcept {
  return {from.linear + by.head<3>(), from.angular + by.tail<3>()};
}

/// [m/s] of the farthest point of the head, at most
double VirtualCoupling::NewtonSearch::way_of(const Vector6& correction) const noexcept {
  return correction.head<3>().norm() + correction.tail<3>().norm() * lever_;
}

}  // namespace hapticut
