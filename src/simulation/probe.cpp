// SPDX-License-Identifier: Apache-2.0
// The force and the stiffness of the contact that a step would meet, without taking the step.
#include <Eigen/Eigenvalues>

#include "simulation/simulation_state.hpp"

namespace hapticut {

ContactProbe Simulation::probe(const Pose& X_WH, const Twist& V_WH, double dt, ProbedMotions motions) const noexcept {
  State& s = *state_;  // uses its buffers for the contact; nothing that a step depends on changes
  if (check_input(s.config, X_WH, V_WH, dt) != StepStatus::ok) return {};
  const bool continues = s.has_pose && !(s.hand_released_since && s.is_placed_elsewhere(X_WH, V_WH, dt));
  const Pose from = continues ? s.last_X_WH : advance(X_WH, V_WH, -dt);
  const Sweep sweep = s.sweep_between(from, X_WH);
  if (sweep.sub_steps > s.config.max_sweep) return {};
  ContactProbe probed = s.probe_path(from, X_WH, sweep, V_WH, dt);
  const int axes = motions == ProbedMotions::none ? 0 : motions == ProbedMotions::translations ? 3 : 6;
  if (!s.contact_stages.knows_stiffness() && probed.contact.voxels > 0 && axes > 0) {
    probed.stiffness = s.measure_stiffness(from, X_WH, sweep, V_WH, dt, axes, probed.wrench);
    probed.evaluations += axes;
  }
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
  const HeadPlacement at = plan_sub_step(X_WH, config.min_dt, config.min_dt, {}, {}).head;
  const Resultant met = contact_stages.press(contact_stages.find_blocks(at), at).resultant;
  return met.voxels > 0 && met.depth >= deeper_than;
}

/// The contact on the path from one pose to another.
ContactProbe Simulation::State::probe_path(const Pose& from, const Pose& to, const Sweep& sweep, const Twist& V_WH,
                                           double dt) noexcept {
  ContactProbe probed;
  const Twist path = twist_between(from, to, dt);
  DeepContact deep = deep_contact;
  LimitSurface friction = anchor;
  for (int i = 0; i < sweep.sub_steps; ++i) {
    const double weight = sweep.duration(i), moves = sweep.end(i);  // [1] of the step, of the motion of the path's end
    const SubStep sub_step = plan_sub_step(from, moves * dt, weight * dt, path, V_WH);
    const ContactProbe part = probe_sub_step(sub_step, deep, friction);
    probed.wrench.force += weight * part.wrench.force;
    probed.wrench.torque += weight * part.wrench.torque;
    probed.stiffness += weight * moves * part.stiffness;
    probed.contact = part.contact;
    probed.blocks = part.blocks;
    probed.sliding = part.sliding;
  }
  return probed;
}

/// The stiffness for a law that reports none, by a small motion along each axis; its symmetric, positive semidefinite
/// part. The moved paths have the sub-steps of the original path.
Stiffness Simulation::State::measure_stiffness(const Pose& from, const Pose& to, const Sweep& sweep, const Twist& V_WH,
                                               double dt, int axes, const Wrench& felt) noexcept {
  constexpr double kShift = 0.01;  // [voxels]; the forces are sums of single-precision numbers
  const double reach = tool.head().reach() + tool.X_HT().translation.norm(), shift = kShift * workpiece.voxel_size();
  Stiffness scaled = Stiffness::Zero();  // a rotation counts as the shift of the farthest point
  for (int axis = 0; axis < axes; ++axis) {
    Pose moved = to;
    Twist faster = V_WH;
    const Vec3 along = Vec3::Unit(axis % 3);
    if (axis < 3) {
      moved.translation += shift * along;
      faster.linear += shift / dt * along;
    } else {
      moved.rotation = rotation_from_vector(Vec3(shift / reach * along)) * to.rotation;
      faster.angular += shift / reach / dt * along;
    }
    const Wrench there = probe_path(from, moved, sweep, faster, dt).wrench;
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

ContactProbe Simulation::State::probe_sub_step(const SubStep& sub_step, DeepContact& deep,
                                               LimitSurface& friction) noexcept {
  Stiffness stiffness_T;
  const std::span<const FoundBlock> blocks = contact_stages.find_blocks(sub_step.head);
  Encounter encounter = contact_stages.press(blocks, sub_step.head, &stiffness_T);
  Wrench& wrench_T = encounter.resultant.wrench_T;
  const Mat3& R_WT = sub_step.X_WT.rotation;

  wrench_T.force += R_WT.transpose() * hold(sub_step, encounter, deep).force;
  const Vec3 along = R_WT.transpose() * deep.normal();
  stiffness_T.topLeftCorner<3, 3>() += deep.stiffness() * along * along.transpose();

  const LimitSurface::Outcome pull = pull_of_anchor(sub_step, encounter, friction);
  wrench_T.force += R_WT.transpose() * pull.wrench.force;
  wrench_T.torque += R_WT.transpose() * pull.wrench.torque;
  // While it slides, friction grows with the normal forces, as if their distribution did not change.
  const Vec3& push_T = encounter.resultant.push_T;
  if (const double push = push_T.norm(); friction.sliding() && push > 0) {
    Eigen::Matrix<double, 6, 1> friction_T;
    friction_T << R_WT.transpose() * pull.wrench.force, R_WT.transpose() * pull.wrench.torque;
    const Eigen::Matrix<double, 1, 6> normal_growth = push_T.transpose() / (push * push) * stiffness_T.topRows<3>();
    stiffness_T += friction_T * normal_growth;
  }
  stiffness_T += transport(pull.stiffness, R_WT.transpose(), Vec3::Zero());

  const Vec3 p_HoTo_W = sub_step.X_WT.translation - sub_step.X_WH.translation;
  return {transport(Wrench{R_WT * wrench_T.force, R_WT * wrench_T.torque}, p_HoTo_W),
          transport(stiffness_T, R_WT, p_HoTo_W),
          contact_of(sub_step, encounter),
          friction.sliding(),
          1,
          int(blocks.size())};
}

}  // namespace hapticut
