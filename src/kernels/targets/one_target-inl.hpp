// SPDX-License-Identifier: Apache-2.0
// The kernels of one instruction set, HAPTICUT_TARGET. Formulas and their reasons: the scalar functions of the same
// names in workpiece/contact.hpp, force/laws/foundation.hpp and force/resultant.hpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/targets/one_target-inl.hpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

// The set that the compiler assumes (with -mavx2, say) is the baseline, and is compiled there.
#if HWY_TARGET == HAPTICUT_TARGET && \
    (defined(HAPTICUT_TARGET_IS_BASELINE) || (HWY_BASELINE_TARGETS & HAPTICUT_TARGET) == 0)
#include "kernels/press_blocks-inl.hpp"
#include "kernels/resultant-inl.hpp"
#include "kernels/sampling-inl.hpp"
#endif
