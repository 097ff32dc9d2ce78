// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

/// @file
/// Exponential decay for the removal of material, without the C library. It is branch-free, so that compilers vectorise
/// it, and gives the same bits on every machine.
namespace hapticut {

/// e^-x for x >= 0, relative error below 4e-7; e^-80 for all x > 80.
[[nodiscard]] inline float exp_of_minus(float x) {
  x = x < 80.0F ? x : 80.0F;
  // e^-x = 2^-n * e^-g with whole n and 0 <= g < ln 2; ln 2 in two parts keeps g exact.
  const auto n = std::int32_t(x * 1.44269504F);
  const float g = x - float(n) * 0.693359375F - float(n) * -2.12194440e-4F;
  float p = 1.0F / 40320;
  p = 1.0F / 5040 - p * g;
  p = 1.0F / 720 - p * g;
  p = 1.0F / 120 - p * g;
  p = 1.0F / 24 - p * g;
  p = 1.0F / 6 - p * g;
  p = 0.5F - p * g;
  p = 1.0F - p * g;
  p = 1.0F - p * g;
  return p * std::bit_cast<float>((127 - n) << 23);
}

/// Mean of e^-s over 0 <= s <= x: (1 - e^-x)/x, 1 for x = 0. For x >= 0, relative error below 4e-7.
[[nodiscard]] inline float mean_of_decay(float x) {
  float series = 1.0F / 362880;
  series = 1.0F / 40320 - series * x;
  series = 1.0F / 5040 - series * x;
  series = 1.0F / 720 - series * x;
  series = 1.0F / 120 - series * x;
  series = 1.0F / 24 - series * x;
  series = 1.0F / 6 - series * x;
  series = 0.5F - series * x;
  series = 1.0F - series * x;
  const float safe = x < 0.5F ? 0.5F : x;
  const float quotient = (1.0F - exp_of_minus(safe)) / safe;
  return x < 0.5F ? series : quotient;
}

}  // namespace hapticut
