// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set by Highway; the set is chosen at run time. Formulas and their reasons: the scalar
// functions of the same names in workpiece/contact.hpp, force/laws/foundation.hpp and force/resultant.hpp.
// The sets between baseline and AVX2 are left out: they gain little and cost compile time. So are those whose vectors
// have no fixed length, because no class can hold them: what is left for ARM is NEON, for RISC-V plain code.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/simd_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "kernels/press_blocks-inl.hpp"
#include "kernels/resultant-inl.hpp"
#include "kernels/sampling-inl.hpp"

#if HWY_ONCE
#include "kernels/kernels.hpp"

namespace hapticut::kernels {

HWY_EXPORT(SampleContact);
HWY_EXPORT(PressBlocks);
HWY_EXPORT(SumResultant);

void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept {
  HWY_DYNAMIC_DISPATCH(SampleContact)(head, block, grid, quadrature, out);
}

void press_blocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                  StiffnessSums* stiffness) noexcept {
  HWY_DYNAMIC_DISPATCH(PressBlocks)(job, tasks, sums, stiffness);
}

void sum_resultant(const ContactBlock& block, Resultant& total) noexcept {
  HWY_DYNAMIC_DISPATCH(SumResultant)(block, total);
}

}  // namespace hapticut::kernels
#endif
