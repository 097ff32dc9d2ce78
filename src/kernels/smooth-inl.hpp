// SPDX-License-Identifier: Apache-2.0
// Smooth surfaces, in vectors; included once per instruction set.
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

/// `value`, times `factor` where the surface is smooth.
/// @tparam kSmooth  some of the surface may be smooth
template <bool kSmooth>
HWY_INLINE Vec scaled(const Sample& s, Vec value, float factor) {
  if constexpr (kSmooth) return hn::IfThenElse(s.on_smooth(), value * broadcast(factor), value);
  return value;
}

/// hapticut::distance_below in vectors.
template <bool kSmooth>
HWY_INLINE Vec distance_below(const Sample& s, Vec depth) {
  if constexpr (kSmooth) return hn::Min(depth, scaled<true>(s, depth, 1 / kBeta));
  return depth;
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
    const auto at = [&](Vec value, float factor) HWY_ATTR { return scaled<true>(s, value, factor); };
    there.stiffness = at(material.stiffness, kBeta * kBeta);
    there.damping = at(material.damping, kBeta);
    there.crushing_depth = at(material.crushing_depth, 1 / kBeta);
    there.cutting_ratio = hn::IfThenElse(slides, material.sliding_ratio, material.cutting_ratio);
    there.cutting_depth =
        hn::IfThenElse(slides, broadcast(ContactMaterial::kNeverCut), at(material.cutting_depth, 1 / kBeta));
    return there;
  } else {
    return (material);
  }
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
