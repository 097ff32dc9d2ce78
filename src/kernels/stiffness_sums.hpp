// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/workpiece/removal.hpp"

namespace hapticut::kernels {

/// Sums of the contact's stiffness over samples, `Sum s (q, r x q) (n, r x n)^T`, row by row. A spring answers a motion
/// along its normal n with a force along q, which is n plus the drag of the spin, kappa times the direction of the
/// slip. Without spin the sum is symmetric and positive semidefinite.
///
/// The drag of the spin is along the slip. A motion across the slip rotates the drag: this is a damper along n x slip,
/// over the sub-step. Where the slip is slower than its regularisation, the drag grows with it: this is a damper along
/// the slip. The rotation of the normals is neglected (Gauss-Newton approximation).
struct StiffnessSums {
  static constexpr std::size_t kTerms = 36;
  static constexpr std::size_t kLanes = BlockChange::kStrip;
  static constexpr float kSlowSlip =
      10 * FoundationLaw::kSlipRegularization;  ///< [m/s] above which the drag is complete

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};  ///< [N/m^4], [N/m^3], [N/m^2]

  /// @param voxel_volume  [m^3]
  [[nodiscard]] Stiffness total(double voxel_volume) const {
    Stiffness k;
    for (std::size_t term = 0; term < kTerms; ++term) {
      double sum = 0;
      for (const double lane : lanes[term]) sum += lane;
      k(int(term / 6), int(term % 6)) = sum * voxel_volume;
    }
    return k;
  }
};

/// [m] Depth below which FoundationLaw crushes.
inline float limit_of(const HeadMotion& m, const ContactMaterial& material, const FoundationLaw::Damping& damped,
                      const Eigen::Vector3f& r, const Eigen::Vector3f& n, const Eigen::Vector3f& velocity) noexcept {
  const float depth = damped.crushing_depth(material.crushing_depth);
  if (!m.cuts()) return depth;
  constexpr float kRegular = FoundationLaw::kSlipRegularization;
  const float squared =
      FoundationLaw::AxisSlip(m).squared((velocity - velocity.dot(n) * n).squaredNorm(), r.head<2>().squaredNorm());
  const float slip = squared / std::sqrt(squared + kRegular * kRegular);
  const float power = 0.5F * material.cutting_ratio * material.stiffness * damped.factor * slip;
  const float speed = (m.velocity + m.angular_velocity.cross(r)).dot(n);
  const float recession = ChipChord<float>::recession_at(depth, material, m.tooth_rate, power / material.cutting_energy,
                                                         speed - m.ripple.dot(n), (m.velocity - m.ripple).norm());
  return depth + std::clamp(speed, 0.0F, recession) * 0.5F * m.duration * m.level_of_detail;
}

/// Adds the stiffness of the samples of one block, after FoundationLaw has evaluated it. Each sample is a spring and
/// damper of `f' = k phi (g_d + g_d' chi w/dt)` along its normal, `phi` the mean fill of the sub-step, with the
/// constants at its surface. Reference for the vectors.
inline void add_stiffness(const ContactBlock& b, const HeadMotion& m, const ContactMaterials& materials,
                          StiffnessSums& sums) noexcept {
  const double volume = std::pow(double(m.voxel_size), 3);
  for (std::size_t i = 0; i < std::size_t(b.lanes()); ++i) {
    if (!(b.top[i] > 0)) continue;
    const Eigen::Vector3f r(b.x[i], b.y[i], b.z[i]), n(b.normal_x[i], b.normal_y[i], b.normal_z[i]);
    const ContactMaterial& material =
        FoundationLaw::at_surface(materials[b.material_of(int(i))], m, b.smooth[i], b.scale_of(int(i)));
    const float damping = material.damping, closing = (m.felt_velocity + m.felt_angular_velocity.cross(r)).dot(n);
    const auto damped = FoundationLaw::Damping::of(damping * closing);
    const Eigen::Vector3f force(b.force_x[i], b.force_y[i], b.force_z[i]);
    if (!(force.dot(n) < 0)) continue;
    const VoxelSection<float> section(b.max_component[i], b.min_width);
    const float top = b.top[i] / m.voxel_size, height = top - b.depth[i] / m.voxel_size + section.span() / 2;
    const DepthIntegrals<float> part = section.integrals(height, top);
    const float depth = part.depth * m.voxel_size;  // [m] mean over the voxel
    const Eigen::Vector3f velocity = m.velocity + (m.angular_velocity + Eigen::Vector3f(0, 0, m.spin)).cross(r);
    const bool at_limit = m.crushes && b.top[i] >= (1 - 1e-5F) * limit_of(m, material, damped, r, n, velocity);
    const float crushed =
        at_limit ? top * section.area_at(height) : 0.0F;  // at the crushing limit: its force does not grow
    // The crushing limit moves up with the closing speed.
    const float moving = depth - (damped.factor > 1 ? 0.5F * b.top[i] * crushed : 0.0F);
    const double spring = -double(force.dot(n)) / (volume * double(depth) * double(damped.factor));  // k phi
    const double slope =
        spring * double((part.volume - crushed) * damped.factor + damped.slope * damping * moving / m.time_to_move());
    const Eigen::Vector3d arm = r.cast<double>(), along = force.cast<double>() / double(force.dot(n));
    const auto add = [&](double strength, const Eigen::Vector3d& q, const Eigen::Vector3d& motion) {
      Eigen::Matrix<double, 6, 1> row, column;
      row << q, arm.cross(q);
      column << motion, arm.cross(motion);
      for (std::size_t term = 0; term < StiffnessSums::kTerms; ++term)
        sums.lanes[term][i % StiffnessSums::kLanes] += strength * row[int(term / 6)] * column[int(term % 6)];
    };
    add(slope, along, n.cast<double>());
    // The drag rotates with the slip: the two are parallel, and a motion across them rotates both.
    const Eigen::Vector3d across = n.cross(velocity).cast<double>();
    const double slip = across.norm();
    if (m.spin == 0 || slip < 1e-6) continue;
    const double drag = double((force - force.dot(n) * n).norm()) / volume;
    const double damper = drag / (slip * double(m.time_to_move())),
                 regular = double(FoundationLaw::kSlipRegularization);
    add(damper, across / slip, across / slip);
    if (slip > double(StiffnessSums::kSlowSlip)) continue;
    const Eigen::Vector3d along_slip = (velocity - velocity.dot(n) * n).cast<double>() / slip;
    add(damper * regular * regular / (slip * slip + regular * regular), along_slip, along_slip);
  }
}

}  // namespace hapticut::kernels
