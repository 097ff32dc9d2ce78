// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// Keeps a ball that was pushed beyond its radius from popping through (D15).
///
/// The springs of a ball push away from its centre, so springs beyond the centre pull it in: the force of a half space
/// peaks at depth R, falls, and vanishes when the ball is buried. Once more than half of the ball is filled, the
/// direction n of its push is frozen, and a spring along n, the tether, ties the ball to that place:
///
///     F = -K s n,   s = (To - p) . n > 0        p: where To was then
///
/// with K = 1.05 * 16/9 |F|/R, where F is the normal force at that moment. K is a little more than the steepest fall of
/// the springs' force (C2), so the sum never falls as the ball goes deeper. The spring has an energy, K s^2/2, and does
/// no work on a closed path. It ends when the ball comes back to p. It yields when material leaves the ball because it
/// is cut or a wall breaks: K then falls with the filled fraction of the ball, to zero at a quarter. A ball that never
/// touched a surface before it was buried has no direction of push, and only its springs act.
class DeepContact {
 public:
  static constexpr double kDeep = 0.52;  ///< [1] filled fraction from which on the ball is tethered; 1/2 at depth R
  static constexpr double kFree = 0.25;  ///< [1] filled fraction at which the spring has vanished

  struct Pull {
    Vec3 force = Vec3::Zero();  ///< [N] on the ball at its centre
    double stored_before = 0;   ///< [J] at `from`
    double stored = 0;          ///< [J]
    double released = 0;        ///< [J] >= 0, lost when the spring yielded or ended
  };

  /// Moves the ball on a straight path.
  /// @param from, to      [m] its centre, in W
  /// @param filled        [1] filled fraction of the ball, in the middle of the path
  /// @param normal_force  [N] of the springs on the ball, there, in W. When `needs_normal_force` is false, only whether
  /// it is zero matters
  /// @param radius        [m]
  /// @realtime no allocation, no lock; O(1)
  Pull move(const Vec3& from, const Vec3& to, double filled, const Vec3& normal_force, double radius) noexcept {
    if (!tethered_) {
      const double force = normal_force.norm();
      if (filled < kDeep) touched_ = force > 0;
      if (!needs_normal_force(filled) || !(force > 0)) return {};
      tethered_ = true;
      normal_ = -normal_force / force;
      place_ = from;
      full_stiffness_ = stiffness_ = 1.05 * 16 / 9 * force / radius;
      stored_ = 0;
    }
    const double before = (from - place_).dot(normal_), after = (to - place_).dot(normal_);
    Pull pull;
    pull.stored_before = energy_at(before);
    const double fraction = std::clamp((filled - kFree) / (kDeep - kFree), 0.0, 1.0);
    stiffness_ = std::min(stiffness_, fraction * full_stiffness_);
    const double tension = stiffness_ * std::max(0.0, 0.5 * (before + after));
    pull.force = -tension * normal_;
    pull.stored = stored_ = energy_at(after);
    pull.released = std::max(0.0, pull.stored_before + tension * (after - before) - stored_);
    if (after <= 0 || stiffness_ == 0) *this = {};
    return pull;
  }

  /// Whether the next `move` begins to tether the ball. It then needs the normal force without the drag along the
  /// ball's surface.
  [[nodiscard]] bool needs_normal_force(double filled) const { return !tethered_ && touched_ && filled >= kDeep; }

  [[nodiscard]] bool tethered() const { return tethered_; }                      ///< the spring acts
  [[nodiscard]] double stiffness() const { return tethered_ ? stiffness_ : 0; }  ///< [N/m] stiffness of the spring
  [[nodiscard]] const Vec3& normal() const {
    return normal_;
  }                                                        ///< [1] direction of the spring, into the material, in W
  [[nodiscard]] double stored() const { return stored_; }  ///< [J]

  void reset() noexcept { *this = {}; }

 private:
  friend struct SimulationMemory;
  [[nodiscard]] double energy_at(double s) const { return s > 0 ? 0.5 * stiffness_ * s * s : 0.0; }

  bool touched_ = false, tethered_ = false;
  Vec3 normal_ = Vec3::Zero();                 // [1] from the ball into the material
  Vec3 place_ = Vec3::Zero();                  // [m]
  double full_stiffness_ = 0, stiffness_ = 0;  // [N/m]
  double stored_ = 0;                          // [J]
};

}  // namespace hapticut
