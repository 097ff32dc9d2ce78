// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The instruction sets that kernels are compiled for: the one that the compiler assumes anyway (baseline.cpp), AVX2
/// and AVX-512, unless HAPTICUT_KERNELS excludes one. The sets between them are left out: they gain little and cost
/// compile time. Sets with vectors of variable length are left out too, because no class can have such members; so ARM
/// uses NEON, and RISC-V plain code.
#ifndef HAPTICUT_KERNELS_LEAVE_OUT
#define HAPTICUT_KERNELS_LEAVE_OUT 0
#endif
#define HAPTICUT_LEFT_OUT                                                                                              \
  (HAPTICUT_KERNELS_LEAVE_OUT | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | \
   HWY_RVV)
