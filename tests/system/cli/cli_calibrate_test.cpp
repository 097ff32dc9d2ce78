// SPDX-License-Identifier: Apache-2.0
// `hapticut calibrate`, run like a user does.
#include "hapticut/workpiece/preset_constants.hpp"
#include "support/program.hpp"
#include "support/refusal.hpp"

namespace hapticut::cli_calibrate_test {
namespace {

using test::expect_part;
using test::Program;
using test::ProgramOutcome;
using test::read_json;
using Calibrate = Program;

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
  EXPECT_EQ(report["edge_length"], find_constant("twist_drill", "edge_length")->typical);
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
  const ProgramOutcome outcome = run("calibrate " + path("t.csv") + " --cutter twist_drill --json " + path("c.json"));
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

TEST_F(Calibrate, NamesAnUnknownColumnAndTheKnownOnes) {
  write(path("t.csv"), "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm,scatter_N\n1.6,400,0.8333,48,14.5,3\n");
  expect_part(run("calibrate " + path("t.csv")).errors,
              "t.csv:1: there is no column scatter_N; must be one of radius_mm, spindle_rpm, feed_mm_per_s, thrust_N, "
              "torque_Nmm, lips.");
  write(path("t.csv"), "radius_mm,spindle_rpm,feed_mm_per_min,thrust_N,torque_Nmm\n1.6,400,50,48,14.5\n");
  expect_part(run("calibrate " + path("t.csv")).errors, "there is no column feed_mm_per_min; ");
  // Columns in another order, and one that a spreadsheet has added.
  write(path("t.csv"), "torque_Nmm,thrust_N,lips,radius_mm,spindle_rpm,feed_mm_per_s,\n41.2,20.07,2,1.25,1000,1,\n");
  const ProgramOutcome outcome = run("calibrate " + path("t.csv") + " --json " + path("c.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NEAR(read_json(folder / "c.json")["cutting_ratio"].get<double>(), 2 * 41.2 / (1.25 * 20.07), 1e-4);
}

TEST_F(Calibrate, PrintsTheRangesOfThePresetsBesideTheNumbers) {
  write(path("t.csv"), std::string(kHeader) + "3.2,400,0.8333,48,14.5\n3.2,2000,0.8333,24,10\n");
  const ProgramOutcome outcome = run("calibrate " + path("t.csv") + " --json " + path("c.json"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  expect_part(outcome.out, "J/m^3; presets of twist_drill: 3e+07 ... 1.3e+08");
  expect_part(outcome.out, "; presets of twist_drill: 0.3 ... 0.6");
  expect_part(outcome.out, " m; presets of twist_drill: 6e-06 ... 4.5e-05");
  expect_part(outcome.out, "that the radius is not the diameter");
  const nlohmann::json report = read_json(folder / "c.json");
  EXPECT_EQ(report["cutter"], "twist_drill");
  EXPECT_EQ(report["presets"]["cutting_ratio"]["high"], find_constant("twist_drill", "cutting_ratio")->high);
}

TEST_F(Calibrate, SaysThatAFeedPerMinuteIsNoFeedPerSecond) {
  write(path("t.csv"), std::string(kHeader) + "1.6,2000,50,24,10\n1.6,400,50,48,14.5\n");
  const ProgramOutcome outcome = run("calibrate " + path("t.csv"));
  EXPECT_NE(outcome.code, 0);
  expect_part(outcome.errors,
              "drilling test 2 has a feed of 7.5 mm per revolution; must be from 1e-06 mm to the diameter "
              "of the tool, 3.2 mm.");
}

TEST_F(Calibrate, TakesTheCutterOfTheTests) {
  write(path("t.csv"), "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm,lips\n0.42,250000,0.273,0.98,,6\n");
  expect_part(run("calibrate " + path("t.csv")).out,
              "0.00018 m: that of the presets, the tests do not identify it; presets of carbide_bur: 0.00018");
  expect_part(run("calibrate " + path("t.csv") + " --cutter fine_diamond").out, "presets of fine_diamond: 2.8e+10");
}

TEST_F(Calibrate, RefusesAFileThatIsWrongWithItsLine) {
  write(path("t.csv"), "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N\n1,2,3,4\n");
  expect_part(run("calibrate " + path("t.csv")).errors,
              "t.csv:1: the column torque_Nmm is missing; the first line must");
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
}  // namespace hapticut::cli_calibrate_test
