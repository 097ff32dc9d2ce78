// SPDX-License-Identifier: Apache-2.0
// `hapticut gestures` as a user runs it.
#include "support/program.hpp"

namespace hapticut::cli_gestures_test {
namespace {

using test::Outcome;
using test::Program;
using test::read_json;
using Gestures = Program;

TEST_F(Gestures, ReportsEveryDemandAndEndsWellWhereAllAreMet) {
  const Outcome outcome = run("gestures --only G39 --json " + path("new/g.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "new/g.json");
  EXPECT_EQ(report["failed"], 0);
  ASSERT_GE(report["rows"].size(), 10U);
  for (const nlohmann::json& row : report["rows"]) {
    EXPECT_EQ(row["gesture"], "G39");
    EXPECT_TRUE(row["pass"]) << row;
    for (const char* field : {"name", "scene", "voxel_size", "demand", "expected", "seen", "known"})
      EXPECT_TRUE(row.contains(field)) << field;
  }
  EXPECT_NE(outcome.out.find("ok    G39  thrust after: cylinder 1.6 mm"), std::string::npos) << outcome.out;
}

TEST_F(Gestures, FailsWithCodeOneAndSaysWhatIsKnown) {
  const Outcome outcome = run("gestures --only G10 --json " + path("g.json") + " --markdown " + path("g.md"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("demands on gestures are not met"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.out.find("known G10  invariant 1"), std::string::npos) << outcome.out;
  const nlohmann::json report = read_json(folder / "g.json");
  EXPECT_GT(report["failed"], 0) << "the report is written all the same";
  EXPECT_EQ(report["failed"], report["known"]);
  EXPECT_NE(test::read_bytes(path("g.md")).find("| invariant 1 | "), std::string::npos);
}

TEST_F(Gestures, RefusesOneThatDoesNotExist) {
  const Outcome outcome = run("gestures --only G0");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("there is no gesture 'G0'; there are G1, G2"), std::string::npos) << outcome.errors;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && defined(NDEBUG)
// All of them, half a minute.
TEST_F(Gestures, ThePageIsUpToDate) {
  (void)run("gestures --markdown " + path("g.md"));
  // Everything but what was seen and what follows from it, whose last digits depend on the processor.
  const auto lines = [](const std::string& page) {
    std::vector<std::string> all;
    std::istringstream in(page);
    bool is_list = false;
    for (std::string line; std::getline(in, line);) {
      is_list = is_list || line == "## Not met yet";
      if (line.starts_with("| ") && !is_list) line = line.substr(0, line.find('|', 2));
      all.push_back(line);
    }
    return all;
  };
  EXPECT_EQ(lines(test::read_bytes(test::source_path("docs/gestures.md"))), lines(test::read_bytes(path("g.md"))))
      << "run hapticut gestures --markdown docs/gestures.md";
}
#endif

}  // namespace
}  // namespace hapticut::cli_gestures_test
