// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/spatial.hpp"
#include "hapticut/force/spread_friction.hpp"

/// Dry friction of a contact that is spread over a surface, such as a pin in its hole, a bur in a groove or a disc on a
/// plate (docs/model.md, friction of the standing head).
namespace hapticut {

/// Stick and slip of a spread contact: the tool drags an anchor, which is a pose, over the material.
///
/// A displacement xi of the tool from its anchor is a twist about the reference point. It moves the points of the
/// contact by |xi| = sqrt(xi . B xi), the root mean square weighted with the friction force that each point can bear;
/// B = A/(Sum mu_s f). While it sticks, the anchor stays, and the wrench is -k_t B xi. When k_t |xi| would exceed
/// Sum mu_s f it slides: xi is scaled so that k_t |xi| is Sum mu_d f, until it falls below that. If all points slip
/// alike this is Coulomb's law. A disc that rotates on its face has 6 % more than its exact torque, and the mean over
/// random twists of pins, discs, grooves and cones is 4 to 13 % more, never less (by Cauchy and Schwarz). The
/// dissipation is never negative.
///
/// When the contact changes, B and k_t change. Neither the stored energy nor the force may grow by that, so xi is
/// scaled.
///
/// For implicit steps (`lead` = 0.5) the force is that of the end, and the step in which sliding begins still has mu_s.
/// So the force never falls as the tool moves on, and every step has a solution.
class LimitSurface {
 public:
  struct Reaction {
    Wrench wrench;          ///< on the tool, about the reference point
    double dissipated = 0;  ///< [J] >= 0

    /// Decrease of the wrench with a small displacement; symmetric, positive semidefinite.
    Stiffness stiffness = Stiffness::Zero();
  };

  /// Moves the tool over the material.
  /// @param contact       about the reference point, a point of the tool, in axes that do not rotate
  /// @param displacement  [m], [rad] of the tool at that point, in the same axes
  /// @param fraction      [1] part of the coefficients that acts: see `dry_friction_fraction`
  /// @param lead          [1] time of the force after the middle, in sub-steps: 0, or 0.5 for the end
  /// @realtime no allocation, no lock
  Reaction move(const SpreadFriction& contact, const Twist& displacement, double fraction = 1,
                double lead = 0) noexcept {
    const double before = stored_;
    const double stiffness = contact.stiffness();
    if (!(fraction * contact.static_limit > 0 && stiffness > 0)) {
      reset();
      return {{}, before, Stiffness::Zero()};
    }
    anchored_ = true;
    stiffness_ = stiffness;
    const Stiffness shape = contact.directions / contact.static_limit;
    const double static_slip = fraction * contact.static_limit / stiffness_;
    const double dynamic_slip = fraction * contact.dynamic_limit / stiffness_;

    Vector6 start = offset();
    const double length = slip(shape, start);
    if (length > 0) {
      start *= std::min({1.0, std::sqrt(2 * stored_ / stiffness_) / length, static_slip / length});
    }
    Vector6 moved;
    moved << displacement.linear, displacement.angular;
    const Vector6 end = start + moved, seen = start + (0.5 + lead) * moved;
    scale(end, 1);
    const double at_end = slip(shape, end), limit = sliding_ ? dynamic_slip : static_slip;

    Reaction reaction;
    Vector6 wrench;
    if (std::max(slip(shape, seen), at_end) <= limit) {
      sliding_ = false;
      wrench = -stiffness_ * (shape * seen);
      stored_ = 0.5 * stiffness_ * at_end * at_end;
      reaction.stiffness = (0.5 + lead) * stiffness_ * shape;
    } else {
      sliding_ = true;
      const double kept = std::min(1.0, (lead > 0 ? limit : dynamic_slip) / at_end);
      scale(end, kept);
      wrench = -stiffness_ * kept * (shape * end);
      stored_ = 0.5 * stiffness_ * kept * kept * at_end * at_end;
      const Vector6 along = shape * end / at_end;
      reaction.stiffness = kept * stiffness_ * (shape - along * along.transpose());
    }
    reaction.wrench = {wrench.head<3>(), wrench.tail<3>()};
    reaction.dissipated = std::max(0.0, before - stored_ - wrench.dot(moved));
    return reaction;
  }

  [[nodiscard]] double stored() const { return stored_; }    ///< [J] energy of the anchor
  [[nodiscard]] bool anchored() const { return anchored_; }  ///< there is contact
  [[nodiscard]] bool sliding() const { return sliding_; }
  [[nodiscard]] double stiffness() const { return stiffness_; }  ///< [N/m] k_t

  /// Removes the anchor.
  void reset() noexcept { *this = {}; }

 private:
  friend struct SimulationMemory;
  using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

  /// [m], [rad] Offset of the tool from its anchor.
  [[nodiscard]] Vector6 offset() const {
    Vector6 xi;
    xi << position_, vector_from_rotation(rotation_);
    return xi;
  }
  [[nodiscard]] static double slip(const Stiffness& shape, const Vector6& xi) {
    return std::sqrt(std::max(0.0, xi.dot(shape * xi)));
  }
  void scale(const Vector6& xi, double factor) {
    position_ = factor * xi.head<3>();
    rotation_ = rotation_from_vector(Vec3(factor * xi.tail<3>()));
  }

  Vec3 position_ = Vec3::Zero();      // [m] offset of the tool from its anchor
  Mat3 rotation_ = Mat3::Identity();  // likewise
  double stored_ = 0;                 // [J]
  double stiffness_ = 0;              // [N/m]
  bool anchored_ = false;
  bool sliding_ = false;
};

}  // namespace hapticut
