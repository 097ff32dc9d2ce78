// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/tool.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::tool_test {
namespace {

using units::mm;

TEST(Tool, RefusesABadHeadHandleOrSpindle) {
  EXPECT_THROW(Tool(SphereHead{0}), Error);
  EXPECT_THROW(Tool(SphereHead{1 * mm}, RayHandle{-1}), Error);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity})
    EXPECT_THROW(Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{bad * units::rad_per_s}), Error) << bad;
  for (const double bad : {0.0, -1.0, nan})
    EXPECT_THROW(Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{100 * units::rad_per_s, bad}), Error) << bad;
}

}  // namespace
}  // namespace hapticut::tool_test
