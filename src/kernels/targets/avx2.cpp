// SPDX-License-Identifier: Apache-2.0
// The kernels for AVX2.
#include "kernels/targets/which.hpp"
//
#define HAPTICUT_TARGET HWY_AVX2
#define HWY_DISABLED_TARGETS (HAPTICUT_LEFT_OUT | HWY_AVX3)
#include "kernels/targets/one_target-inl.hpp"
