// SPDX-License-Identifier: Apache-2.0
// Prints the file name in src/kernels/targets/ of this machine's best instruction set.
#include <hwy/targets.h>

#include <cstdio>

int main() {
  const auto supported = hwy::SupportedTargets();
  std::fputs((supported & HWY_AVX3) != 0 ? "avx3" : (supported & HWY_AVX2) != 0 ? "avx2" : "baseline", stdout);
}
