// SPDX-License-Identifier: Apache-2.0
// The formulas of hapticut/formulas for vectors of voxels; included once per instruction set.
#if defined(HAPTICUT_KERNELS_WIDE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_WIDE_INL_HPP
#undef HAPTICUT_KERNELS_WIDE_INL_HPP
#else
#define HAPTICUT_KERNELS_WIDE_INL_HPP
#endif

#include <hwy/highway.h>

#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/tool/head.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

namespace formulas {

/// Where a comparison is true: the condition of hapticut/formulas/numbers.hpp for a vector.
template <class D>
struct WhereOf {
  hn::Mask<D> m;
  friend HWY_INLINE WhereOf operator&&(WhereOf a, WhereOf b) { return {hn::And(a.m, b.m)}; }
  friend HWY_INLINE WhereOf operator||(WhereOf a, WhereOf b) { return {hn::Or(a.m, b.m)}; }
  friend HWY_INLINE bool all(WhereOf a) { return hn::AllTrue(D(), a.m); }
  friend HWY_INLINE bool any(WhereOf a) { return !hn::AllFalse(D(), a.m); }
};

/// One number for each lane of a vector, with the operators of a number and the words of
/// hapticut/formulas/numbers.hpp.
template <class D>
struct WideOf {
  using Vector = hn::Vec<D>;
  using Condition = WhereOf<D>;
  Vector v;
  WideOf() = default;
  // Formulas mix numbers and vectors. NOLINTBEGIN(google-explicit-constructor)
  HWY_INLINE WideOf(Vector of) : v(of) {}
  HWY_INLINE WideOf(float same) : v(hn::Set(D(), same)) {}
  HWY_INLINE WideOf(double same) : WideOf(float(same)) {}
  HWY_INLINE WideOf(int same) : WideOf(float(same)) {}
  // NOLINTEND(google-explicit-constructor)
  HWY_INLINE static WideOf load(const float* from) { return hn::Load(D(), from); }
  HWY_INLINE void store(float* to) const { hn::Store(v, D(), to); }

  friend HWY_INLINE WideOf operator+(WideOf a, WideOf b) { return a.v + b.v; }
  friend HWY_INLINE WideOf operator-(WideOf a, WideOf b) { return a.v - b.v; }
  friend HWY_INLINE WideOf operator*(WideOf a, WideOf b) { return a.v * b.v; }
  friend HWY_INLINE WideOf operator/(WideOf a, WideOf b) { return a.v / b.v; }
  friend HWY_INLINE WideOf operator-(WideOf a) { return hn::Neg(a.v); }
  friend HWY_INLINE Condition operator<(WideOf a, WideOf b) { return {a.v < b.v}; }
  friend HWY_INLINE Condition operator>(WideOf a, WideOf b) { return {a.v > b.v}; }
  friend HWY_INLINE Condition operator<=(WideOf a, WideOf b) { return {a.v <= b.v}; }
  friend HWY_INLINE Condition operator>=(WideOf a, WideOf b) { return {a.v >= b.v}; }
  friend HWY_INLINE Condition operator==(WideOf a, WideOf b) { return {a.v == b.v}; }
  friend HWY_INLINE Condition operator!=(WideOf a, WideOf b) { return {a.v != b.v}; }
  friend HWY_INLINE WideOf min(WideOf a, WideOf b) { return hn::Min(a.v, b.v); }
  friend HWY_INLINE WideOf max(WideOf a, WideOf b) { return hn::Max(a.v, b.v); }
  friend HWY_INLINE WideOf abs(WideOf a) { return hn::Abs(a.v); }
  friend HWY_INLINE WideOf sqrt(WideOf a) { return hn::Sqrt(a.v); }
  friend HWY_INLINE WideOf select(Condition where, WideOf a, WideOf b) { return hn::IfThenElse(where.m, a.v, b.v); }
  friend HWY_INLINE WideOf reciprocal(WideOf a) { return hn::Set(D(), 1.0F) / a.v; }
  friend HWY_INLINE WideOf inverse_root(WideOf a) {
#if HWY_TARGET <= HWY_AVX3
    // Within two roundings, from an estimate within 2^-14 by one Newton step: faster than a root and a division.
    const Vector guess = hn::ApproximateReciprocalSqrt(a.v);
    const Vector error = hn::NegMulAdd(a.v * guess, guess, hn::Set(D(), 1.0F));
    return hn::MulAdd(hn::Set(D(), 0.5F) * guess, error, guess);
#else
    return hn::Set(D(), 1.0F) / hn::Sqrt(a.v);
#endif
  }
};

#undef HAPTICUT_FORMULA
#define HAPTICUT_FORMULA HWY_INLINE
#include "hapticut/formulas/springs.inl"
//
#include "hapticut/formulas/sphere.inl"
//
#include "hapticut/formulas/cone.inl"
//
#include "hapticut/formulas/flat.inl"
//
#include "hapticut/formulas/curves.inl"
//
#include "hapticut/formulas/vectors.inl"
//
#include "hapticut/formulas/section.inl"
//
#include "hapticut/formulas/recession.inl"
//
#include "hapticut/formulas/chip.inl"
//
#include "hapticut/formulas/surface.inl"
//
#include "hapticut/formulas/part.inl"
//
#include "hapticut/formulas/stiffness.inl"
//
#include "hapticut/formulas/friction.inl"
#undef HAPTICUT_FORMULA
#define HAPTICUT_FORMULA inline

}  // namespace formulas

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
