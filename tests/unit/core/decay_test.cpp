// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hapticut::decay_test {
namespace {

constexpr double kClaimed = 4e-7;  // relative error that decay.hpp promises

/// 0, and 20 000 numbers with sizes from 1e-30 to 1e6.
std::vector<float> exponents() {
  std::vector<float> all = {0.0F};
  for (int n = 0; n <= 20000; ++n) all.push_back(float(std::pow(10.0, -30 + 36.0 * n / 20000)));
  for (int n = 0; n <= 8000; ++n) all.push_back(float(n) * 0.01F);
  return all;
}

TEST(ExpOfMinus, IsAsExactAsPromisedUpTo80) {
  for (const float x : exponents()) {
    if (x > 80) continue;
    const long double exact = std::exp(-(long double)(x));
    EXPECT_LE(std::abs(double(exp_of_minus(x) / exact - 1)), kClaimed) << "x = " << x;
  }
}

TEST(ExpOfMinus, IsOneAtZeroAndStaysPositiveAndTinyBeyond80) {
  EXPECT_EQ(exp_of_minus(0.0F), 1.0F);
  for (const float x : {80.0F, 81.0F, 1e3F, 1e6F, 1e30F}) {
    EXPECT_GT(exp_of_minus(x), 0);
    EXPECT_LT(exp_of_minus(x), 2e-35F);
  }
}

TEST(MeanOfDecay, IsAsExactAsPromised) {
  for (const float x : exponents()) {
    const long double exact = x == 0 ? 1.0L : -std::expm1(-(long double)(x)) / (long double)(x);
    EXPECT_LE(std::abs(double(mean_of_decay(x) / exact - 1)), kClaimed) << "x = " << x;
  }
}

TEST(MeanOfDecay, NeverGrowsByMoreThanRounding) {
  float before = mean_of_decay(0.0F);
  EXPECT_EQ(before, 1.0F);
  for (int n = 1; n < 100000; ++n) {
    const float now = mean_of_decay(float(n) * 1e-4F);
    EXPECT_LE(now, before * (1 + 2 * float(kClaimed)));
    before = now;
  }
}

}  // namespace
}  // namespace hapticut::decay_test
