// SPDX-License-Identifier: Apache-2.0
// What is different at smooth surfaces, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SMOOTH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SMOOTH_INL_HPP
#undef HAPTICUT_KERNELS_SMOOTH_INL_HPP
#else
#define HAPTICUT_KERNELS_SMOOTH_INL_HPP
#endif

#include "kernels/press_sums-inl.hpp"
#include "kernels/spring_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// `value`, times kBeta where the surface is smooth.
/// @tparam kSmooth  some of it may be
template <bool kSmooth>
HWY_INLINE Vec scaled(const Sample& s, Vec value) {
  if constexpr (kSmooth) return hn::IfThenElse(s.on_smooth(), value * broadcast(kBeta), value);
  return value;
}

/// The constants at the surface of samples: FoundationLaw::at_surface.
template <bool kSmooth>
[[nodiscard]] HWY_INLINE decltype(auto) material_at(const MaterialVectors& material, [[maybe_unused]] const Sample& s,
                                                    [[maybe_unused]] float voxel_size) {
  if constexpr (kSmooth) {
    MaterialVectors there = material;
    const Mask smooth = s.on_smooth();
    if (hn::AllFalse(Floats(), smooth)) return there;
    const Vec land = hn::Max(material.land, broadcast(2 * voxel_size));
    const Mask slides = hn::And(s.smooth > land * land, smooth);
    const Vec ratio = hn::IfThenElse(slides, material.sliding_ratio, material.cutting_ratio);
    there.cutting_ratio = hn::IfThenElse(smooth, ratio * broadcast(kBeta), ratio);
    there.cutting_depth = hn::IfThenElse(slides, broadcast(ContactMaterial::kNeverCut), material.cutting_depth);
    return there;
  } else {
    return (material);
  }
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
