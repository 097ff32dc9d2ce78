// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>

#ifdef HAPTICUT_BENCH_SIMD
#include <hwy/targets.h>
#endif

/// @file
/// The kernels that a benchmark measures: the best of this machine, or AVX2 where it would choose AVX-512.
namespace hapticut::bench {

/// Obeys the environment variable HAPTICUT_BENCH_KERNELS, which may be avx2. To be called before all else.
/// @return name of the instruction set; null, with a message, when the request cannot be met
inline const char* choose_kernels() {
  const char* request = std::getenv("HAPTICUT_BENCH_KERNELS");
  const std::string_view wanted = request == nullptr ? "" : request;
#ifdef HAPTICUT_BENCH_SIMD
  if (wanted == "avx2") hwy::DisableTargets(~std::int64_t(HWY_STATIC_TARGET | HWY_AVX2));
  const bool met = wanted.empty() || (wanted == "avx2" && (hwy::SupportedTargets() & HWY_AVX2) != 0);
  if (met && (hwy::SupportedTargets() & HWY_AVX3) != 0) return "AVX-512";
  if (met) return (hwy::SupportedTargets() & HWY_AVX2) != 0 ? "AVX2" : "the baseline";
#else
  if (wanted.empty()) return "scalar";
#endif
  std::fprintf(stderr, "HAPTICUT_BENCH_KERNELS = %s: only avx2 is known, where processor and build have it.\n",
               request);
  return nullptr;
}

}  // namespace hapticut::bench
