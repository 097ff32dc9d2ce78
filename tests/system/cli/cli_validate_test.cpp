// SPDX-License-Identifier: Apache-2.0
// `hapticut validate`, run like a user does.
#include "support/program.hpp"

namespace hapticut::cli_validate_test {
namespace {

using test::Program;
using test::ProgramOutcome;
using test::read_json;
using Validate = Program;

TEST_F(Validate, ReportsEveryFieldOfEveryCaseAndThatAllPass) {
  const ProgramOutcome outcome =
      run("validate --only effects --json " + path("new/out/v.json") + " --markdown " + path("v.md"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "new/out/v.json");
  EXPECT_EQ(report["failed"], 0);
  ASSERT_GE(report["cases"].size(), 5U);
  for (const nlohmann::json& one : report["cases"]) {
    EXPECT_TRUE(one["pass"]) << one;
    EXPECT_LE(one["relative_error"].get<double>(), one["tolerance"].get<double>());
    for (const char* field : {"experiment", "id", "case", "unit", "expected", "computed", "reason"})
      EXPECT_TRUE(one.contains(field)) << field;
  }
  EXPECT_NE(test::read_bytes(path("v.md")).find("| effects | C18 | growth limit: "), std::string::npos);
}

TEST_F(Validate, PrintsAnErrorAsAFractionOfItsBound) {
  const std::string bounds = run("validate --only 'defect D2'").out;
  EXPECT_NE(bounds.find(", at most 1: 0."), std::string::npos) << bounds;
  EXPECT_NE(bounds.find(" of its bound, 1 %, cut voxels"), std::string::npos) << bounds;
  EXPECT_EQ(bounds.find("expected 0,"), std::string::npos) << bounds;
  EXPECT_NE(bounds.find("expected 656, computed 656, off by "), std::string::npos) << "a value that is not 0\n"
                                                                                   << bounds;
  const std::string units = run("validate --only effects").out;
  EXPECT_NE(units.find("N^2, at most 5e-09 N^2: "), std::string::npos) << units;
}

TEST_F(Validate, FailsWithCodeOneAndNamesTheCasesThatAreOff) {
  const ProgramOutcome outcome = run("validate --only 'defect D1' --tolerance-factor 0 --json " + path("v.json"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("cases exceed their tolerance"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.out.find("FAIL D1 cured"), std::string::npos);
  const nlohmann::json report = read_json(folder / "v.json");
  EXPECT_GT(report["failed"], 0) << "the report is written all the same";
}

TEST_F(Validate, RefusesAnExperimentThatDoesNotExist) {
  const ProgramOutcome outcome = run("validate --only nonsense");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("no experiment has 'nonsense' in its name"), std::string::npos);
  EXPECT_NE(outcome.errors.find("; defect D1"), std::string::npos) << outcome.errors;
}

TEST_F(Validate, FindsAnExperimentInAnyCase) {
  EXPECT_NE(run("validate --only 'DEFECT d1'").out.find("D1"), std::string::npos);
}

// A factor above 1 would make anything pass.
TEST_F(Validate, RefusesToLoosenItsTolerances) {
  const ProgramOutcome outcome = run("validate --only effects --tolerance_factor 2");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("--tolerance_factor 2: must be a number from 0 to 1."), std::string::npos)
      << outcome.errors;
}

}  // namespace
}  // namespace hapticut::cli_validate_test
