// SPDX-License-Identifier: Apache-2.0
// Prints which file of src/kernels/targets/ is for the best instruction set of this machine.
#include <hwy/targets.h>

#include <cstdio>

int main() {
  const auto supported = hwy::SupportedTargets();
  std::fputs((supported & HWY_AVX3) != 0 ? "avx3" : (supported & HWY_AVX2) != 0 ? "avx2" : "baseline", stdout);
}
