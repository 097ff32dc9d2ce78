// SPDX-License-Identifier: Apache-2.0
// The kernels of one instruction set, HAPTICUT_TARGET. Formulas and their reasons: hapticut/formulas.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/targets/one_target-inl.hpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

// The set that the compiler assumes (with -mavx2, say) is the baseline, and is compiled there.
#if HWY_TARGET == HAPTICUT_TARGET && \
    (defined(HAPTICUT_TARGET_IS_BASELINE) || (HWY_BASELINE_TARGETS & HAPTICUT_TARGET) == 0)
#if !defined(__OPTIMIZE__) && !defined(HAPTICUT_TARGET_IS_BASELINE)
#error "the kernels of this instruction set are wrong without optimisation: compile this file with -O1 or more"
#endif
#include "kernels/blocks-inl.hpp"
#include "kernels/points-inl.hpp"
#endif
