// SPDX-License-Identifier: Apache-2.0
// Runs every gesture. A demand must fail if it is on the list of known failures, and must pass otherwise. In a release
// build, from its folder tests/gestures:
//     ./test_gestures                                                    # all gestures, half a minute
//     HAPTICUT_PRINT_GESTURES=1 ./test_gestures --gtest_filter='*/G7'    # one gesture, and the result of each demand
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "gestures/gesture_list.hpp"
#include "gestures/known_failures.hpp"
#include "support/places.hpp"
#include "support/sanitizers.hpp"

namespace hapticut::gestures_test {
namespace {

using gestures::all_gestures;
using gestures::known_failures;
using gestures::Row;

#ifdef NDEBUG
constexpr bool kWithAssertions = false;
#else
constexpr bool kWithAssertions = true;
#endif
// All gestures take half a minute in a release build and a quarter of an hour with a sanitizer. Builds with a sanitizer
// or with assertions run only a few gestures.
constexpr bool kAll = !kWithAssertions && !test::kWithAddressSanitizer && !test::kWithThreadSanitizer;

std::vector<std::string> ids() {
  std::vector<std::string> ids;
  for (const gestures::Gesture& gesture : all_gestures()) ids.push_back(gesture.id);
  return ids;
}

/// A row as lines of the output.
std::string in_words(const Row& row) {
  const std::string_view known = known_reason(row);
  const std::string voxels = row.voxel_size > 0 ? ", voxels of " + gestures::shown(1e3 * row.voxel_size, "mm") : "";
  std::string words = std::string(row.is_met      ? "ok "
                                  : known.empty() ? "FAIL "
                                                  : "known ") +
                      row.gesture + ", " + row.demand + " of " + row.scene + voxels + "\n      expected " +
                      row.expected + "\n      seen     " + row.seen + "\n";
  if (!known.empty()) words += "      known    " + std::string(known) + "\n";
  return words;
}

/// The rows of a gesture. A process runs each gesture only once.
const std::vector<Row>& rows_of(const std::string& id) {
  static std::map<std::string, std::vector<Row>> done;
  std::vector<Row>& rows = done[id];
  if (!rows.empty()) return rows;
  const std::vector<gestures::Gesture> all = all_gestures();
  const auto gesture = std::ranges::find(all, id, &gestures::Gesture::id);
  rows = gestures::rows_of(*gesture, kAll ? std::vector{2e-4, 1e-4, 5e-5} : std::vector{2e-4});
  if (std::getenv("HAPTICUT_PRINT_GESTURES") != nullptr)
    for (const Row& row : rows) std::fputs(in_words(row).c_str(), stdout);
  return rows;
}

class Gesture : public testing::TestWithParam<std::string> {};

TEST_P(Gesture, FailsWhereItIsKnownToFailAndNowhereElse) {
  std::map<std::string, bool> met;
  for (const Row& row : rows_of(GetParam())) {
    bool& passes = met.try_emplace(row.demand, true).first->second;
    passes = passes && row.is_met;
    EXPECT_TRUE(row.is_met || !known_reason(row).empty()) << in_words(row);
  }
  for (const gestures::KnownFailure& failure : known_failures()) {
    if (failure.gesture != GetParam()) continue;
    const auto seen = met.find(std::string(failure.demand));
    if (!kAll) continue;  // the failure may need finer voxels
    ASSERT_NE(seen, met.end()) << failure.gesture << " has no demand '" << failure.demand << "'";
    EXPECT_FALSE(seen->second) << failure.gesture << ", " << failure.demand
                               << " is met now: remove it from tests/gestures/known_failures.cpp and from "
                                  "docs/validation.md";
  }
}

INSTANTIATE_TEST_SUITE_P(OfAHand, Gesture,
                         testing::ValuesIn(kAll ? ids() : std::vector<std::string>{"G2", "G6", "G8", "G19", "G35"}),
                         [](const auto& id) { return id.param; });

TEST(GestureList, AreNumberedWithoutAGap) {
  int n = 0;
  for (const std::string& id : ids()) EXPECT_EQ(id.substr(1), std::to_string(++n));
  EXPECT_GE(n, 35);
}

TEST(KnownGestureFailures, NameEachDemandOnce) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  const std::vector<std::string> all = ids();
  for (const gestures::KnownFailure& failure : known_failures()) {
    EXPECT_TRUE(seen.emplace(failure.gesture, failure.demand).second) << failure.gesture << " " << failure.demand;
    EXPECT_NE(std::ranges::find(all, failure.gesture), all.end()) << failure.gesture;
    EXPECT_FALSE(failure.reason.empty() || failure.seen.empty()) << failure.gesture << " " << failure.demand;
  }
}

TEST(KnownGestureFailures, AreThoseThatThePageOfValidationNames) {
  std::ifstream page(test::source_path("docs/validation.md"));
  std::set<std::string> named, known;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("| G")) named.insert(line.substr(2, line.find(' ', 2) - 2));
  for (const gestures::KnownFailure& failure : known_failures()) known.insert(std::string(failure.gesture));
  EXPECT_EQ(named, known);
}

}  // namespace
}  // namespace hapticut::gestures_test
