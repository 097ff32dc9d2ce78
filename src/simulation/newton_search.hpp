// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// The twist of a coupled tool at the end of a part of a tick, with which all forces are in balance, by Newton's
/// method.
///
/// A correction is shortened until less is lacking: to where the forces along it would turn, as far as their slope says
/// at its end, or by half. The contact's stiffness, with the drag of the spin in it, is not symmetric;
/// docs/decisions/0005-implicit-coupling.md says when there is one solution. Where a correction gains nothing, the
/// slope is measured there by small motions, and the search goes on with that; then once more from where the tool would
/// be without a contact: friction may hold a slender point until it lets go of it at once. On a ridge of the head,
/// where the force of a voxel turns within nanometres from one surface to the next, there is no balance: there the
/// search ends, and what lacks is less than a voxel pushes.
class VirtualCoupling::NewtonSearch {
 public:
  static constexpr double kSolved = 1e-4;  // [voxels] a smaller correction ends the search
  NewtonSearch(VirtualCoupling& coupling, const Part& part, const Twist& hand);

  /// @realtime no allocation, no lock; at most the part's share of CouplingGains::newton_steps contacts
  [[nodiscard]] Twist find() noexcept;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

  /// What lacks to the balance with a twist.
  struct Lack {
    Vector6 of = Vector6::Zero();  // [N], [N m] force and torque
    double size = 0;               // [N] with the torque at the farthest point of the head
    double largest = 0;            // [N] of contact and coupling
    Vector6 of_contact = Vector6::Zero();
    Stiffness slope_of_contact = Stiffness::Zero();
    Stiffness slope = Stiffness::Zero();  // [N s/m] ... how it falls with the twist
    bool sliding = false;                 // a head that stands
  };
  [[nodiscard]] Lack lack_at(const Twist& tool) noexcept;
  [[nodiscard]] Stiffness measure_slope(const Twist& tool, const Lack& lack) noexcept;
  [[nodiscard]] Vector6 correct(const Lack& lack) const noexcept;
  [[nodiscard]] Twist without_contact(const Twist& tool, const Lack& lack) const noexcept;
  [[nodiscard]] Twist moved(const Twist& from, const Vector6& by) const noexcept;
  [[nodiscard]] double way_of(const Vector6& correction) const noexcept;

  VirtualCoupling& coupling_;
  const Part& part_;
  const Twist& hand_;
  const double lever_;  // [m] of the farthest point of the head
  int left_;            // contacts that may be asked for
};

}  // namespace hapticut
