// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hapticut/core/decay.hpp"
#include "hapticut/force/law.hpp"

namespace hapticut {

/// The default law: a volumetric elastic foundation that the spinning head cuts by the power it delivers.
///
/// For every sample of depth w, fill phi and direction n, with the slip v_t tangential to the cutting surface:
///
///     f = k_v phi w l^3 max(0, 1 + chi w_dot)                    normal force, Hunt-Crossley damped
///     g = -f n - kappa f v_t / sqrt(|v_t|^2 + v_eps^2)           force on the tool; second term only when spinning
///     phi <- phi exp(-x),  x = kappa k_v w max(0, 1 + chi w_dot) s dt / u     where w > w0 and the spindle turns
///
/// and the force uses the mean of phi over the sub-step, phi (1 - e^-x)/x, so that the tangential work of a cut sample
/// is u l^3 times the fill that it loses, exactly, for any step. Law G replaces u by max(u - k_v w^2/2, 1e-6 u). Along
/// the path w_dot = (V + Omega x r) . n; the damping factor takes w_dot from the device's own velocity.
///
/// After the thesis's spring model (Uener 2007, eqs. 5.5-5.8, 5.15-5.16), with its dependence on voxel size and step
/// repaired; see docs/decisions/0003-removal-and-ledger.md.
class FoundationLaw final : public ForceLaw {
 public:
  /// The place to read the formulas, and the reference for the vector instructions that a simulation runs instead where
  /// it was given no other law (src/kernels/press-inl.hpp).
  LawTotals evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                     ContactBlock& block) const noexcept override {
    const bool spinning = motion.spin != 0;
    const bool cutting = spinning && motion.removal != RemovalLaw::none;
    if (block.uniform) return evaluate_samples<true>(motion, materials, spinning, cutting, block);
    return evaluate_samples<false>(motion, materials, spinning, cutting, block);
  }

  [[nodiscard]] bool holds_deep_contact() const noexcept override { return true; }

  static constexpr float kSlipRegularization = 1e-3F;  ///< [m/s] v_eps
  static constexpr float kLargestExponent = 1e30F;     ///< keeps the arithmetic finite; e^-80 is already nothing left
  static constexpr float kLeastEnergyShare = 1e-6F;    ///< [1] of u that law G always has to pay
  static constexpr float kAxisZone = 0.25F;            ///< [voxel edges] about the spindle's axis
  static constexpr float kAxisSlip = 0.2837F;          ///< 1/mean(1/rho) over a unit square = 1/(4 asinh 1)

  /// [1/m^2] 1 over the square of the zone about the axis in which voxels cut by their mean slip.
  static float axis_zone_factor(const HeadMotion& m) {
    return 1.0F / (kAxisZone * kAxisZone * m.voxel_size * m.voxel_size);
  }
  /// [m^2/s^2] square of the mean slip of a voxel centred on the axis.
  static float axis_slip_squared(const HeadMotion& m) {
    return kAxisSlip * kAxisSlip * m.voxel_size * m.voxel_size * m.spin * m.spin;
  }

