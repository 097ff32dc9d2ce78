// SPDX-License-Identifier: Apache-2.0
// FoundationLaw in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_FOUNDATION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_FOUNDATION_INL_HPP
#undef HAPTICUT_KERNELS_FOUNDATION_INL_HPP
#else
#define HAPTICUT_KERNELS_FOUNDATION_INL_HPP
#endif

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

/// (1 - e^-x)/x for x >= 0, as in core/decay.hpp.
HWY_INLINE Vec MeanOfDecay(Vec x) {
  const Floats d;
  const hn::RebindToSigned<Floats> ints;
  const Vec one = broadcast(1.0F);
  const auto horner = [](Vec p, Vec t, float next) HWY_ATTR { return hn::NegMulAdd(p, t, broadcast(next)); };

  Vec series = broadcast(1.0F / 362880);
  for (const float c : {1.0F / 40320, 1.0F / 5040, 1.0F / 720, 1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F})
    series = horner(series, x, c);
  const Mask small = hn::Lt(x, broadcast(0.5F));
  if (hn::AllTrue(d, small)) return series;

  const Vec safe = hn::Max(x, broadcast(0.5F));
  const Vec bounded = hn::Min(safe, broadcast(80.0F));
  const auto n = hn::ConvertTo(ints, hn::Mul(bounded, broadcast(1.44269504F)));
  const Vec whole = hn::ConvertTo(d, n);
  const Vec g =
      hn::NegMulAdd(whole, broadcast(-2.12194440e-4F), hn::NegMulAdd(whole, broadcast(0.693359375F), bounded));
  Vec p = broadcast(1.0F / 40320);
  for (const float c : {1.0F / 5040, 1.0F / 720, 1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F, 1.0F})
    p = horner(p, g, c);
  const auto exponent = hn::ShiftLeft<23>(hn::Sub(hn::Set(ints, 127), n));
  const Vec exp_of_minus = hn::Mul(p, hn::BitCast(d, exponent));
  return hn::IfThenElse(small, series, hn::Div(hn::Sub(one, exp_of_minus), safe));
}

/// Material constants of the lanes of one vector.
struct MaterialVectors {
  Vec stiffness, damping, cutting_ratio, energy, inverse_energy, cutting_depth;

  HWY_INLINE explicit MaterialVectors(const ContactMaterial& m)
      : stiffness(broadcast(m.stiffness)),
        damping(broadcast(m.damping)),
        cutting_ratio(broadcast(m.cutting_ratio)),
        energy(broadcast(m.cutting_energy)),
        inverse_energy(broadcast(1.0F / m.cutting_energy)),
        cutting_depth(broadcast(m.cutting_depth)) {}

  HWY_INLINE MaterialVectors(const ContactMaterials& table, const MaterialId* ids) {
    alignas(64) float lanes[6][kWidth];
    for (std::size_t i = 0; i < kWidth; ++i) {
      const ContactMaterial& m = table[ids[i]];
      lanes[0][i] = m.stiffness;
      lanes[1][i] = m.damping;
      lanes[2][i] = m.cutting_ratio;
      lanes[3][i] = m.cutting_energy;
      lanes[4][i] = 1.0F / m.cutting_energy;
      lanes[5][i] = m.cutting_depth;
    }
    const Floats d;
    stiffness = hn::Load(d, lanes[0]);
    damping = hn::Load(d, lanes[1]);
    cutting_ratio = hn::Load(d, lanes[2]);
    energy = hn::Load(d, lanes[3]);
    inverse_energy = hn::Load(d, lanes[4]);
    cutting_depth = hn::Load(d, lanes[5]);
  }
};

enum class Mode { standing, rubbing, cutting };  // spindle stands; turns with removal off; turns and cuts

