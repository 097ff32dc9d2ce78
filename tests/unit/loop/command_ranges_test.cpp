// SPDX-License-Identifier: Apache-2.0
// A command with numbers needs no check of its own for their ranges.
#include "loop/command_ranges.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "support/refusal.hpp"

namespace hapticut {
namespace commands {

struct SetFan {
  double power = 1;  // [W]
};

constexpr auto fields_of(Of<SetFan>) {
  return std::tuple{field("power", &SetFan::power, "W", Range::between(0, 20), "power of a fan")};
}

}  // namespace commands

namespace command_ranges_test {
namespace {

TEST(CommandRanges, AreThoseOfItsFieldsAndTheMessageNamesTheCommand) {
  EXPECT_NO_THROW(require_in_range(commands::SetFan{0}));
  EXPECT_NO_THROW(require_in_range(commands::SetFan{20}));
  for (const double power : {-1.0, 20.5, std::numeric_limits<double>::quiet_NaN()})
    test::expect_refused([&] { require_in_range(commands::SetFan{power}); }, {"SetFan::power [W] = ", "20"});
}

}  // namespace
}  // namespace command_ranges_test
}  // namespace hapticut
