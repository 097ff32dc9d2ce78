// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// The instruction sets that kernels are compiled for: what the compiler may assume anyway (baseline.cpp), AVX2 and
/// AVX-512, or of these two what HAPTICUT_KERNELS leaves. The sets between them are left out: they gain little and cost
/// compile time. So are those whose vectors have no fixed length, because no class can hold them: what is left for ARM
/// is NEON, for RISC-V plain code.
#ifndef HAPTICUT_KERNELS_LEAVE_OUT
#define HAPTICUT_KERNELS_LEAVE_OUT 0
#endif
#define HAPTICUT_LEFT_OUT                                                                                              \
  (HAPTICUT_KERNELS_LEAVE_OUT | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | \
   HWY_RVV)
