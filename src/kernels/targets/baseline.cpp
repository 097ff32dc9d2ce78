// SPDX-License-Identifier: Apache-2.0
// The kernels for the instruction set that the compiler assumes.
#include "kernels/targets/which.hpp"
//
#define HAPTICUT_TARGET HWY_STATIC_TARGET
#define HAPTICUT_TARGET_IS_BASELINE
#define HWY_DISABLED_TARGETS HAPTICUT_LEFT_OUT
#define HWY_COMPILE_ONLY_STATIC
#include "kernels/targets/one_target-inl.hpp"
