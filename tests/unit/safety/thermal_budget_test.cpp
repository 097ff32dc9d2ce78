// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/thermal_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace hapticut::thermal_budget_test {
namespace {

constexpr double kPeriod = 1e-3;

TEST(ThermalBudget, PassesAShortPeakAndLimitsALongOneToTheContinuousForce) {
  ThermalBudget budget(3.3, 0.88, {});
  for (int n = 0; n < 4000; ++n) budget.tick(3.3, 0, kPeriod);
  EXPECT_EQ(budget.limit(), 3.3);
  for (int n = 0; n < 10000; ++n) budget.tick(std::min(3.3, budget.limit()), 0, kPeriod);
  EXPECT_NEAR(budget.limit(), 0.88, 1e-12);
  for (int n = 0; n < 120000; ++n) budget.tick(0, 0, kPeriod);
  EXPECT_EQ(budget.limit(), 3.3);
}

TEST(ThermalBudget, ObeysTheTemperatureThatTheDeviceMeasures) {
  ThermalBudget budget(3.3, 0.88, {});
  budget.tick(2, 0.75, kPeriod);
  EXPECT_NEAR(budget.limit(), 2 * (1 - 1e-3),
              1e-12);  // the maker's factor of 0.999 per tick, starting from the present force
  for (int n = 0; n < 2000; ++n) budget.tick(0, 0.6, kPeriod);
  EXPECT_NEAR(budget.limit(), 0.88, 1e-12);
  budget.tick(0, 0.4, kPeriod);
  EXPECT_NEAR(budget.limit(), 0.88 * (1 + 1e-3), 1e-12);
}

}  // namespace
}  // namespace hapticut::thermal_budget_test
