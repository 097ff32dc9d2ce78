// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/force/law.hpp"
#include "hapticut/force/laws/foundation.hpp"

namespace hapticut {

/// Adds the samples of one block to the moments of the whole contact.
/// @realtime no allocation, no lock; O(samples)
inline void add_moments(const ContactBlock& b, const HeadMotion& m, const ContactMaterials& materials,
                        ContactMoments& moments) noexcept {
  const double l3 = std::pow(double(m.voxel_size), 3);
  const Vec3 V = m.velocity.cast<double>(), Omega = m.angular_velocity.cast<double>();
  const Vec3 turning = Omega + Vec3(0, 0, double(m.spin));
  for (int i = 0; i < b.lanes(); ++i) {
    const auto n = std::size_t(i);
    if (!(b.fill[n] > 0)) continue;
    const double dV = double(b.fill[n]) * l3, w = double(b.depth[n]);
    const Vec3 r(double(b.x[n]), double(b.y[n]), double(b.z[n]));
    const Vec3 direction(double(b.normal_x[n]), double(b.normal_y[n]), double(b.normal_z[n]));
    const Vec3 v = V + turning.cross(r), slip = v - v.dot(direction) * direction;
    const double kappa = double(materials[b.material_of(i)].cutting_ratio);
    const Vec3 t = slip / std::sqrt(slip.squaredNorm() + std::pow(double(FoundationLaw::kSlipRegularization), 2));
    moments.volume += dV;
    moments.first_moment += dV * r;
    moments.depth_integral += dV * w;
    moments.normal_integral += dV * w * direction;
    moments.rubbing.force += dV * w * kappa * t;
    moments.rubbing.torque += dV * w * kappa * r.cross(t);
    moments.rubbing_speed += dV * w * kappa * t.dot(slip);
    moments.depth = std::max(moments.depth, w);
    // Of the sample, not of its voxel's rim: half an edge more would make a drill of whole voxels too wide.
    moments.radius = std::max(moments.radius, r.head<2>().norm());
  }
}

/// Base of the laws of a whole contact: a normal force by `lump`, rubbing of the spinning head under it, and a removal
/// that spends the power of the rubbing.
///
/// The cut: a sample of depth w, cutting ratio kappa and slip s gets the fraction q = w kappa s phi / Sum w kappa s phi
/// of the contact's cutting power P and loses
///
///     phi <- phi exp(-x),   x = q P dt / (u phi l^3)     while the spindle turns
///
/// so every removed volume costs its u, and the power that the decay does not use is rubbing. Removal and ledger are
/// the same as those of the default law.
class LumpedLaw : public ForceLaw {
 public:
  [[nodiscard]] bool needs_moments() const noexcept final { return true; }

  LawTotals evaluate(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) const noexcept final {
    const double l3 = std::pow(double(m.voxel_size), 3), dt = double(m.duration);
    const ContactMoments& moments = m.whole->moments;
    const bool spinning = m.spin != 0 && moments.rubbing_speed > 0;
    const bool removes = spinning && m.removal != RemovalLaw::none;
    // [J/m^5 s] energy per w kappa s phi l^3
    const double energy = spinning ? m.whole->lumped.cutting_power * dt / moments.rubbing_speed : 0.0;
    const Vec3 V = m.velocity.cast<double>();
    const Vec3 turning = m.angular_velocity.cast<double>() + Vec3(0, 0, double(m.spin));

    LawTotals totals;
    totals.may_remove = removes;
    for (int i = 0; i < b.lanes(); ++i) {
      const auto n = std::size_t(i);
      b.force_x[n] = b.force_y[n] = b.force_z[n] = 0;
      b.fill_after[n] = b.fill[n];
      if (!(b.fill[n] > 0) || !spinning) continue;
      const ContactMaterial& material = materials[b.material_of(i)];
      const Vec3 r(double(b.x[n]), double(b.y[n]), double(b.z[n]));
      const Vec3 direction(double(b.normal_x[n]), double(b.normal_y[n]), double(b.normal_z[n]));
      const Vec3 v = V + turning.cross(r), slip = v - v.dot(direction) * direction;
      const double eps = double(FoundationLaw::kSlipRegularization);
      const double speed = slip.squaredNorm() / std::sqrt(slip.squaredNorm() + eps * eps);
      const double per_fill = energy * double(b.depth[n]) * double(material.cutting_ratio) * speed;  // [J/m^3]
      const double phi = double(b.fill[n]), u = double(material.cutting_energy);
      const double x = removes ? per_fill / u : 0.0;
      const double mean = formulas::mean_of_decay(std::min(x, 1e18));
      const double loss = phi * std::min(x * mean, 1.0), left = phi - loss;
      const bool finished = left < double(kMinFill) && x > 0;
      b.fill_after[n] = finished ? 0.0F : float(left);
      totals.energies.cutting += u * (finished ? phi : loss) * l3;
      if (finished) totals.energies.credited += u * left * l3;
      totals.energies.rubbing += std::max(0.0, per_fill * phi - u * loss) * l3;
    }
    return totals;
  }

 protected:
  /// Adds the friction of a spinning head under a normal force, along the slip of each sample with the materials'
  /// cutting ratios, and makes its power available to the cut.
  static void add_rubbing(const HeadMotion& m, const ContactMoments& moments, double normal_force,
                          LumpedForce& lumped) {
    if (m.spin == 0 || !(moments.depth_integral > 0)) return;
    const double scale = normal_force / moments.depth_integral;
    lumped.wrench_T.force -= scale * moments.rubbing.force;
    lumped.wrench_T.torque -= scale * moments.rubbing.torque;
    lumped.cutting_power += scale * moments.rubbing_speed;
  }
};

}  // namespace hapticut
