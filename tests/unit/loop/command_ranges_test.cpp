// SPDX-License-Identifier: Apache-2.0
// A command needs no check of its own for the ranges of its numbers and for its choices.
#include "loop/command_ranges.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <tuple>

#include "support/refusal.hpp"

namespace hapticut {
namespace commands {

enum class FanMode { suck, blow };

constexpr std::array<Named<FanMode>, 2> names_of(Of<FanMode>) {
  return {{{FanMode::suck, "suck"}, {FanMode::blow, "blow"}}};
}

struct SetFan {
  double power = 1;  // [W]
  FanMode mode = FanMode::suck;
};

constexpr auto fields_of(Of<SetFan>) {
  return std::tuple{field("power", &SetFan::power, "W", Range::between(0, 20), "power of a fan"),
                    field("mode", &SetFan::mode, "direction of the air")};
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

TEST(CommandRanges, HaveOnlyTheChoicesThatHaveAName) {
  EXPECT_NO_THROW(require_in_range(commands::SetFan{1, commands::FanMode::blow}));
  test::expect_refused(
      [] {
        require_in_range(commands::SetFan{1, commands::FanMode(9)});
      },
      {"SetFan::mode = 9; must be one of: suck, blow."});
}

}  // namespace
}  // namespace command_ranges_test
}  // namespace hapticut
