// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hapticut/core/decay.hpp"
#include "hapticut/force/chip.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/workpiece/cut_voxel.hpp"

namespace hapticut {

/// The default law: a volumetric elastic foundation that the spinning head cuts by the power it delivers.
///
/// In plain words: the material is a mattress of small springs, one for each bit of volume. A head that presses in
/// feels the springs that it pushes aside. Where its surface slides over them it drags on them, and the power of this
/// drag pays for the removed material: each volume costs the energy u. So a standing head sinks in a little and stops,
/// and a spinning head sinks in as fast as its power pays for. k_v sets only how thick the pressed layer is: softer
/// springs give a thicker layer and, while it is thin against the head, the same cutting force.
///
/// Material at depth w pushes back along the normal n with the pressure gradient k_v w. Hunt-Crossley damping
/// multiplies it by g_d(chi w_dot), with g_d(e) = 1 + e while the contact closes and 1/(1 - e) while it opens. Where
/// the head turns, the material also drags along the slip v_t, tangential to the cutting surface:
///
///     force = -f n - kappa f v_t / sqrt(|v_t|^2 + v_eps^2)      f = k_v g_d l^3 phi <w>
///
/// Each voxel is integrated over its filled part (VoxelSection). t is the depth of its top; <w> and <w>_0 are the means
/// over that part of the depth and of the depth beyond w0. Material shallower than w0 is not cut:
///
///     f = k_v g_d phi l^3 (<w> - <w>_0 + r <w>_0)      phi <- phi e^-x      x = 2 k_d r <w>_0 dt
///
/// where k_d = kappa k_v g_d s/(2 u), and r is the recession of the layer within the sub-step over the recession at the
/// speed at the evaluation (LayerRecession). Cutting removes the deepest material, so material that only rubs stays.
/// The force uses the mean of phi over the sub-step, phi (1 - e^-x)/x, so the tangential work of the cut is exactly u
/// l^3 times the lost fill, for any step. Law G replaces u by max(u - k_v w^2/2, 1e-6 u). Along the path w_dot = (V +
/// Omega x r) . n; the damping factor takes w_dot from the device's own velocity.
///
/// Before that, material that would be pressed harder than it can bear is removed, below the crushing depth w_c =
/// sqrt(2 sigma/(k_v max(1, g_d))), at which a column's pressure k_v g_d w^2/2 is sigma. A head that turns cuts while
/// it sinks in: what the pressure sigma cuts within half of a sub-step, v(w_c) dt/2 and at most what the head moves in
/// it, is left for the cut. Otherwise a head whose sub-step is not much shorter than w_c, as in a soft material, would
/// crush what it cuts in shorter steps. Crushing takes sigma times the volume.
///
/// At a smooth surface w changes by s = kSmoothScale per distance (MeridianSpring). There w is the distance, k_v is
/// multiplied by s^2, chi by s, and every depth by 1/s. kappa is mu_d, and nothing is cut except within the material's
/// land of a cutting edge (`at_surface`).
///
/// From the thesis's spring model (Uener 2007, eqs. 5.5-5.8, 5.15-5.16), with its dependence on voxel size and step
/// removed; see docs/decisions/0003-removal-and-ledger.md and 0009-cut-voxels.md.
class FoundationLaw final : public ForceLaw {
 public:
  /// The readable form of the formulas, and the reference for the vector instructions that a simulation runs instead
  /// (`press_parts_of` in src/kernels/cut_voxels-inl.hpp). The block must be sampled with Quadrature::sub_voxel.
  LawTotals evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                     ContactBlock& block) const noexcept override {
    HAPTICUT_ASSERT(block.sub_voxel);
    const bool spinning = motion.spin != 0;
    return evaluate_parts(motion, materials, spinning, spinning && motion.removal != RemovalLaw::none, block);
  }

  [[nodiscard]] bool is_foundation() const noexcept override { return true; }
  [[nodiscard]] bool holds_deep_contact() const noexcept override { return true; }
  [[nodiscard]] bool integrates_parts() const noexcept override { return true; }

  static constexpr float kSlipRegularization = 1e-3F;  ///< [m/s] v_eps
  static constexpr float kMaxExponent = 1e30F;         ///< keeps the arithmetic finite; e^-80 is practically zero
  static constexpr float kMinEnergyShare = 1e-6F;      ///< [1] fraction of u that law G always pays
  static constexpr float kMinPart = 1e-6F;             ///< [1] fill below which a cut voxel is empty
  static constexpr float kMinLoss = 1e-5F;  ///< [1] relative loss in a sub-step below which no release is booked

