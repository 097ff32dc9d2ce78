// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"
#include "support/refusal.hpp"

/// @file
/// Published drilling tests, and what the advice on a fit says.
namespace hapticut::test {

/// Hillery and Shuaib 1999: 3.2 mm, 50 mm/min, thrust and torque at 400 and at 2000 rpm.
inline std::vector<DrillingTest> drillings_of_hillery() {
  using namespace units;
  constexpr double kFeed = 50.0 / 60 * mm;
  return {{1.6 * mm, 400 * rpm, kFeed, 48, 14.5 * N_mm}, {1.6 * mm, 2000 * rpm, kFeed, 24, 10 * N_mm}};
}

inline void expect_sentence(const Calibration& c, const std::string& words) { expect_part(advice_on(c), words); }

inline void expect_no_sentence(const Calibration& c, const std::string& words) {
  EXPECT_FALSE(contains(advice_on(c), words)) << advice_on(c);
}

}  // namespace hapticut::test
