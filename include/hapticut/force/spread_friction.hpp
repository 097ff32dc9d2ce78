// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/contact/contact.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"

namespace hapticut {

namespace formulas {
#include "hapticut/formulas/friction.inl"
}  // namespace formulas

/// The contact as dry friction needs it: sums over its points of the normal force f, each with the coefficients of its
/// own material.
struct SpreadFriction {
  /// [N], [N m], [N m^2] `A = Sum mu_s f P^T (1 - n n^T) P`, where P maps a twist at the reference point to the
  /// velocity of a point.
  Stiffness directions = Stiffness::Zero();
  double static_limit = 0;   ///< [N] `Sum mu_s f`: limit of friction when all points slip alike
  double dynamic_limit = 0;  ///< [N] `Sum mu_d f`
  double anchors = 0;        ///< [N^2/m] `Sum mu_s f k_t` of points with a given k_t
  double springs = 0;        ///< [N/m] sum over the others of kTangentialShare times their stiffness along n

  /// [N/m] Stiffness of the anchor; 0 without contact.
  [[nodiscard]] double stiffness() const { return static_limit > 0 ? anchors / static_limit + springs : 0.0; }

  /// Adds a point.
  /// @param r       [m] from the reference point
  /// @param n       [1] unit normal
  /// @param normal  [N] >= 0
  /// @param spring  [N/m] along n, used when friction gives no stiffness
  void add(const Vec3& r, const Vec3& n, double normal, const DryFriction& friction, double spring = 0) {
    const auto point = formulas::PointFriction<double>::of(friction.static_friction, friction.dynamic_friction,
                                                           friction.tangential_stiffness, normal, spring);
    Eigen::Matrix<double, 3, 6> P;  // (1 - n n^T) (1, -[r]x)
    P << Mat3::Identity(), Mat3::Zero();
    P.col(3) << 0, -r.z(), r.y();
    P.col(4) << r.z(), 0, -r.x();
    P.col(5) << -r.y(), r.x(), 0;
    P -= n * (n.transpose() * P).eval();
    directions += point.limit * P.transpose() * P;
    static_limit += point.limit;
    dynamic_limit += point.dynamic;
    anchors += point.anchor;
    springs += kTangentialShare * point.spring;
  }

  /// Adds the samples of a block, about To and in T, after a law has evaluated it for a standing head.
  void add(const ContactBlock& b, const HeadMotion& motion, const ContactMaterials& materials) {
    const double volume = std::pow(double(motion.voxel_size), 3);
    for (int i = 0; i < b.lanes(); ++i) {
      const auto at = std::size_t(i);
      const Vec3 n(double(b.normal_x[at]), double(b.normal_y[at]), double(b.normal_z[at]));
      const double normal = -n.dot(Vec3(double(b.force_x[at]), double(b.force_y[at]), double(b.force_z[at])));
      if (!(normal > 0)) continue;
      const ContactMaterial& m = materials[b.material_of(i)];
      const double scale = double(b.scale_of(i));
      add(Vec3(double(b.x[at]), double(b.y[at]), double(b.z[at])), n, normal,
          {double(m.static_friction), double(m.dynamic_friction), double(m.tangential_stiffness)},
          scale * scale * double(m.stiffness) * double(b.sub_voxel ? b.immersed[at] : b.fill[at]) * volume);
    }
  }

  /// Scales all forces and all springs.
  SpreadFriction& operator*=(double factor) {
    directions *= factor;
    static_limit *= factor;
    dynamic_limit *= factor;
    anchors *= factor;
    springs *= factor;
    return *this;
  }

  /// A contact at the reference point only.
  /// @param normal_force  [N] on the tool
  /// @param spring        [N/m] along it
  [[nodiscard]] static SpreadFriction at_point(const Vec3& normal_force, const DryFriction& friction,
                                               double spring = 0) {
    SpreadFriction contact;
    if (const double normal = normal_force.norm(); normal > 0)
      contact.add(Vec3::Zero(), normal_force / normal, normal, friction, spring);
    return contact;
  }
};

}  // namespace hapticut