  /// [1] g_d of Hunt and Crossley's chi w_dot: smooth and never negative.
  [[nodiscard]] static float damping_factor(float x) { return x < 0 ? 1 / (1 - x) : 1 + x; }

  /// [1] g_d and its slope with x = chi w_dot.
  struct Damping {
    float factor, slope;
    static Damping of(float x) {
      const float factor = damping_factor(x);
      return {factor, factor < 1 ? factor * factor : 1.0F};
    }
    /// [m] Depth at which a column's pressure k_v g_d w^2/2 is the strength; deeper material is crushed.
    /// @param at_rest  [m] ContactMaterial::crushing_depth
    [[nodiscard]] float crushing_depth(float at_rest) const { return at_rest / std::sqrt(std::max(1.0F, factor)); }
  };

  /// The constants at a sample, whose depth is a distance: they differ between smooth and cutting surfaces.
  /// @param smooth  [m^2] MeridianSpring::smooth
  /// @param scale   [1] scale of the sample
  static ContactMaterial at_surface(const ContactMaterial& material, const HeadMotion& m, float smooth, float scale) {
    if (!(smooth > 0)) return material;
    ContactMaterial there = material;
    const bool cuts = smooth <= material.square_of_land(m.voxel_size);
    there.stiffness *= scale * scale;
    there.damping *= scale;
    there.crushing_depth /= scale;
    there.cutting_ratio = cuts ? material.cutting_ratio : material.sliding_ratio;
    there.cutting_depth = cuts ? material.cutting_depth / scale : ContactMaterial::kNeverCut;
    return there;
  }

  static constexpr float kAxisZone =
      2.0F;  ///< [voxel edges] about the spindle's axis, where voxels are cut with their mean slip
  static constexpr float kAxisSlip = 0.2837F;  ///< 1/mean(1/rho) over a unit square about the axis = 1/(4 asinh 1)

  /// The slip with which voxels near the axis are cut. The slip omega rho varies over such a voxel, and its centre does
  /// not represent the whole. Thrust is proportional to 1/slip, so the harmonic mean over the section, 1/mean(1/rho),
  /// counts. Its square is that of the centre plus an excess E(q), q = rho^2 in voxel edges squared: kAxisSlip^2 on the
  /// axis, negative from 0.46 edges on, -1/12 far away. The fit to the mean over the directions of a unit square gives
  /// 1/rho within 1.2 %.
  struct AxisSlip {
    static constexpr float kFar = -1.0F / 12, kPeak = kAxisSlip * kAxisSlip - kFar;
    static constexpr float kZero = 4.75F, kFlat = 1.3F, kSteep = 46.0F;

    float per_edge;     ///< [1/m^2] 1/l^2
    float per_slip;     ///< [m^2/s^2] (l omega)^2
    float min_squared;  ///< [m^2/s^2] square of the slip of a voxel centred on the axis: the minimum

    explicit AxisSlip(const HeadMotion& m)
        : per_edge(1 / (m.voxel_size * m.voxel_size)),
          per_slip(m.voxel_size * m.voxel_size * m.turning() * m.turning()),
          min_squared(kAxisSlip * kAxisSlip * per_slip) {}

    /// [m^2/s^2] Square of the slip with which a voxel is cut, from that of its centre at a distance rho [m].
    [[nodiscard]] float squared(float of_center, float rho_squared) const {
      const float q = rho_squared * per_edge;
      if (!(q < kAxisZone * kAxisZone)) return of_center;
      const float excess = kPeak * (1 - kZero * q) / (1 + q * q * (kFlat + kSteep * q)) + kFar;
      return std::max(of_center + per_slip * excess, min_squared);
    }
  };

 private:
  // Partial sums per lane, in units of [N m] = l^3 times an energy density; fixed order, so the same bits every time.
  enum Term { kElasticBefore, kElastic, kCutting, kReleased, kDamping, kRubbing, kCredited, kCrushed, kCouple, kTerms };
  struct Sums {
    float of[kTerms][kLanes];

    /// @param turning  [rad/s] of the head's surface, against which the couple does work; 0: the spindle stands
    [[nodiscard]] LawTotals totals(float voxel_volume, float turning, bool may_remove) const {
      const auto total = [&](Term term) {
        double sum = 0;
        for (const float lane : of[term]) sum += double(lane);
        return sum * double(voxel_volume);
      };
      const double couple = turning != 0 ? -total(kCouple) / double(turning) : 0.0;
      return {{total(kElasticBefore), total(kElastic), total(kCutting), total(kReleased), total(kDamping),
               total(kRubbing), total(kCredited), total(kCrushed)},
              couple,
              may_remove};
    }
  };

