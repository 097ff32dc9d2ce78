// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set by Highway; the set is chosen at run time. Formulas and their reasons: the scalar
// functions of the same names in workpiece/contact.hpp, force/laws/foundation.hpp and force/resultant.hpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/simd_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "kernels/foundation-inl.hpp"
#include "kernels/resultant-inl.hpp"
#include "kernels/sampling-inl.hpp"

#if HWY_ONCE
#include "kernels/kernels.hpp"

namespace hapticut::kernels {

HWY_EXPORT(SampleContact);
HWY_EXPORT(EvaluateFoundation);
HWY_EXPORT(SumResultant);

void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept {
  if (const auto* profile = std::get_if<ProfileHead>(&head.shape()))
    return hapticut::sample_contact(ProfileSprings<float>(profile->table()), block, grid, quadrature, out);
  HWY_DYNAMIC_DISPATCH(SampleContact)(head, block, grid, quadrature, out);
}

LawTotals evaluate_foundation(const HeadMotion& motion, const ContactMaterials& materials,
                              ContactBlock& block) noexcept {
  return HWY_DYNAMIC_DISPATCH(EvaluateFoundation)(motion, materials, block);
}

void sum_resultant(const ContactBlock& block, Resultant& total) noexcept {
  HWY_DYNAMIC_DISPATCH(SumResultant)(block, total);
}

}  // namespace hapticut::kernels
#endif
