// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// Finds the twist of a coupled tool at the end of a sub-tick at which all forces are in balance, by Newton's
/// method.
///
/// The slope of a custom law costs several contacts, so it is measured once and then learned from each correction. A
/// correction that does not reduce the residual teaches the slope (Broyden's method), and a shorter one is tried. If
/// this goes on to fail, the search starts once more from where the tool would be without a contact. The contact's
/// stiffness, with the drag of the spin in it, is not symmetric; docs/decisions/0005-implicit-coupling.md says when
/// there is one solution. On a ridge of the head, where the force of a voxel turns within nanometres from one surface
/// to the next, there is none. The search then ends with a residual that is smaller than the force of a voxel.
class VirtualCoupling::NewtonSearch {
 public:
  static constexpr double kSolved = 1e-4;  // [voxels] a smaller correction ends the search
  static constexpr int kLeastSteps = 2;    // steps of a sub-tick
  static constexpr int kFaster = 4;        // [1] times the steps, in a tick of several sub-ticks
  /// Voxels of a contact for which a tick has CouplingGains::newton_steps, and those whose evaluation takes as long as
  /// the rest of a contact. Smaller contacts have more steps in the same time.
  static constexpr int kContactVoxels = 250, kContactExtra = 40;
  static constexpr int kBlockExtra = 2;  // voxels that take as long as the search in a block
  /// Upper bound on the evaluations of the contact in a tick.
  /// @param for_slope  how many the slope of a contact costs, beyond the one that gives the force
  [[nodiscard]] static int most_evaluations(int newton_steps, int sub_ticks, int for_slope) {
    return kFaster * newton_steps * (kContactVoxels + kContactExtra) / kContactExtra +
           (1 + kLeastSteps + for_slope) * sub_ticks;
  }
  NewtonSearch(VirtualCoupling& coupling, const SubTick& sub_tick, const Twist& hand);

  /// @realtime no allocation, no lock; at most `most_evaluations` in a tick
  [[nodiscard]] Twist find() noexcept;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

  /// The residual of the balance of forces at a twist.
  struct Residual {
    Vector6 of = Vector6::Zero();  // [N], [N m] force and torque
    double size = 0;               // [N] force, plus torque over lever_
    double max_force = 0;          // [N] the larger of the forces of contact and coupling
    Vector6 of_contact = Vector6::Zero();
    Stiffness free_slope = Stiffness::Zero();  // part of the slope without the contact's
    Stiffness slope = Stiffness::Zero();       // [N s/m] ... its decrease with the twist
    bool sliding = false;                      // a standing head slides
  };
  [[nodiscard]] bool may_go_on() const noexcept;
  [[nodiscard]] Residual residual_at(const Twist& tool) noexcept;
  [[nodiscard]] double cost(const Residual& residual, const Twist& tool) const noexcept;
  [[nodiscard]] Twist without_contact(const Twist& tool, const Residual& residual) const noexcept;
  void learn(Residual& from, const Vector6& correction, const Residual& there) noexcept;
  [[nodiscard]] Vector6 correct(const Residual& residual) const noexcept;
  [[nodiscard]] Twist moved(const Twist& from, const Vector6& by) const noexcept;
  [[nodiscard]] double speed_of(const Vector6& correction) const noexcept;

  VirtualCoupling& coupling_;
  const SubTick& sub_tick_;
  const Twist& hand_;
  const Twist before_;  // from which the forces accelerate the tool
  const double lever_;  // [m] distance of the farthest point of the head
  int steps_ = 0;       // number in this sub-tick
  int evaluated_ = 0;   // contacts of this sub-tick
  int voxels_ = 0;      // number in the last contact
  int blocks_ = 0;      // searched for them
  // [N s/m] ... of a contact whose law reports no stiffness: measured in the first contact, then learned.
  std::optional<Stiffness> learned_;
};

}  // namespace hapticut