  /// How the head's surface moves at a sample.
  struct SurfaceMotion {
    float w_dot;       ///< [m/s] of the handpiece along n, which changes the depth
    float tx, ty, tz;  ///< [m/s] the slip: the tangential velocity with the spin
    float extra;       ///< [m^2/s^2] square of the slip less that of the voxel's centre (AxisSlip)
    float inverse_slip, slip;
    float felt_w_dot;  ///< [m/s] for the damping
    float mean_w_dot;  ///< [m/s] for chips
  };
  static SurfaceMotion surface_motion(const HeadMotion& m, const ContactBlock& b, int n, const AxisSlip& axis_slip) {
    const Eigen::Vector3f &v = m.velocity, &o = m.angular_velocity, &h = m.felt_velocity, &a = m.felt_angular_velocity;
    const float x = b.x[n], y = b.y[n], z = b.z[n];
    const float nx = b.normal_x[n], ny = b.normal_y[n], nz = b.normal_z[n];
    SurfaceMotion s;
    const float px = v.x() + o.y() * z - o.z() * y, py = v.y() + o.z() * x - o.x() * z,
                pz = v.z() + o.x() * y - o.y() * x;
    const float along = s.w_dot = px * nx + py * ny + pz * nz;
    s.tx = px - along * nx - m.spin * y, s.ty = py - along * ny + m.spin * x, s.tz = pz - along * nz;
    const float of_center = s.tx * s.tx + s.ty * s.ty + s.tz * s.tz;
    const float slip_squared = axis_slip.squared(of_center, x * x + y * y);
    s.extra = slip_squared - of_center;
    s.inverse_slip = 1.0F / std::sqrt(slip_squared + kSlipRegularization * kSlipRegularization);
    s.slip = slip_squared * s.inverse_slip;
    s.felt_w_dot = (h.x() + a.y() * z - a.z() * y) * nx + (h.y() + a.z() * x - a.x() * z) * ny +
                   (h.z() + a.x() * y - a.y() * x) * nz;
    s.mean_w_dot = along - (m.ripple.x() * nx + m.ripple.y() * ny + m.ripple.z() * nz);
    return s;
  }

