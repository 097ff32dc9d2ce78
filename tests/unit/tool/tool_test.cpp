// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/tool.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::tool_test {
namespace {

using units::mm;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Tool, StandsStillOnAHandleWithoutLengthUnlessToldOtherwise) {
  const Tool tool(SphereHead{1 * mm});
  EXPECT_EQ(tool.spindle().speed, 0);
  EXPECT_EQ(tool.X_HT().translation, Vec3::Zero());
  EXPECT_EQ(tool.X_HT().rotation, Mat3::Identity());
}

TEST(Tool, KeepsThePoseOfItsHeadOnTheHandle) {
  const LHandle handle = {5 * mm, 2 * mm, 0.4};
  const Tool tool(FlatHead{1 * mm, 2 * mm}, handle, Spindle{1000 * units::rad_per_s});
  EXPECT_EQ(tool.X_HT().translation, head_in_handle(handle).translation);
  EXPECT_EQ(tool.X_HT().rotation, head_in_handle(handle).rotation);
  EXPECT_EQ(tool.spindle().speed, 1000);
}

TEST(Tool, MayTurnEitherWay) { EXPECT_NO_THROW(Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{-30000 * units::rpm})); }

TEST(Tool, RefusesASpeedThatIsNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity})
    EXPECT_THROW(Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{bad * units::rad_per_s}), Error) << bad;
}

TEST(Tool, RefusesAPowerLimitThatIsNotPositive) {
  for (const double bad : {0.0, -1.0, kNan})
    EXPECT_THROW(Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{100 * units::rad_per_s, bad}), Error) << bad;
}

TEST(Tool, RefusesABadHeadOrHandle) {
  EXPECT_THROW(Tool(SphereHead{0}), Error);
  EXPECT_THROW(Tool(SphereHead{1 * mm}, RayHandle{-1}), Error);
}

}  // namespace
}  // namespace hapticut::tool_test
