// SPDX-License-Identifier: Apache-2.0
// Every gesture against the list of what is not met yet, both ways.
#include "hapticut/bench/gestures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "hapticut/core/errors.hpp"

namespace hapticut::gestures_test {
namespace {

// Half a minute in a release build is a quarter of an hour with a sanitizer: there a few of each kind must do.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr bool kAll = false;
#else
constexpr bool kAll = true;
#endif

std::vector<std::string> ids() {
  if (kAll) return gesture_ids();
  return {"G2", "G6", "G8", "G19", "G35"};
}

GestureOptions options_for(const std::string& id) {
  GestureOptions options;
  options.only = id;
  if (!kAll) options.voxel_sizes = {2e-4};
  return options;
}

class Gesture : public testing::TestWithParam<std::string> {};

TEST_P(Gesture, FailsWhereItIsKnownToFailAndNowhereElse) {
  std::map<std::string, bool> met;
  for (const GestureRow& row : run_gestures(options_for(GetParam()))) {
    const bool passes = met.try_emplace(row.demand, true).first->second && row.pass;
    met[row.demand] = passes;
    EXPECT_TRUE(row.pass || !row.known.empty())
        << row.gesture << ", " << row.demand << " of " << row.scene << ", voxels of " << row.voxel_size
        << " m: expected " << row.expected << ", seen " << row.seen;
  }
  for (const KnownGestureFailure& failure : known_gesture_failures()) {
    if (failure.gesture != GetParam()) continue;
    const auto seen = met.find(std::string(failure.demand));
    if (!kAll) continue;  // it may need finer voxels to fail
    ASSERT_NE(seen, met.end()) << failure.gesture << " has no demand '" << failure.demand << "'";
    EXPECT_FALSE(seen->second) << failure.gesture << ", " << failure.demand
                               << " is met now: take it off the list in src/bench/gestures/known_failures.cpp, and run "
                                  "hapticut gestures --markdown docs/gestures.md";
  }
}

INSTANTIATE_TEST_SUITE_P(OfAHand, Gesture, testing::ValuesIn(ids()), [](const auto& id) { return id.param; });

TEST(GestureList, AreNumberedWithoutAGap) {
  int n = 0;
  for (const std::string& id : gesture_ids()) EXPECT_EQ(id.substr(1), std::to_string(++n));
  EXPECT_GE(n, 35);
}

TEST(KnownGestureFailures, NameEachDemandOnce) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  const std::vector<std::string> all = gesture_ids();
  for (const KnownGestureFailure& failure : known_gesture_failures()) {
    EXPECT_TRUE(seen.emplace(failure.gesture, failure.demand).second) << failure.gesture << " " << failure.demand;
    EXPECT_NE(std::ranges::find(all, failure.gesture), all.end()) << failure.gesture;
    EXPECT_FALSE(failure.reason.empty() || failure.seen.empty()) << failure.gesture << " " << failure.demand;
  }
}

TEST(GestureList, RefuseWhatThereIsNot) {
  GestureOptions options;
  options.only = "G0";
  EXPECT_THROW((void)run_gestures(options), Error);
  options.only = "G8";
  options.voxel_sizes = {};
  EXPECT_THROW((void)run_gestures(options), Error);
  options.voxel_sizes = {0};
  EXPECT_THROW((void)run_gestures(options), Error);
}

}  // namespace
}  // namespace hapticut::gestures_test
