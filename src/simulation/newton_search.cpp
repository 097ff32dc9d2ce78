// SPDX-License-Identifier: Apache-2.0
#include "simulation/newton_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

namespace hapticut {
namespace {

// The search ends when a correction moves no point of the head farther than kSolved; or, after one more correction,
// when the residual is small: below kNearBalance at first, below kFarBalance after kPatient steps.
constexpr double kNearBalance = 2e-4;   // [N] absolute part
constexpr double kNearFraction = 2e-4;  // [1] part of the maximum force
constexpr int kPatient = 6;
constexpr double kMinDescent = 1e-4;  // [1] by which a correction must reduce the residual
constexpr double kStuck = 0.1;        // [1] residual of a point that friction holds, over the largest force
constexpr double kLongTick = 1.5e-3;  // [s] from which on two sub-ticks have the time for as many steps as more
constexpr double kAgainst = 3;        // [1]
constexpr double kShorter = 0.7;      // [1] times one that does not, the next one

}  // namespace

VirtualCoupling::NewtonSearch::NewtonSearch(VirtualCoupling& coupling, const SubTick& sub_tick, const Twist& hand)
    : coupling_(coupling),
      sub_tick_(sub_tick),
      hand_(hand),
      before_(coupling.accelerated()),
      lever_(coupling.reach()) {}

Twist VirtualCoupling::NewtonSearch::find() noexcept {
  Twist tool = coupling_.result_.V_WH;
  if (!coupling_.has_torque())
    tool.angular = twist_between(coupling_.result_.X_WH, sub_tick_.X_WD, sub_tick_.dt).angular;
  const double solved = kSolved * coupling_.simulation_->workpiece().voxel_size() / sub_tick_.dt;  // [m/s]
  Residual residual = residual_at(tool);
  Vector6 last = Vector6::Zero();
  double longest = std::numeric_limits<double>::infinity();  // [m/s] correction that is tried
  Twist cheapest = tool;
  double lowest_cost = cost(residual, tool);
  bool gains = true, slid = false, from_rest = false, from_air = false;
  int failed = 0;
  for (int n = 0;; ++n) {
    Vector6 correction = correct(residual);
    const double size = speed_of(correction);
    const double balance = n < kPatient ? kNearBalance + kNearFraction * residual.max_force
                                        : kFarBalance + kFarFraction * residual.max_force;
    if (gains && (size < solved || residual.size < balance)) return moved(tool, correction);
    if (!may_go_on()) return cheapest;
    if (size > longest) correction *= longest / size;
    if (gains && slid && residual.sliding && !from_rest &&
        correction.head<3>().dot(last.head<3>()) < -0.5 * last.head<3>().squaredNorm()) {
      // It alternates between sliding to and fro: the head sticks or nearly sticks, which is found from rest.
      from_rest = true;
      tool.linear.setZero();
      if (coupling_.has_torque()) tool.angular.setZero();
      residual = residual_at(tool);
      continue;
    }
    const Twist tried = moved(tool, correction);
    Residual there = residual_at(tried);
    if (const double of_it = cost(there, tried); of_it < lowest_cost) lowest_cost = of_it, cheapest = tried;
    gains = there.size < (1 - kMinDescent) * residual.size;
    if (gains) {
      if (learned_) {
        learn(residual, correction, there);
        there.slope = there.free_slope + *learned_;
      }
      slid = residual.sliding;
      tool = tried, residual = there, last = correction;
      longest = std::numeric_limits<double>::infinity();
      failed = 0;
    } else {
      learn(residual, correction, there);
      longest = kShorter * speed_of(correction);
      if (++failed < kPatient) continue;
      // Friction may hold a slender point until it suddenly releases it.
      if (residual.size < kStuck * residual.max_force || std::exchange(from_air, true)) continue;
      tool = without_contact(tool, residual);
      residual = residual_at(tool);
      longest = std::numeric_limits<double>::infinity();
      gains = true;
    }
  }
}

/// Whether the steps have not yet taken their time. A fast tick of several sub-ticks, as when the tool strikes, has
/// more. A sub-tick may take twice its equal share of what those before have left.
bool VirtualCoupling::NewtonSearch::may_go_on() const noexcept {
  const int sub_ticks = coupling_.result_.sub_ticks;
  const bool short_pair = sub_ticks == 2 && sub_ticks * sub_tick_.dt < kLongTick;
  const int steps = coupling_.gains_.newton_steps * (sub_ticks == 1 ? 1 : short_pair ? 2 : kFaster);
  const int each = kContactExtra + std::min(voxels_ + kBlockExtra * blocks_, kContactVoxels);
  const int in_tick = steps * (kContactExtra + kContactVoxels) / each;
  const int before = coupling_.evaluated_ - evaluated_;
  return steps_ < kLeastSteps || evaluated_ * (sub_tick_.left + 2) < 2 * (in_tick - before);
}

/// [N] The residual, and more where it acts against the motion: the tool's own energy pays for any other
/// (VirtualCoupling::remainder_of).
double VirtualCoupling::NewtonSearch::cost(const Residual& residual, const Twist& tool) const noexcept {
  Vector6 motion;
  motion << tool.linear, coupling_.has_torque() ? tool.angular : Vec3(Vec3::Zero());
  const double speed = speed_of(motion);
  const double against = speed > 0 ? std::max(0.0, -residual.of.dot(motion)) / speed : 0;
  return residual.size + kAgainst * against;
}

/// Broyden's change of a slope to what a correction has shown.
void VirtualCoupling::NewtonSearch::learn(Residual& from, const Vector6& correction, const Residual& there) noexcept {
  Vector6 measure = correction;  // measure of lengths, also of rotations
  measure.tail<3>() *= lever_ * lever_;
  const Vector6 missed = from.of - there.of - from.slope * correction;
  from.slope += missed * measure.transpose() / correction.dot(measure);
  if (learned_) learned_ = from.slope - from.free_slope;
}

VirtualCoupling::NewtonSearch::Residual VirtualCoupling::NewtonSearch::residual_at(const Twist& tool) noexcept {
  const CouplingGains& gains = coupling_.gains_;
  const double dt = sub_tick_.dt;
  Pose X_WH = advance(coupling_.result_.X_WH, tool, dt);
  if (!coupling_.has_torque()) X_WH.rotation = sub_tick_.X_WD.rotation;
  const ProbedMotions motions = learned_                 ? ProbedMotions::none
                                : coupling_.has_torque() ? ProbedMotions::all
                                                         : ProbedMotions::translations;
  const ContactProbe contact = coupling_.simulation_->probe(X_WH, tool, dt, motions);
  if (contact.evaluations > 1) learned_ = dt * contact.stiffness;
  voxels_ = contact.contact.voxels;
  blocks_ = contact.blocks;
  ++steps_;
  ++coupling_.result_.newton_steps;
  evaluated_ += contact.evaluations;
  coupling_.evaluated_ += contact.evaluations;
  const CouplingForces p = coupling_.forces_at(X_WH, tool, sub_tick_.X_WD, hand_);
  Residual residual;
  residual.of << contact.wrench.force + p.wrench.force + p.brake - gains.mass / dt * (tool.linear - before_.linear),
      contact.wrench.torque + p.wrench.torque - gains.inertia / dt * (tool.angular - before_.angular);
  if (!coupling_.has_torque()) residual.of.tail<3>().setZero();
  residual.size = residual.of.head<3>().norm() + residual.of.tail<3>().norm() / lever_;
  residual.max_force = std::max(contact.wrench.force.norm(), p.wrench.force.norm());
  residual.sliding = contact.sliding;
  residual.free_slope.topLeftCorner<3, 3>() += (gains.damping + dt * gains.stiffness) * p.linear.slope + p.brake_slope;
  residual.free_slope.bottomRightCorner<3, 3>() +=
      (gains.angular_damping + dt * gains.angular_stiffness) * p.angular.slope;
  residual.free_slope.diagonal().head<3>().array() += gains.mass / dt;
  residual.free_slope.diagonal().tail<3>().array() += gains.inertia / dt;
  residual.slope = residual.free_slope + (learned_ && voxels_ > 0 ? *learned_ : dt * contact.stiffness);
  residual.of_contact << contact.wrench.force, contact.wrench.torque;
  return residual;
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
  rest.slope = residual.free_slope;
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
