// SPDX-License-Identifier: Apache-2.0
// Every gesture against the list of what is not met yet, both ways, and the page that tells of them.
// HAPTICUT_PRINT_GESTURES=1 prints every demand; HAPTICUT_WRITE_GESTURES=1 writes the page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "gestures/gesture_list.hpp"
#include "gestures/known_failures.hpp"
#include "gestures/page.hpp"
#include "support/places.hpp"
#include "support/sanitizers.hpp"
#include "support/temporary_folder.hpp"

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
// Half a minute in a release build is a quarter of an hour with a sanitizer: there a few of each kind must do.
constexpr bool kAll = !kWithAssertions && !test::kWithAddressSanitizer && !test::kWithThreadSanitizer;

std::vector<std::string> ids() {
  std::vector<std::string> ids;
  for (const gestures::Gesture& gesture : all_gestures()) ids.push_back(gesture.id);
  return ids;
}

/// As lines for a person who reads the output.
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

/// What a gesture gives; it runs once in a process.
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
    if (!kAll) continue;  // it may need finer voxels to fail
    ASSERT_NE(seen, met.end()) << failure.gesture << " has no demand '" << failure.demand << "'";
    EXPECT_FALSE(seen->second) << failure.gesture << ", " << failure.demand
                               << " is met now: take it off the list in tests/gestures/known_failures.cpp, and write "
                                  "the page anew as docs/gestures.md says";
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

// All of them once more, half a minute.
TEST(GesturesPage, IsUpToDate) {
  if (!kAll) GTEST_SKIP() << "the page is of all gestures, and this build runs a few";
  std::vector<Row> rows;
  for (const std::string& id : ids()) rows.insert(rows.end(), rows_of(id).begin(), rows_of(id).end());
  const std::string page = gestures::page_of(rows);
  const std::filesystem::path place = test::source_path("docs/gestures.md");
  if (std::getenv("HAPTICUT_WRITE_GESTURES") != nullptr) test::write_bytes(place, page);
  EXPECT_EQ(gestures::lasting_lines(test::read_bytes(place)), gestures::lasting_lines(page))
      << "docs/gestures.md says how to write it anew";
}

}  // namespace
}  // namespace hapticut::gestures_test
