// SPDX-License-Identifier: Apache-2.0
// `hapticut validate` and `hapticut calibrate`, run like a user does.
#include "support/program.hpp"

namespace hapticut::cli_validate_test {
namespace {

using test::Program;
using test::ProgramOutcome;
using test::read_json;
using Validate = Program;
using Calibrate = Program;

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

void write(const std::string& name, const std::string& content) { std::ofstream(name) << content; }

constexpr const char* kHeader = "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm\n";

TEST_F(Calibrate, FitsThePublishedDrillingTestAndSaysWhatItDoesNotIdentify) {
  write(path("t.csv"), std::string(kHeader) + "1.25,1000,1,20.07,41.2\n");
  const ProgramOutcome outcome = run("calibrate " + path("t.csv") + " --json " + path("c.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "c.json");
  EXPECT_NEAR(report["cutting_ratio"].get<double>(), 2 * 41.2 / (1.25 * 20.07), 1e-4);
  EXPECT_FALSE(report["edge_identified"]);
  EXPECT_TRUE(report["edge_assumed"]);
  EXPECT_NE(outcome.out.find("do not identify it"), std::string::npos);
  // A preset that receives the constants may have terms that the fit sets to zero.
  EXPECT_NE(outcome.out.find("size_length"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("including zeros"), std::string::npos) << outcome.out;
}

TEST_F(Calibrate, ReadsAFileAsASpreadsheetWritesIt) {
  write(path("t.csv"),
        "\xEF\xBB\xBFradius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm\r\n1.25,1000,1,20.07,41.2\r\n");
  EXPECT_EQ(run("calibrate " + path("t.csv")).code, 0);
}

TEST_F(Calibrate, SaysThatTheChipIsNotIdentifiedWhereTheEdgeCarriesAll) {
  write(path("t.csv"), std::string(kHeader) + "1.25,1000,0.001,10.07,20.2\n1.25,1000,0.003,9.5,20.0\n");
  const ProgramOutcome outcome = run("calibrate " + path("t.csv") + " --json " + path("c.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_FALSE(read_json(folder / "c.json")["chip_identified"]);
  EXPECT_NE(outcome.out.find("add tests at a larger feed per revolution"), std::string::npos) << outcome.out;
}

TEST_F(Calibrate, TakesAnExactFitAndSaysThatNothingChecksIt) {
  write(path("t.csv"), std::string(kHeader) + "1.6,400,0.8333333,48,\n1.6,2000,0.8333333,24,\n");
  const ProgramOutcome outcome = run("calibrate " + path("t.csv") + " --json " + path("c.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "c.json");
  EXPECT_NEAR(report["edge_length"].get<double>(), 37.5e-6, 1e-8);
  EXPECT_TRUE(report["edge_identified"]);
  EXPECT_FALSE(report["checked"]);
  EXPECT_NE(outcome.out.find("unchecked"), std::string::npos) << outcome.out;
}

TEST_F(Calibrate, AsksForItsFile) {
  const ProgramOutcome outcome = run("calibrate");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("Use: hapticut calibrate TESTS.csv."), std::string::npos) << outcome.errors;
}

TEST_F(Calibrate, RefusesAFileThatIsWrongWithItsLine) {
  write(path("t.csv"), "radius,feed\n1,2\n");
  EXPECT_NE(run("calibrate " + path("t.csv")).errors.find("t.csv:1: the first line must name"), std::string::npos);
  write(path("t.csv"), std::string(kHeader) + "1.25,1000,1,20.07,41.2\n1.25,1000,fast,20,41\n");
  EXPECT_NE(run("calibrate " + path("t.csv")).errors.find("t.csv:3: feed_mm_per_s = \"fast\"; must be a number > 0."),
            std::string::npos);
  write(path("t.csv"), std::string(kHeader) + "1.25,1000,1,20.07\n");
  EXPECT_NE(run("calibrate " + path("t.csv")).errors.find("t.csv:2: 4 values; there must be 5"), std::string::npos);
  write(path("t.csv"), std::string(kHeader) + "1.25,1000,1,-3,41\n");
  EXPECT_NE(run("calibrate " + path("t.csv")).errors.find("t.csv:2: thrust_N = \"-3\"; must be a number > 0."),
            std::string::npos);
  write(path("t.csv"), std::string(kHeader) + "# slower\n\n1.25,0,1,20,41\n");
  EXPECT_NE(
      run("calibrate " + path("t.csv")).errors.find("t.csv:4: spindle_rpm = \"0\"; must be a number other than 0."),
      std::string::npos);
  write(path("t.csv"), kHeader);
  EXPECT_NE(run("calibrate " + path("t.csv")).errors.find("t.csv:1: there is no drilling test"), std::string::npos);
  write(path("t.csv"), std::string(kHeader) + "1.25,1000,1,20,0.00001\n");
  EXPECT_NE(run("calibrate " + path("t.csv")).errors.find("Check the units"), std::string::npos);
  EXPECT_NE(run("calibrate " + path("none.csv")).errors.find("cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace hapticut::cli_validate_test