 private:
  template <bool kUniform>
  static LawTotals evaluate_samples(const HeadMotion& m, const ContactMaterials& materials, bool spinning, bool cutting,
                                    ContactBlock& b) noexcept {
    const ContactMaterial first = materials[b.one_material];
    const float dt = m.duration;
    const float slip_time = dt * m.level_of_detail;  // a sample that waited for its turn makes up for it
    const float voxel_volume = m.voxel_size * m.voxel_size * m.voxel_size;
    const float axis_zone = axis_zone_factor(m);
    const float slip_on_axis = axis_slip_squared(m);
    const float friction_on = spinning ? 1.0F : 0.0F;
    const float cutting_on = cutting ? 1.0F : 0.0F;
    const float release_helps = m.removal == RemovalLaw::elastic_release ? 1.0F : 0.0F;
    const float vx = m.velocity.x(), vy = m.velocity.y(), vz = m.velocity.z();
    const float ox = m.angular_velocity.x(), oy = m.angular_velocity.y(), oz = m.angular_velocity.z();
    const float hx = m.felt_velocity.x(), hy = m.felt_velocity.y(), hz = m.felt_velocity.z();
    const float ax = m.felt_angular_velocity.x(), ay = m.felt_angular_velocity.y(), az = m.felt_angular_velocity.z();

    // Partial sums per lane, in units of [N m] = l^3 times an energy density; fixed order, so the same bits every time.
    enum Term { kElasticBefore, kElastic, kCutting, kReleased, kDamping, kRubbing, kCredited, kCouple, kTerms };
    float sums[kTerms][kLanes] = {};

    for (int group = 0; group < b.lanes(); group += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) {
        const int n = group + lane;
        const ContactMaterial& material = kUniform ? first : materials[b.material[n]];
        const float k = material.stiffness, w = b.depth[n], phi = b.fill[n];
        const float x = b.x[n], y = b.y[n], z = b.z[n];
        const float nx = b.normal_x[n], ny = b.normal_y[n], nz = b.normal_z[n];

        // Velocity of the handpiece at the sample, its part w_dot along n, and the slip: the rest of it plus the spin,
        // which is tangential to any head of revolution.
        const float px = vx + oy * z - oz * y, py = vy + oz * x - ox * z, pz = vz + ox * y - oy * x;
        const float w_dot = px * nx + py * ny + pz * nz;
        const float tx = px - w_dot * nx - m.spin * y, ty = py - w_dot * ny + m.spin * x, tz = pz - w_dot * nz;
        const float near_axis = std::max(0.0F, 1.0F - (x * x + y * y) * axis_zone);
        const float extra = slip_on_axis * near_axis * near_axis;
        const float slip_squared = tx * tx + ty * ty + tz * tz + extra;
        const float inverse_slip = 1.0F / std::sqrt(slip_squared + kSlipRegularization * kSlipRegularization);
        const float slip = slip_squared * inverse_slip;

        const float felt_w_dot =
            (hx + ay * z - az * y) * nx + (hy + az * x - ax * z) * ny + (hz + ax * y - ay * x) * nz;
        const float damped = std::max(0.0F, 1.0F + material.damping * felt_w_dot);

        // Removal: x, the mean fill and the loss of the sub-step.
        const float kappa = friction_on * material.cutting_ratio;
        const float stored = 0.5F * k * w * w;  // [J/m^3] of a full voxel
        const float u = material.cutting_energy;
        const float price = std::max(u - release_helps * stored, kLeastEnergyShare * u);
        const float is_cut = w > material.cutting_depth ? cutting_on : 0.0F;
        const float rate = is_cut * kappa * k * w * damped * slip;  // [W/m^3] tangential power per filled volume
        const float exponent = std::min(rate * slip_time / price, kLargestExponent);
        const float mean_fill = phi * mean_of_decay(exponent);
        const float loss = mean_fill * exponent;
        const float left = phi - loss;
        const bool finished = left < kSmallestFill && exponent > 0;
        const float credit = finished ? left : 0.0F;
        b.fill_after[n] = finished ? 0.0F : left;

        const float spring = k * mean_fill * w;  // [N/m^3]
        const float normal = spring * damped;
        const float tangential = kappa * normal * inverse_slip;
        b.force_x[n] = -voxel_volume * (normal * nx + tangential * tx);
        b.force_y[n] = -voxel_volume * (normal * ny + tangential * ty);
        b.force_z[n] = -voxel_volume * (normal * nz + tangential * tz);

        const float advance = w_dot * dt;
        const float w_middle = w - m.lead * advance;
        const float w_begin = w_middle - 0.5F * advance, w_end = w_middle + 0.5F * advance;
        const float taken = loss + credit;
        // Elastic energy of what was removed: what went in, k mean_fill w advance, less what is still stored, exactly.
        const float let_go = 0.5F * k * (w_middle * w_middle + 0.25F * advance * advance) * taken -
                             k * w_middle * advance * (phi - 0.5F * taken - mean_fill);
        // Evaluated after the middle, springs push harder than what they store: a damper's work. Those that were not
        // touched at the beginning stored nothing there.
        const float not_yet = m.lead > 0 ? std::max(0.0F, -w_begin) : 0.0F;
        const float before_touch = 0.5F * k * phi * not_yet * not_yet;
        const float lead_work = k * mean_fill * m.lead * advance * advance - before_touch;
        sums[kElasticBefore][lane] += 0.5F * k * phi * w_begin * w_begin - before_touch;
        sums[kElastic][lane] += 0.5F * k * b.fill_after[n] * w_end * w_end;
        sums[kCutting][lane] += u * taken;
        sums[kReleased][lane] += let_go - (u - price) * taken;
        sums[kDamping][lane] += (normal - spring) * w_dot * dt + lead_work;
        sums[kRubbing][lane] += kappa * normal * slip * slip_time * (1.0F - is_cut);
        sums[kCredited][lane] += price * credit;
        sums[kCouple][lane] += tangential * extra;
      }

    const auto total = [&](Term term) {
      double sum = 0;
      for (const float lane_sum : sums[term]) sum += double(lane_sum);
      return sum * double(voxel_volume);
    };
    const double couple = spinning ? -total(kCouple) / double(m.spin) : 0.0;
    return {{total(kElasticBefore), total(kElastic), total(kCutting), total(kReleased), total(kDamping),
             total(kRubbing), total(kCredited)},
            couple,
            cutting};
  }
};

}  // namespace hapticut