template <Mode kMode, bool kDamped, bool kUniform>
HWY_INLINE LawTotals EvaluateRows(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) {
  const Floats d;
  const float volume = m.voxel_size * m.voxel_size * m.voxel_size;
  const Vec zero = hn::Zero(d), one = broadcast(1.0F), half = broadcast(0.5F), dt = broadcast(m.duration);
  const Vec minus_volume = broadcast(-volume), spin = broadcast(m.spin);
  const Vec vx = broadcast(m.velocity.x()), vy = broadcast(m.velocity.y()), vz = broadcast(m.velocity.z());
  const Vec ox = broadcast(m.angular_velocity.x()), oy = broadcast(m.angular_velocity.y()),
            oz = broadcast(m.angular_velocity.z());
  const Vec axis_zone = broadcast(FoundationLaw::axis_zone_factor(m));
  const Vec axis_slip_squared = broadcast(FoundationLaw::axis_slip_squared(m));
  const bool release = m.removal == RemovalLaw::elastic_release;
  const MaterialVectors uniform(materials[b.one_material]);

  LaneSum elastic, cut, released, damping, rubbing, credited, couple;
  for (int row = 0; row < b.rows; ++row)
    for (std::size_t part = 0; part < kParts; ++part) {
      const std::size_t n = std::size_t(row) * kLanes + part * kWidth;
      const MaterialVectors material = kUniform ? uniform : MaterialVectors(materials, &b.material[n]);
      const Vec k = material.stiffness, w = hn::Load(d, &b.depth[n]), phi = hn::Load(d, &b.fill[n]);
      const Vec x = hn::Load(d, &b.x[n]), y = hn::Load(d, &b.y[n]), z = hn::Load(d, &b.z[n]);
      const Vec nx = hn::Load(d, &b.normal_x[n]), ny = hn::Load(d, &b.normal_y[n]), nz = hn::Load(d, &b.normal_z[n]);

      const Vec px = hn::NegMulAdd(oz, y, hn::MulAdd(oy, z, vx));
      const Vec py = hn::NegMulAdd(ox, z, hn::MulAdd(oz, x, vy));
      const Vec pz = hn::NegMulAdd(oy, x, hn::MulAdd(ox, y, vz));
      const Vec w_dot = hn::MulAdd(px, nx, hn::MulAdd(py, ny, hn::Mul(pz, nz)));

      Vec damped = one;
      if constexpr (kDamped) {
        const Vec hx =
            hn::MulAdd(broadcast(m.felt_angular_velocity.y()), z,
                       hn::NegMulAdd(broadcast(m.felt_angular_velocity.z()), y, broadcast(m.felt_velocity.x())));
        const Vec hy =
            hn::MulAdd(broadcast(m.felt_angular_velocity.z()), x,
                       hn::NegMulAdd(broadcast(m.felt_angular_velocity.x()), z, broadcast(m.felt_velocity.y())));
        const Vec hz =
            hn::MulAdd(broadcast(m.felt_angular_velocity.x()), y,
                       hn::NegMulAdd(broadcast(m.felt_angular_velocity.y()), x, broadcast(m.felt_velocity.z())));
        const Vec felt = hn::MulAdd(hx, nx, hn::MulAdd(hy, ny, hn::Mul(hz, nz)));
        damped = hn::Max(zero, hn::MulAdd(material.damping, felt, one));
      }

      Vec left = phi, mean_fill = phi;
      const Vec stiff_depth = hn::Mul(k, w);
      const Vec advance = hn::Mul(w_dot, dt);
      Vec fx, fy, fz, spring, normal;
      if constexpr (kMode == Mode::standing) {
        spring = hn::Mul(stiff_depth, phi);
        normal = hn::Mul(spring, damped);
        const Vec f = hn::Mul(minus_volume, normal);
        fx = hn::Mul(f, nx), fy = hn::Mul(f, ny), fz = hn::Mul(f, nz);
      } else {
        const Vec tx = hn::NegMulAdd(spin, y, hn::NegMulAdd(w_dot, nx, px));
        const Vec ty = hn::MulAdd(spin, x, hn::NegMulAdd(w_dot, ny, py));
        const Vec tz = hn::NegMulAdd(w_dot, nz, pz);
        const Vec near_axis = hn::Max(zero, hn::NegMulAdd(hn::MulAdd(x, x, hn::Mul(y, y)), axis_zone, one));
        const Vec extra = hn::Mul(axis_slip_squared, hn::Mul(near_axis, near_axis));
        const Vec slip_squared = hn::MulAdd(tx, tx, hn::MulAdd(ty, ty, hn::MulAdd(tz, tz, extra)));
        constexpr float kRegular = FoundationLaw::kSlipRegularization * FoundationLaw::kSlipRegularization;
        const Vec inverse_slip = hn::Div(one, hn::Sqrt(hn::Add(slip_squared, broadcast(kRegular))));
        const Vec slip = hn::Mul(slip_squared, inverse_slip);
        const Vec kappa = material.cutting_ratio;

        Mask is_cut = hn::MaskFromVec(zero);
        if constexpr (kMode == Mode::cutting) {
          is_cut = hn::Gt(w, material.cutting_depth);
          const Vec stored = hn::Mul(hn::Mul(half, stiff_depth), w);
          const Vec u = material.energy;
          const Vec rate =
              hn::IfThenElseZero(is_cut, hn::Mul(hn::Mul(kappa, stiff_depth), hn::Mul(damped, hn::Mul(slip, dt))));
          Vec price = u, exponent;
          if (release) {
            price = hn::Max(hn::Sub(u, stored), hn::Mul(u, broadcast(FoundationLaw::kLeastEnergyShare)));
            exponent = hn::Div(rate, price);
          } else {
            exponent = hn::Mul(rate, material.inverse_energy);
          }
          exponent = hn::Min(exponent, broadcast(FoundationLaw::kLargestExponent));
          mean_fill = hn::Mul(phi, MeanOfDecay(exponent));
          const Vec loss = hn::Mul(mean_fill, exponent);
          left = hn::Sub(phi, loss);
          const Mask finished = hn::And(hn::Lt(left, broadcast(kSmallestFill)), hn::Gt(exponent, zero));
          const Vec credit = hn::IfThenElseZero(finished, left);
          left = hn::IfThenZeroElse(finished, left);
          const Vec taken = hn::Add(loss, credit);
          const Vec squares = hn::MulAdd(w, w, hn::Mul(broadcast(0.25F), hn::Mul(advance, advance)));
          const Vec lag = hn::Sub(hn::NegMulAdd(half, taken, phi), mean_fill);
          const Vec let_go =
              hn::NegMulAdd(hn::Mul(stiff_depth, advance), lag, hn::Mul(hn::Mul(half, k), hn::Mul(squares, taken)));
          cut.part[part] = hn::MulAdd(u, taken, cut.part[part]);
          released.part[part] = hn::Add(released.part[part], hn::NegMulAdd(hn::Sub(u, price), taken, let_go));
          credited.part[part] = hn::MulAdd(price, credit, credited.part[part]);
        }
        spring = hn::Mul(stiff_depth, mean_fill);
        normal = hn::Mul(spring, damped);
        const Vec tangential = hn::Mul(kappa, hn::Mul(normal, inverse_slip));
        fx = hn::Mul(minus_volume, hn::MulAdd(normal, nx, hn::Mul(tangential, tx)));
        fy = hn::Mul(minus_volume, hn::MulAdd(normal, ny, hn::Mul(tangential, ty)));
        fz = hn::Mul(minus_volume, hn::MulAdd(normal, nz, hn::Mul(tangential, tz)));
        const Vec rubbed = hn::Mul(hn::Mul(tangential, slip_squared), dt);
        rubbing.part[part] = hn::Add(rubbing.part[part], hn::IfThenZeroElse(is_cut, rubbed));
        couple.part[part] = hn::MulAdd(tangential, extra, couple.part[part]);
      }
      hn::Store(fx, d, &b.force_x[n]);
      hn::Store(fy, d, &b.force_y[n]);
      hn::Store(fz, d, &b.force_z[n]);
      hn::Store(left, d, &b.fill_after[n]);

      const Vec w_end = hn::Max(zero, hn::MulAdd(half, advance, w));
      elastic.part[part] = hn::MulAdd(hn::Mul(hn::Mul(half, k), left), hn::Mul(w_end, w_end), elastic.part[part]);
      if constexpr (kDamped) damping.part[part] = hn::MulAdd(hn::Sub(normal, spring), advance, damping.part[part]);
    }
  const double l3 = double(volume);
  const double spin_couple = kMode == Mode::standing ? 0.0 : -couple.total() * l3 / double(m.spin);
  return {{elastic.total() * l3, cut.total() * l3, released.total() * l3, damping.total() * l3, rubbing.total() * l3,
           credited.total() * l3},
          spin_couple,
          kMode == Mode::cutting};
}

template <Mode kMode>
HWY_INLINE LawTotals EvaluateMode(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) {
  if (!b.uniform) return EvaluateRows<kMode, true, false>(m, materials, b);
  if (materials[b.one_material].damping != 0) return EvaluateRows<kMode, true, true>(m, materials, b);
  return EvaluateRows<kMode, false, true>(m, materials, b);
}

inline HWY_ATTR LawTotals EvaluateFoundation(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) {
  if (m.spin == 0) return EvaluateMode<Mode::standing>(m, materials, b);
  if (m.removal == RemovalLaw::none) return EvaluateMode<Mode::rubbing>(m, materials, b);
  return EvaluateMode<Mode::cutting>(m, materials, b);
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
