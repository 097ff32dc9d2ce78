// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// The instruction sets that kernels are compiled for: what the compiler may assume anyway (baseline.cpp), SSE4, AVX2
/// and AVX-512. The sets between them are left out: they gain little and cost compile time. So are those whose vectors
/// have no fixed length, because no class can hold them: what is left for ARM is NEON, for RISC-V plain code. A build
/// for the sanitizers has two of them (HAPTICUT_FEW_TARGETS): vectors that gather and vectors that do not.
#ifdef HAPTICUT_FEW_TARGETS
#define HAPTICUT_LEFT_OUT \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX2 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#else
#define HAPTICUT_LEFT_OUT (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
