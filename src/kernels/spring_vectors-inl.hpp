// SPDX-License-Identifier: Apache-2.0
// A vector of springs, and the root that directions need; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SPRING_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SPRING_VECTORS_INL_HPP
#undef HAPTICUT_KERNELS_SPRING_VECTORS_INL_HPP
#else
#define HAPTICUT_KERNELS_SPRING_VECTORS_INL_HPP
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
  V smooth;  // [m^2] MeridianSpring::smooth
};

/// MeridianSpring::smooth of points at these distances from a corner.
template <class V>
HWY_INLINE V square_from_corner(V along_rho, V along_z) {
  return hn::MulAdd(along_rho, along_rho, hn::MulAdd(along_z, along_z, same(along_z, 1e-24F)));
}

constexpr float kBeta = float(kSmoothScale);

/// hapticut::depth_below in vectors.
template <class V>
HWY_INLINE V depth_below(V distance, V scale) {
  return hn::Max(distance, scale * distance);
}

/// hapticut::depth_below_both in vectors.
template <class V>
HWY_INLINE V depth_below_both(V one, V other) {
  const hn::DFromV<V> d;
  const auto outside = hn::Max(one, other) < hn::Zero(d);
  const V lesser = hn::Min(one, other);
  if (hn::AllFalse(d, outside)) return lesser;
  return hn::IfThenElse(outside, hn::Neg(hn::Sqrt(hn::MulAdd(one, one, other * other))), lesser);
}

constexpr float kFarOutside = -1;     // [m] where there is no surface near
constexpr float kMinSquare = 1e-24F;  // [m^2] keeps the direction on the axis, or in the centre, finite

/// 1/sqrt(v) for v > 0, within two roundings.
template <class V>
HWY_INLINE V inverse_root(V v) {
#if HWY_TARGET <= HWY_AVX3
  // From an estimate within 2^-14 by one Newton step, which is faster than a root and a division.
  const V guess = hn::ApproximateReciprocalSqrt(v);
  const V error = hn::NegMulAdd(v * guess, guess, same(v, 1.0F));
  return hn::MulAdd(same(v, 0.5F) * guess, error, guess);
#else
  return same(v, 1.0F) / hn::Sqrt(v);
#endif
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
