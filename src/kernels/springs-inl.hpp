// SPDX-License-Identifier: Apache-2.0
// Depth and direction of the material below a head's surface, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SPRINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#undef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#else
#define HAPTICUT_KERNELS_SPRINGS_INL_HPP
#endif

#include <hwy/highway.h>

#include "kernels/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector like `v` with `value` in every lane.
template <class V>
HWY_INLINE V same(V /*v*/, float value) {
  return hn::Set(hn::DFromV<V>(), value);
}

/// Depth and direction at a vector of points (x, y, z). Heads are bodies of revolution: the outward normal lies in the
/// plane through the spindle's axis, n = (x radial, y radial, axial).
template <class V>
struct SpringVectors {
  V depth, radial, axial;
};

constexpr float kLeastSquare = 1e-24F;  // [m^2] keeps the direction on the axis, or in the centre, finite

/// 1/sqrt(v) for v > 0, within two roundings.
template <class V>
HWY_INLINE V inverse_root(V v) {
#if HWY_TARGET <= HWY_AVX3
  // From a guess within 2^-14 by one of Newton's steps: sooner done than a root and a division.
  const V guess = hn::ApproximateReciprocalSqrt(v);
  const V error = hn::NegMulAdd(hn::Mul(v, guess), guess, same(v, 1.0F));
  return hn::MulAdd(hn::Mul(same(v, 0.5F), guess), error, guess);
#else
  return hn::Div(same(v, 1.0F), hn::Sqrt(v));
#endif
}

/// Each shape answers two questions: `at(x, y, z)`, the springs at a vector of points, and `hits(x, y, z, margin)`,
/// which of them may be inside the head grown by a margin [m], as far as can be told without a square root. All normals
/// of a shape that is `kCentral` meet in the head's origin, so that its springs have no torque about it. `kCostly`:
/// springs cost more than the rest of the work on a voxel.
struct SphereVectors {
  static constexpr bool kCentral = true, kCostly = false;
  float radius;
  explicit SphereVectors(const SphereHead& head) : radius(float(head.radius)) {}
  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const float grown = std::max(0.0F, radius + margin);
    return hn::Lt(squared, same(x, grown * grown));
  }
  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const V inverse = inverse_root(hn::Max(squared, same(x, kLeastSquare)));
    return {hn::NegMulAdd(squared, inverse, same(x, radius)), inverse, hn::Mul(z, inverse)};
  }
};

struct ConeVectors {
  static constexpr bool kCentral = false, kCostly = false;
  float sine, cosine, height;
  explicit ConeVectors(const ConeHead& head)
      : sine(float(std::sin(head.half_angle))), cosine(float(std::cos(head.half_angle))), height(float(head.height)) {}
  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V edge = hn::MulAdd(z, same(x, sine / cosine), same(x, margin / cosine));
    const V squared = hn::MulAdd(x, x, hn::Mul(y, y));
    return hn::And(hn::Lt(squared, hn::Mul(edge, edge)),
                   hn::And(hn::Gt(edge, hn::Zero(hn::DFromV<V>())), hn::Lt(z, same(x, height + margin))));
  }
  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V squared = hn::MulAdd(x, x, hn::Mul(y, y));
    const V radial = hn::Mul(same(x, cosine), inverse_root(hn::Max(squared, same(x, kLeastSquare))));
    const V depth = hn::MulSub(z, same(x, sine), hn::Mul(squared, radial));
    const auto below_base = hn::Lt(z, same(x, height));
    return {hn::IfThenElseZero(below_base, depth), radial, same(x, -sine)};
  }
};

template <FlatRule kRule>
struct FlatVectors {
  static constexpr bool kCentral = false, kCostly = false;
  float radius, height;
  explicit FlatVectors(const FlatHead& head) : radius(float(head.radius)), height(float(head.height)) {}
  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V squared = hn::MulAdd(x, x, hn::Mul(y, y));
    const float grown = std::max(0.0F, radius + margin);
    return hn::And(hn::Lt(squared, same(x, grown * grown)),
                   hn::And(hn::Gt(z, same(x, -margin)), hn::Lt(z, same(x, height + margin))));
  }
  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V zero = same(x, 0.0F);
    const V squared = hn::MulAdd(x, x, hn::Mul(y, y));
    const V inverse = inverse_root(hn::Max(squared, same(x, kLeastSquare)));
    const V side = hn::NegMulAdd(squared, inverse, same(x, radius));
    const auto inside = hn::Gt(hn::Min(hn::Min(z, hn::Sub(same(x, height), z)), side), zero);
    if constexpr (kRule == FlatRule::bottom_only) {
      return {hn::IfThenElseZero(inside, z), zero, same(x, -1.0F)};
    } else if constexpr (kRule == FlatRule::side_only) {
      return {hn::IfThenElseZero(inside, side), inverse, zero};
    } else if constexpr (kRule == FlatRule::both) {
      const V depth_squared = hn::MulAdd(side, side, hn::Mul(z, z));
      const V share = inverse_root(hn::Max(depth_squared, same(x, kLeastSquare)));
      return {hn::IfThenElseZero(inside, hn::Mul(depth_squared, share)), hn::Mul(hn::Mul(side, share), inverse),
              hn::Neg(hn::Mul(z, share))};
    } else {
      const auto on_side = hn::Lt(side, z);
      return {hn::IfThenElseZero(inside, hn::Min(side, z)), hn::IfThenElseZero(on_side, inverse),
              hn::IfThenZeroElse(on_side, same(x, -1.0F))};
    }
  }
};

