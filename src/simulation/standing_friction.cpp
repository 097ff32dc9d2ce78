// SPDX-License-Identifier: Apache-2.0
// Dry friction of a head that stands, or turns so slowly that the cutting ratio does not describe it alone.
#include <cmath>

#include "hapticut/force/contact_point.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {

void Simulation::State::add_friction(const SubStep& sub_step, Encounter& encounter) noexcept {
  const StageTimer timer = timed(&StageTimes::add_friction);
  const AnchorForce anchored = pull_of_anchor(sub_step, encounter, friction_memory);
  encounter.resultant.wrench_T.force += anchored.wrench_T.force;
  encounter.resultant.wrench_T.torque += anchored.wrench_T.torque;
  result.energy.anchored = friction_memory.anchor.stored();
  result.energy.sliding += anchored.dissipated;
}

/// Moves the anchor with the head.
AnchorForce Simulation::State::pull_of_anchor(const SubStep& sub_step, const Encounter& encounter,
                                              FrictionMemory& memory) noexcept {
  StickSlip& anchor = memory.anchor;
  AnchorForce pull;
  const double share = standing_share(motor.speed(), tool.head().largest_radius());
  const bool touches = share > 0 && encounter.resultant.voxels > 0;
  Wrench normal_T;
  if (touches) normal_T = sub_step.head.motion.spin == 0 ? encounter.resultant.wrench_T : normal_wrench(sub_step);
  if (normal_T.force.isZero(0)) {
    pull.dissipated = anchor.stored();
    anchor.release();
    return pull;
  }
  const Vec3 p_TQ = contact_point(tool.head(), normal_T);
  const Mat3& R_WT = sub_step.X_WT.rotation;
  const Vec3 turning = sub_step.path_T.angular + Vec3(0, 0, motor.speed());
  const Vec3 displacement = (sub_step.path_T.linear + turning.cross(p_TQ)) * sub_step.duration;
  const StickSlip::Outcome outcome =
      anchor.move(R_WT * normal_T.force, R_WT * displacement, friction_at(sub_step.X_WT * p_TQ, memory.touched), share,
                  double(sub_step.head.motion.lead));
  const Vec3 force_T = R_WT.transpose() * outcome.force;
  pull.wrench_T = {force_T, p_TQ.cross(force_T)};
  pull.dissipated = outcome.dissipated;
  pull.stiffness_T = R_WT.transpose() * outcome.stiffness * R_WT;
  pull.p_TQ = p_TQ;
  return pull;
}

/// What the head would feel at this place if it stood, without friction.
Wrench Simulation::State::normal_wrench(const SubStep& sub_step) noexcept {
  HeadPlacement standing = sub_step.head;
  standing.motion.spin = 0;
  standing.motion.removal = RemovalLaw::none;
  const auto blocks = contact_stages.find_blocks(standing);  // again, for some may be gone
  return contact_stages.press_and_cut(blocks, standing, removal).resultant.wrench_T;
}

/// The friction of the material nearest to a point; that of the last one touched where no material is nearby.
const DryFriction& Simulation::State::friction_at(const Vec3& p_WQ, MaterialId& touched) const noexcept {
  if (config.friction) return material_friction[touched];  // the same everywhere
  const Vec3 p_VQ = X_VW * p_WQ / workpiece.voxel_size();
  const VoxelIndex center = {int(std::lround(p_VQ.x())), int(std::lround(p_VQ.y())), int(std::lround(p_VQ.z()))};
  if (const MaterialId id = workpiece.material_at(center); id != kEmpty) {
    touched = id;
    return material_friction[touched];
  }
  double nearest = 9;  // [voxels^2]
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k) {
        const VoxelIndex index = {center[0] + i, center[1] + j, center[2] + k};
        const double distance = (Vec3(index[0], index[1], index[2]) - p_VQ).squaredNorm();
        if (distance >= nearest) continue;
        const MaterialId id = workpiece.material_at(index);
        if (id != kEmpty) touched = id, nearest = distance;
      }
  return material_friction[touched];
}

}  // namespace hapticut
