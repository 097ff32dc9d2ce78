// SPDX-License-Identifier: Apache-2.0
// Invalid profiles are refused.
#include <gtest/gtest.h>

#include <limits>

#include "hapticut/tool/profile.hpp"
#include "support/profiles.hpp"
#include "support/refusal.hpp"

namespace hapticut::profile_errors_test {
namespace {

using units::mm;

constexpr EdgeKind kSmooth = EdgeKind::smooth;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Refused {
  const char* name;
  Profile profile;
  std::vector<const char*> words;  // words of the message
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class BadProfile : public testing::TestWithParam<Refused> {};

TEST_P(BadProfile, IsRefusedWithValueRangeAndCure) {
  const std::string said = test::refusal([] { (void)ProfileHead(GetParam().profile); });
  EXPECT_NE(said, "");
  for (const char* word : GetParam().words) EXPECT_TRUE(test::contains(said, word)) << said << "\n lacks: " << word;
}

std::vector<Refused> refused() {
  std::vector<Refused> all;
  const auto add = [&](const char* name, double tip, std::vector<ProfileEdge> edges, std::vector<const char*> words) {
    all.push_back({name, {tip, std::move(edges)}, std::move(words)});
  };
  add("NoEdges", 0, {}, {"0 edges", "between 1 and"});
  add("NotANumber", 0, {{kNan, 0}, {0, 1 * mm}}, {"edge 1", "nan", "finite"});
  add("InfiniteRadius", 0, {{1 * mm, 0, kInfinity}, {0, 1 * mm}}, {"edge 1", "inf", "radius = 0"});
  add("TipNotFinite", kNan, {{1 * mm, 0}, {0, 1 * mm}}, {"Profile::tip", "finite"});
  add("ZeroSize", 0, {{0, 0}, {0, 0}}, {"no size"});
  add("OnItsAxis", 0, {{0, 1 * mm}}, {"axis"});
  add("PointAcrossTheAxis", 0, {{1 * mm, 0}, {-0.5 * mm, 1 * mm}, {0, 2 * mm}}, {"edge 2", "-0.5 mm", "axis", ">= 0"});
  add("ArcAcrossTheAxis", 0, {{0.1 * mm, 0}, {1 * mm, 0.1 * mm}, {0.1 * mm, 2 * mm, -1.1 * mm}, {0, 2 * mm}},
      {"edge 3", "crosses the axis"});
  add("PointOnTheAxisBeforeTheEnd", 0, {{1 * mm, 0}, {0, 1 * mm}, {1 * mm, 2 * mm}, {0, 2 * mm}},
      {"edge 2", "on the axis", "only the last"});
  add("NotClosed", 0, {{1 * mm, 0}, {1 * mm, 2 * mm}}, {"not closed", "(1, 2) mm", "smooth edge to (0, 2)"});
  add("EdgeOfNoLength", 0, {{1 * mm, 0}, {1 * mm, 0}, {0, 1 * mm}}, {"edge 2", "length", "Leave it out"});
  add("ArcTooTight", 0, {{1 * mm, 1 * mm, 0.5 * mm}, {0, 1 * mm}}, {"edge 1", "0.5 mm", "0.707107 mm"});
  add("CrossesItself", 0, {{1 * mm, 0}, {1 * mm, 1 * mm}, {0.5 * mm, -0.5 * mm}, {0.2 * mm, 2 * mm}, {0, 2 * mm}},
      {"crosses or touches itself", "edge 1", "edge 3"});
  add("ArcCrossesALine", 0,
      {{1 * mm, 0}, {1 * mm, 1 * mm, -0.6 * mm}, {0.8 * mm, 1 * mm}, {0.8 * mm, 0.2 * mm}, {0, 2 * mm}},
      {"crosses or touches itself", "edge 2", "edge 4"});
  add("TurnsBack", 0, {{2 * mm, 0}, {0.5 * mm, 0}, {0, 1 * mm}}, {"turns back on itself at (2, 0) mm"});
  add("FromShankToTip", 2 * mm, {{1 * mm, 2 * mm}, {1 * mm, 0}, {0, 0}}, {"2 mm", "from the tip to the shank"});
  add("InMillimetres", 0, {{1, 0}, {1, 5}, {0, 5}}, {"reach of the head [m] = 5.0", "<= 0.3", "in metres"});
  add("NothingCuts", 0, {{1 * mm, 0, 0, kSmooth}, {0, 1 * mm, 0, kSmooth}}, {"no cutting edge", "kind"});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Profiles, BadProfile, testing::ValuesIn(refused()),
                         [](const auto& refused) { return std::string(refused.param.name); });

TEST(ProfileHead, RefusesATolerancesOutOfRange) {
  for (const double bad : {0.0, -1.0, 1.0, kNan})
    EXPECT_THROW(ProfileHead(test::ball_profile(1 * mm), bad), Error) << bad;
}

TEST(ProfileHead, RefusesMoreEdgesThanAreAllowed) {
  Profile many;
  for (int n = 1; n <= 1001; ++n) many.edges.push_back({1 * mm, n * 1e-3 * mm});
  EXPECT_THROW(ProfileHead{many}, Error);
}

}  // namespace
}  // namespace hapticut::profile_errors_test