/// The curve of its cell for every point: see ProfileSprings.
struct ProfileVectors {
  static constexpr bool kCentral = false, kCostly = true;
  ProfileSprings<float> table;
  explicit ProfileVectors(const ProfileHead& head) : table(head.table()) {}

  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V squared = hn::MulAdd(x, x, hn::Mul(y, y));
    const float grown = margin < 0 ? 0.0F : table.radius + margin;  // the inside of its cylinder is not its own
    return hn::And(hn::Lt(squared, same(x, grown * grown)),
                   hn::And(hn::Gt(z, same(x, table.bottom - margin)), hn::Lt(z, same(x, table.top + margin))));
  }

  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const hn::DFromV<V> d;
    const hn::RebindToSigned<hn::DFromV<V>> ints;
    const V squared = hn::MulAdd(x, x, hn::Mul(y, y));
    const V inverse_rho = inverse_root(hn::Max(squared, same(x, kLeastSquare)));
    const V rho = hn::Mul(squared, inverse_rho);
    const auto zero = hn::Zero(ints);
    const V scale = same(x, table.cells_per_length);
    const auto column = hn::Min(floor_of(hn::Mul(rho, scale)), hn::Set(ints, table.columns - 1));
    const auto row =
        hn::Min(floor_of(hn::Mul(hn::Sub(z, same(x, table.bottom)), scale)), hn::Set(ints, table.rows - 1));
    const auto bounded = hn::And(hn::Lt(rho, same(x, table.radius)),
                                 hn::And(hn::Gt(z, same(x, table.bottom)), hn::Lt(z, same(x, table.top))));
    const auto within = hn::RebindMask(ints, bounded);
    const auto index = hn::IfThenElseZero(within, hn::Add(hn::Mul(row, hn::Set(ints, table.columns)), column));
    const auto cell =
        hn::IfThenElseZero(within, hn::GatherIndex(ints, reinterpret_cast<const std::int32_t*>(table.cells), index));
    const auto curve_bits = hn::Set(ints, std::int32_t(ProfileCell::kMostCurves - 1));
    const auto rule = hn::ShiftRight<28>(cell);

    Meridian<V> spring = below(hn::And(cell, curve_bits), rho, z);
    const auto first_only = hn::Eq(rule, zero);
    if (!hn::AllTrue(ints, first_only)) {
      const auto other = hn::And(hn::ShiftRight<14>(cell), curve_bits);
      const Meridian<V> second = below(other, rho, z);
      const auto is = [&](CellRule r) HWY_ATTR { return hn::RebindMask(d, hn::Eq(rule, hn::Set(ints, int(r)))); };
      // second.depth - spring.depth has the sign of:
      const V deeper = hn::MulSub(second.twice, hn::Add(same(x, 1.0F), spring.root),
                                  hn::MulAdd(spring.twice, second.root, spring.twice));
      const auto nearer = hn::And(is(CellRule::nearer), hn::Lt(deeper, hn::Zero(d)));
      const auto farther = hn::And(is(CellRule::farther), hn::Gt(deeper, hn::Zero(d)));
      const auto beyond = hn::And(is(CellRule::sides), hn::Ge(second.along, hn::Zero(d)));
      const auto take = hn::Or(hn::Or(nearer, farther), beyond);
      const auto shut = hn::And(is(CellRule::gate), hn::Le(second.twice, hn::Zero(d)));
      spring.twice = hn::IfThenZeroElse(shut, hn::IfThenElse(take, second.twice, spring.twice));
      spring.root = hn::IfThenElse(take, second.root, spring.root);
      spring.inverse_root = hn::IfThenElse(take, second.inverse_root, spring.inverse_root);
      spring.g_rho = hn::IfThenElse(take, second.g_rho, spring.g_rho);
      spring.g_z = hn::IfThenElse(take, second.g_z, spring.g_z);
    }
    return {hn::Div(spring.twice, hn::Add(same(x, 1.0F), spring.root)),
            hn::Mul(hn::Mul(spring.g_rho, spring.inverse_root), inverse_rho), hn::Mul(spring.g_z, spring.inverse_root)};
  }

 private:
  template <class V>
  struct Meridian {
    V twice, root;  // depth = twice / (1 + root)
    V g_rho, g_z;   // direction = g / root
    V inverse_root;
    V along;  // [m] beyond the curve's starting point, towards the shank
  };

  /// Whole part of 0 <= v < 2^22; of a whole number that, or one less. From 2^23 on the last bit is the unit.
  template <class V>
  HWY_INLINE static auto floor_of(V v) {
    const hn::RebindToSigned<hn::DFromV<V>> ints;
    constexpr float kUnit = 12582912.0F;  // 2^23 + 2^22: room for v - 0.5 < 0
    const V sum = hn::Add(hn::Sub(v, same(v, 0.5F)), same(v, kUnit));
    return hn::Sub(hn::BitCast(ints, sum), hn::BitCast(ints, same(v, kUnit)));
  }

  /// `ProfileSprings::below` for a vector of curves.
  template <class I, class V>
  HWY_INLINE Meridian<V> below(I curve, V rho, V z) const {
    const hn::DFromV<V> d;
    const hn::DFromV<I> ints;
    const std::int32_t one = hn::GetLane(curve);
    V p_rho, p_z, m_rho, m_z, k;
    if (table.curve_count <= hn::MaxLanes(d)) {
      // The numbers of all curves fit into a vector each: no need to gather them from memory.
      const auto order = hn::IndicesFromVec(d, curve);
      const auto of_curve = [&](const float* all) HWY_ATTR { return hn::TableLookupLanes(hn::LoadU(d, all), order); };
      p_rho = of_curve(table.rho), p_z = of_curve(table.z);
      m_rho = of_curve(table.normal_rho), m_z = of_curve(table.normal_z);
      k = of_curve(table.curvature);
    } else if (hn::AllTrue(ints, hn::Eq(curve, hn::Set(ints, one)))) {
      p_rho = hn::Set(d, table.rho[one]), p_z = hn::Set(d, table.z[one]);
      m_rho = hn::Set(d, table.normal_rho[one]), m_z = hn::Set(d, table.normal_z[one]);
      k = hn::Set(d, table.curvature[one]);
    } else {
      p_rho = hn::GatherIndex(d, table.rho, curve), p_z = hn::GatherIndex(d, table.z, curve);
      m_rho = hn::GatherIndex(d, table.normal_rho, curve), m_z = hn::GatherIndex(d, table.normal_z, curve);
      k = hn::GatherIndex(d, table.curvature, curve);
    }
    const V q_rho = hn::Sub(rho, p_rho), q_z = hn::Sub(z, p_z);
    const V inward = hn::MulAdd(m_rho, q_rho, hn::Mul(m_z, q_z));
    const V twice = hn::NegMulAdd(k, hn::MulAdd(q_rho, q_rho, hn::Mul(q_z, q_z)), hn::Add(inward, inward));
    const V g_rho = hn::MulSub(k, q_rho, m_rho), g_z = hn::MulSub(k, q_z, m_z);
    const V squared = hn::MulAdd(g_rho, g_rho, hn::Mul(g_z, g_z));
    const V inverse = inverse_root(hn::Max(squared, same(z, kLeastSquare)));
    return {twice, hn::Mul(squared, inverse), g_rho, g_z, inverse, hn::NegMulAdd(m_rho, q_z, hn::Mul(m_z, q_rho))};
  }
};

