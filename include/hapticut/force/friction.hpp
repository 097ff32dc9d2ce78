// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"

/// @file
/// Dry friction of a head that does not spin (thesis 5.2.3 and Table 5.2; docs/model.md, friction of the standing
/// head).
namespace hapticut {

/// Dry friction between the standing head and the material.
struct DryFriction {
  double static_friction = 0.3;
  double dynamic_friction = 0.3;
  double tangential_stiffness = 1000;
};

constexpr auto fields_of(Of<DryFriction>) {
  using F = DryFriction;
  return std::tuple{
      field("static_friction", &F::static_friction, "1", Range::not_negative(), "mu_s, not below dynamic_friction"),
      field("dynamic_friction", &F::dynamic_friction, "1", Range::not_negative(), "mu_d"),
      field("tangential_stiffness", &F::tangential_stiffness, "N/m", Range::positive(), "k_t of the sticking anchor"),
  };
}

/// @throws Error naming the constant, its value and the allowed range
inline void validate(const DryFriction& friction) {
  require_fields_within(friction, "DryFriction::");
  if (friction.dynamic_friction > friction.static_friction)
    throw Error("DryFriction::dynamic_friction = " + format_number(friction.dynamic_friction) +
                "; must not exceed static_friction = " + format_number(friction.static_friction) +
                ". Lower it, or raise static_friction.");
}

/// [m/s] speed of the head's rim from which on the cutting ratio alone describes the tangential force.
inline constexpr double kFullSpinSpeed = 0.01;

/// How much of the friction is that of a standing head: 1 while the spindle stands, 0 from a rim speed of
/// `kFullSpinSpeed` on, and a smooth step between.
///
/// The hand-over: while it is between 0 and 1, dry friction acts with this share of its coefficients and the cutting
/// ratio with the rest of its own, so that starting and stopping the spindle changes the force continuously.
/// @param spin    [rad/s]
/// @param radius  [m] largest radius of the head
[[nodiscard]] inline double standing_share(double spin, double radius) {
  const double t = std::min(1.0, std::abs(spin) * radius / kFullSpinSpeed);
  return 1 - t * t * (3 - 2 * t);
}

/// Stick and slip: an elastic anchor that the tool drags over the material.
///
/// The anchor S lies in the workpiece, `stretch = S - x` is its distance from the contact point x of the tool, and the
/// force on the tool is `k_t stretch`, in the plane normal to the summed normal force N. While it sticks, S stays. When
/// `k_t |stretch|` would exceed `mu_s |N|` it slides: S is dragged along so that the force is `mu_d |N|`, until the
/// force falls below that. No contact, no anchor. The force never leaves the cone `mu_s |N|`.
///
/// A sub-step that sticks returns its mean force, so that the work is exactly what the anchor stores; everything else
/// is dissipation, and never negative (C17).
///
/// For implicit steps (`lead` = 0.5) the force is that of the end, and the step in which it begins to slide still has
/// mu_s: so the force never falls as the tool moves on, and every step has a solution.
class StickSlip {
 public:
  struct Outcome {
    Vec3 force = Vec3::Zero();  ///< [N] on the tool at the contact point
    double dissipated = 0;      ///< [J] >= 0

    /// [N/m] by how much the force falls with a small displacement; symmetric, positive semidefinite.
    Mat3 stiffness = Mat3::Zero();
  };

  /// Moves the contact point of the tool.
  /// @param normal_force  [N] summed normal force on the tool
  /// @param displacement  [m] of the tool's contact point over the material, in the same axes
  /// @param share         [1] of the coefficients in force: see `standing_share`
  /// @param lead          [1] of the sub-step after its middle that the force is that of: 0, or 0.5 for its end
  /// @realtime no allocation, no lock
  Outcome move(const Vec3& normal_force, const Vec3& displacement, const DryFriction& friction, double share = 1,
               double lead = 0) noexcept {
    const double before = stored();
    const double normal = share * normal_force.norm();
    if (!(normal > 0)) {
      release();
      return {Vec3::Zero(), before, Mat3::Zero()};
    }
    if (!anchored_) {
      anchored_ = true;
      stiffness_ = friction.tangential_stiffness;  // kept while the contact lasts, whatever material comes next
    }
    const Vec3 n = normal_force.normalized();
    const auto tangential = [&](const Vec3& v) { return Vec3(v - n * n.dot(v)); };
    const Mat3 plane = Mat3::Identity() - n * n.transpose();
    const Vec3 start = tangential(stretch_), move = tangential(displacement), end = start - move;
    const Vec3 seen = start - (0.5 + lead) * move;  // the mean, or the end

    const double limit = (sliding_ ? friction.dynamic_friction : friction.static_friction) * normal / stiffness_;
    if (std::max(seen.squaredNorm(), end.squaredNorm()) <= limit * limit) {
      sliding_ = false;
      stretch_ = end;
      const double let_go = std::max(0.0, before - 0.5 * stiffness_ * start.squaredNorm());
      return {stiffness_ * seen, let_go + lead * stiffness_ * move.squaredNorm(), (0.5 + lead) * stiffness_ * plane};
    }
    const double length = std::max(end.norm(), 1e-300);
    const double dragged = lead > 0 ? limit : friction.dynamic_friction * normal / stiffness_;
    const double kept = std::min(1.0, dragged / length);
    sliding_ = true;
    stretch_ = kept * end;
    const Vec3 force = stiffness_ * stretch_, along = end / length;
    return {force, std::max(0.0, before - stored() - force.dot(move)),
            kept * stiffness_ * (plane - along * along.transpose())};
  }

  /// [J] energy of the anchor.
  [[nodiscard]] double stored() const { return 0.5 * stiffness_ * stretch_.squaredNorm(); }
  [[nodiscard]] bool anchored() const { return anchored_; }  ///< there is contact
  [[nodiscard]] bool sliding() const { return sliding_; }
  [[nodiscard]] double stiffness() const { return stiffness_; }   ///< [N/m] of the anchor
  [[nodiscard]] const Vec3& stretch() const { return stretch_; }  ///< [m] from the contact point to the anchor

  /// Lets go of the anchor.
  void release() noexcept { *this = {}; }

 private:
  Vec3 stretch_ = Vec3::Zero();  // [m]
  double stiffness_ = 0;         // [N/m]
  bool anchored_ = false;
  bool sliding_ = false;
};

}  // namespace hapticut
