// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// Finds the twist of a coupled tool at the end of a part of a tick at which all forces are in balance, by Newton's
/// method.
///
/// A correction is shortened until the residual falls: to the point where the residual along it would change its sign,
/// estimated from the slope at its end, or by half. The contact's stiffness, with the drag of the spin in it, is not
/// symmetric; docs/decisions/0005-implicit-coupling.md says when there is one solution. If no part of a correction
/// reduces the residual, the slope is measured by small motions, and the search continues with this slope. If that
/// fails, it starts once more from where the tool would be without a contact, because friction may hold a slender point
/// until it suddenly releases it. On a ridge of the head, where the force of a voxel turns within nanometres from one
/// surface to the next, there is no balance. The search then ends with a residual that is smaller than the force of a
/// voxel.
class VirtualCoupling::NewtonSearch {
 public:
  static constexpr double kSolved = 1e-4;  // [voxels] a smaller correction ends the search
  NewtonSearch(VirtualCoupling& coupling, const Part& part, const Twist& hand);

  /// @realtime no allocation, no lock; at most the newton_steps that are left for this part
  [[nodiscard]] Twist find() noexcept;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

  /// The residual of the balance of forces at a twist.
  struct Residual {
    Vector6 of = Vector6::Zero();  // [N], [N m] force and torque
    double size = 0;               // [N] force, plus torque over lever_
    double max_force = 0;          // [N] of contact and coupling
    Vector6 of_contact = Vector6::Zero();
    Stiffness slope_of_contact = Stiffness::Zero();
    Stiffness slope = Stiffness::Zero();  // [N s/m] ... its decrease with the twist
    bool sliding = false;                 // a standing head slides
  };
  [[nodiscard]] Residual residual_at(const Twist& tool) noexcept;
  [[nodiscard]] Stiffness measure_slope(const Twist& tool, const Residual& residual) noexcept;
  [[nodiscard]] Vector6 correct(const Residual& residual) const noexcept;
  [[nodiscard]] Twist without_contact(const Twist& tool, const Residual& residual) const noexcept;
  [[nodiscard]] Twist moved(const Twist& from, const Vector6& by) const noexcept;
  [[nodiscard]] double speed_of(const Vector6& correction) const noexcept;

  VirtualCoupling& coupling_;
  const Part& part_;
  const Twist& hand_;
  const double lever_;  // [m] of the farthest point of the head
  int left_;            // contacts that may still be evaluated
};

}  // namespace hapticut
