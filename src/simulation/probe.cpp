// SPDX-License-Identifier: Apache-2.0
// The force and the stiffness of the contact that a step would meet, without taking the step.
#include <Eigen/Eigenvalues>

#include "simulation/simulation_state.hpp"

namespace hapticut {

ContactProbe Simulation::probe(const Pose& X_WH, const Twist& V_WH, double dt, ProbedMotions motions) const noexcept {
  State& s = *state_;  // uses its buffers for the contact; nothing that a step depends on changes
  if (check_input(s.config, X_WH, V_WH, dt) != StepStatus::ok) return {};
  // A step would place the tool again, without the springs of the old place.
  const bool continues = s.motion.is_placed() && !(s.hand.released && s.is_placed_elsewhere(X_WH, V_WH, dt));
  const Pose from = continues ? s.motion.X_WH() : advance(X_WH, V_WH, -dt);
  const Springs springs = continues ? s.springs : Springs{};
  const HandlePath path = {from, twist_between(from, X_WH, dt), V_WH, dt, s.sweep_between(from, X_WH)};
  if (path.sweep.sub_steps > s.config.max_sweep) return {};
  const StageTimes times = s.times;
  ContactProbe probed = s.probe_path(path, springs);
  const int axes = motions == ProbedMotions::none ? 0 : motions == ProbedMotions::translations ? 3 : 6;
  if (!s.contact_stages.knows_stiffness() && probed.contact.voxels > 0 && axes > 0) {
    probed.stiffness = s.measure_stiffness(path, X_WH, springs, axes, probed.wrench);
    probed.evaluations += axes;
  }
  s.times = times;
  return probed;
}

bool Simulation::touches(const Pose& X_WH) const noexcept {
  return check_input(state_->config, X_WH, {}, state_->config.min_dt) == StepStatus::ok && state_->touches(X_WH);
}

bool Simulation::is_in_material(const Pose& X_WH) const noexcept {
  return check_input(state_->config, X_WH, {}, state_->config.min_dt) == StepStatus::ok && state_->is_in_material(X_WH);
}

bool Simulation::State::is_in_material(const Pose& X_WH) noexcept {
  constexpr double kResting = 0.2;  // [voxels]
  return touches(X_WH, kResting * workpiece.voxel_size());
}

/// Whether the head would touch material with the handle at a pose, deeper than a depth [m].
bool Simulation::State::touches(const Pose& X_WH, double deeper_than) noexcept {
  const HeadPlacement at = plan_sub_step({X_WH, {}, {}, config.min_dt, {}}, 0).head;
  const Resultant resultant = contact_stages.probe(contact_stages.find_blocks(at), at).resultant;
  return resultant.voxels > 0 && resultant.depth >= deeper_than;
}

/// The contact on a path.
ContactProbe Simulation::State::probe_path(const HandlePath& path, Springs acting) noexcept {
  ContactProbe probed;
  take_sub_steps(path, acting, &probed);
  return probed;
}

/// The stiffness for a law that reports none, by a small motion along each axis; its symmetric, positive semidefinite
/// part. The moved paths have the sub-steps of the original path.
Stiffness Simulation::State::measure_stiffness(const HandlePath& path, const Pose& to, const Springs& acting, int axes,
                                               const Wrench& felt) noexcept {
  constexpr double kShift = 0.01;  // [voxels]; the forces are sums of single-precision numbers
  const double reach = tool.head().reach() + tool.X_HT().translation.norm(), shift = kShift * workpiece.voxel_size();
  Stiffness scaled = Stiffness::Zero();  // a rotation counts as the shift of the farthest point
  for (int axis = 0; axis < axes; ++axis) {
    Pose moved = to;
    HandlePath shifted = path;
    const Vec3 along = Vec3::Unit(axis % 3);
    if (axis < 3) {
      moved.translation += shift * along;
      shifted.felt.linear += shift / path.dt * along;
    } else {
      moved.rotation = rotation_from_vector(Vec3(shift / reach * along)) * to.rotation;
      shifted.felt.angular += shift / reach / path.dt * along;
    }
    shifted.twist = twist_between(path.from, moved, path.dt);
    const Wrench there = probe_path(shifted, acting).wrench;
    scaled.col(axis) << (felt.force - there.force) / shift, (felt.torque - there.torque) / (shift * reach);
  }
  if (axes == 3) scaled.bottomRows<3>().setZero();
  const Stiffness symmetric = 0.5 * (scaled + scaled.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> modes(symmetric);
  const Stiffness bounded =
      modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() * modes.eigenvectors().transpose();
  Eigen::Matrix<double, 6, 1> scale;
  scale << 1, 1, 1, reach, reach, reach;
  return scale.asDiagonal() * bounded * scale.asDiagonal();
}

void add_to(ContactProbe& probe, const SubStep& sub_step, const Encounter& encounter, const Springs& acting) noexcept {
  const Mat3& R_WT = sub_step.X_WT.rotation;
  Stiffness stiffness_T = encounter.stiffness_T;
  const Vec3 along = R_WT.transpose() * acting.deep.normal();
  stiffness_T.topLeftCorner<3, 3>() += acting.deep.stiffness() * along * along.transpose();
  // While it slides, friction grows with the normal forces, as if their distribution did not change.
  const LimitSurface::Reaction& reaction = encounter.dry_friction;
  const Vec3& push_T = encounter.resultant.push_T;
  if (const double push = push_T.norm(); acting.anchor.sliding() && push > 0) {
    Eigen::Matrix<double, 6, 1> friction_T;
    friction_T << R_WT.transpose() * reaction.wrench.force, R_WT.transpose() * reaction.wrench.torque;
    const Eigen::Matrix<double, 1, 6> normal_growth = push_T.transpose() / (push * push) * stiffness_T.topRows<3>();
    stiffness_T += friction_T * normal_growth;
  }
  stiffness_T += transport(reaction.stiffness, R_WT.transpose(), Vec3::Zero());

  const double weight = sub_step.weight;
  const Wrench wrench = sub_step.at_handle(encounter.resultant.wrench_T);
  probe.wrench.force += weight * wrench.force;
  probe.wrench.torque += weight * wrench.torque;
  probe.stiffness += weight * sub_step.end * transport(stiffness_T, R_WT, sub_step.p_HoTo_W());
  probe.sliding = acting.anchor.sliding();
}

}  // namespace hapticut