  static LawTotals evaluate_parts(const HeadMotion& m, const ContactMaterials& materials, bool spinning, bool cutting,
                                  ContactBlock& b) noexcept {
    const float l = m.voxel_size, dt = m.duration, slip_time = dt * m.level_of_detail, voxel_volume = l * l * l;
    const float feed = (m.velocity - m.ripple).norm();
    const AxisSlip axis_slip(m);
    Sums sums = {};
    for (int n = 0; n < b.lanes(); ++n) {
      b.force_x[n] = b.force_y[n] = b.force_z[n] = 0;
      b.fill_after[n] = b.fill[n];
      if (!(b.fill[n] > 0)) continue;
      const int lane = n % kLanes;
      const SurfaceMotion s = surface_motion(m, b, n, axis_slip);
      const ContactMaterial& material = at_surface(materials[b.material_of(n)], m, b.smooth[n], b.scale_of(n));
      const Damping damping = Damping::of(material.damping * s.felt_w_dot);
      const float damped = damping.factor, crushing_depth = damping.crushing_depth(material.crushing_depth);
      const float k = material.stiffness, advance = s.w_dot * dt;
      const float kappa = spinning ? material.cutting_ratio : 0.0F;
      const float power = 0.5F * kappa * k * damped * s.slip, mean_w_dot = s.mean_w_dot;
      float speed = std::max(0.0F, s.w_dot);
      // 1. The filled part: its section, far plane and height.
      const VoxelSection<float> section(b.max_component[n], b.min_width);
      const float far_plane = (b.depth[n] / l) - section.span() / 2;  // depth of the far corner
      const float full_height = b.top[n] / l - far_plane;
      // 2. Crushing.
      float deepest = crushing_depth;
      if (cutting && m.crushes && b.top[n] > crushing_depth) {  // what can be cut at the strength is not crushed
        const float recedes = ChipChord<float>::recession_at(crushing_depth, material, m.tooth_rate,
                                                             power / material.cutting_energy, mean_w_dot, feed);
        const float cut_speed = std::min(speed, recedes);
        deepest += cut_speed * 0.5F * slip_time;
        if (b.top[n] > deepest) speed = cut_speed;
      }
      const bool crushed = m.crushes && b.top[n] > deepest;
      if (crushed) b.top[n] = deepest;
      const float top = b.top[n], height = crushed ? std::max(0.0F, top / l - far_plane) : full_height;
      float phi = b.fill[n];
      if (crushed) {
        phi = std::min(phi, section.fill_below(height));  // rounding
        if (phi < kMinPart) phi = 0;
        b.fill_after[n] = phi;
      }
      // 3. Chips: energy and threshold of the cut.
      float u = material.cutting_energy;
      auto cut_depth = CutDepth<float>::of(top, material.cutting_depth);
      if (m.tooth_rate > 0) {
        const auto chord =
            ChipChord<float>::of(material, m.tooth_rate, power / u, top, far_plane * l, mean_w_dot, feed);
        u = chord.energy, cut_depth = chord.cut;
      }
      // 4. Springs of the part.
      const DepthIntegrals<float> part = section.integrals(height, top / l, cut_depth.scaled(1 / l));
      if (crushed) b.immersed[n] = part.volume;

      float rubbing = k * l * part.depth, cut = 0, left = phi, credit = 0, price = u;  // springs: [N/m^3]
      float refused = 0;  // [1] fill whose work was done, but which rounding did not remove; or the reverse
      if (cutting && cut_depth.excess > 0 && phi > 0) {
        // 5. Recession of the layer.
        float rate = power / price,
              recession = LayerRecession<float>::of(top, cut_depth, rate, speed, slip_time, m.at_end()).relative;
        if (m.removal == RemovalLaw::elastic_release) {  // helped by what is stored where the layer's top is on average
          const float w0 = cut_depth.threshold, squared = w0 * w0 + recession * cut_depth.excess;
          price = std::max(u - 0.5F * k * squared, kMinEnergyShare * u);
          rate = power / price,
          recession = LayerRecession<float>::of(top, cut_depth, rate, speed, slip_time, m.at_end()).relative;
        }
        // 6. Decay of the fill.
        const float exponent = std::min(2 * rate * l * part.cutting / phi * recession * slip_time, kMaxExponent);
        const float mean = mean_of_decay(exponent);
        cut = k * l * part.cutting * recession * mean;
        rubbing = k * l * std::max(0.0F, part.depth - part.cutting);
        const float loss = phi * exponent * mean;
        left = phi - loss;
        refused = loss - (phi - left);
        if (left < kMinPart && exponent > 0) {
          credit = std::max(0.0F, left);
          left = 0;
        }
        b.fill_after[n] = left;
      }
      const float spring = rubbing + cut, normal = spring * damped, tangential = kappa * normal * s.inverse_slip;
      b.force_x[n] = -voxel_volume * (normal * b.normal_x[n] + tangential * s.tx);
      b.force_y[n] = -voxel_volume * (normal * b.normal_y[n] + tangential * s.ty);
      b.force_z[n] = -voxel_volume * (normal * b.normal_z[n] + tangential * s.tz);

      // 7. Energies before and after: [J/m^3] stored in a part of this height when the far corner has moved
      const auto stored = [&](float part_height, float moved) {
        const float depth = part_height + far_plane + moved / l;
        return depth > 0 ? k * l * l * section.integrals(part_height, depth).energy : 0.0F;
      };
      const float after = left > 0 ? stored(section.height_of(left), (0.5F - m.lead) * advance) : 0.0F;
      const float cut_fill = phi - left, removed = b.fill[n] - left;
      const bool releases = removed > kMinLoss * b.fill[n];
      // Released energy is zero where nothing is cut, and never negative: the error of the midpoint rule is `entered`.
      // The excess force of a contact that is evaluated at the end was not stored before.
      const float stays = after - spring * advance, harder = k * part.volume * m.lead * advance * advance;
      const float strength = 0.5F * k * material.crushing_depth * material.crushing_depth;
      const float released = crushed ? strength * (b.fill[n] - phi)
                             : releases
                                 ? std::max(0.0F, stored(full_height, -(0.5F + m.lead) * advance) - stays - harder)
                                 : 0.0F;
      const float before = stays + released;
      sums.of[kElasticBefore][lane] += before;
      sums.of[kElastic][lane] += after;
      sums.of[kCutting][lane] += u * cut_fill;
      if (crushed || releases) sums.of[crushed ? kCrushed : kReleased][lane] += released - (u - price) * cut_fill;
      sums.of[kDamping][lane] += (normal - spring) * advance;
      sums.of[kRubbing][lane] += kappa * rubbing * damped * s.slip * slip_time + price * std::max(0.0F, refused);
      sums.of[kCredited][lane] += price * (credit + std::max(0.0F, -refused));
      sums.of[kCouple][lane] += tangential * s.extra;
    }
    return sums.totals(voxel_volume, spinning ? m.turning() : 0.0F, cutting || m.crushes);
  }
};

}  // namespace hapticut
