// SPDX-License-Identifier: Apache-2.0
// Dry friction of a head that stands, or turns so slowly that the cutting ratio alone does not describe it.
#include "simulation/simulation_state.hpp"

namespace hapticut {

namespace {

/// The contact of a head that may roll about an axis: friction has no torque about it.
Stiffness free_about(const Stiffness& directions, const Vec3& axis) noexcept {
  const Eigen::Matrix<double, 6, 1, Eigen::DontAlign> about = directions.rightCols<3>() * axis;
  const double about_axis = about.tail<3>().dot(axis);
  return about_axis > 0 ? Stiffness(directions - about * about.transpose() / about_axis) : directions;
}

}  // namespace

/// Moves the anchor of dry friction with the head. A stalled head rolls: only the motor holds it.
void Simulation::State::add_friction(const SubStep& sub_step, Encounter& encounter, LimitSurface& anchor) noexcept {
  const StageTimer timer = timed(&StageTimes::add_friction);
  const SpindleMotor& motor = spindle.motor();
  const double fraction = dry_friction_fraction(motor.speed(), tool.head().cutting_radius());
  SpreadFriction contact;  // empty
  if (fraction > 0 && encounter.resultant.voxels > 0)
    contact = sub_step.head.motion.spin == 0 ? encounter.friction_T
                                             : contact_stages.standing_contact(sub_step.head).friction_T;
  const Mat3& R_WT = sub_step.X_WT.rotation;
  contact.directions = transport(contact.directions, R_WT, Vec3::Zero());
  if (motor.stalled()) contact.directions = free_about(contact.directions, R_WT.col(2));
  const Vec3 turning = sub_step.path_T.angular + Vec3(0, 0, motor.speed());
  const Twist displacement = {R_WT * sub_step.path_T.linear * sub_step.duration, R_WT * turning * sub_step.duration};
  encounter.dry_friction = anchor.move(contact, displacement, fraction, double(sub_step.head.motion.lead));
  const Wrench& reaction = encounter.dry_friction.wrench;
  encounter.resultant.wrench_T.force += R_WT.transpose() * reaction.force;
  encounter.resultant.wrench_T.torque += R_WT.transpose() * reaction.torque;
}

}  // namespace hapticut