/// Calls `function(springs)` with the vector springs of the head's shape.
template <class Function>
HWY_INLINE auto visit_springs(const ToolHead& head, const Function& function) {
  const ToolHead::Shape& shape = head.shape();
  if (const auto* sphere = std::get_if<SphereHead>(&shape)) return function(SphereVectors(*sphere));
  if (const auto* cone = std::get_if<ConeHead>(&shape)) return function(ConeVectors(*cone));
  if (const auto* profile = std::get_if<ProfileHead>(&shape)) return function(ProfileVectors(*profile));
  const FlatHead& flat = *std::get_if<FlatHead>(&shape);
  switch (flat.rule) {
    case FlatRule::bottom_only:
      return function(FlatVectors<FlatRule::bottom_only>(flat));
    case FlatRule::side_only:
      return function(FlatVectors<FlatRule::side_only>(flat));
    case FlatRule::both:
      return function(FlatVectors<FlatRule::both>(flat));
    case FlatRule::nearest:
      break;
  }
  return function(FlatVectors<FlatRule::nearest>(flat));
}

/// Component `kShift / 10` of packed centroid offsets, in voxel edges.
template <int kShift, class Words>
HWY_INLINE auto centroid_component(Words packed) {
  const hn::Rebind<float, hn::DFromV<Words>> floats;
  const auto steps = hn::ShiftRight<22>(hn::ShiftLeft<22 - kShift>(packed));
  return hn::Mul(hn::ConvertTo(floats, steps), hn::Set(floats, 1.0F / CentroidOffset::kSteps));
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
