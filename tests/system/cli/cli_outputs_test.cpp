// SPDX-License-Identifier: Apache-2.0
// Outputs of the program: one that fails does not take the others with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace hapticut::cli_outputs_test {
namespace {

using namespace test;

const std::string kBlock = "--workpiece block --size_mm 2,2,2 --material dentin --voxel_mm 0.2 ";
const std::string kBall = "--head sphere --radius_mm 0.5 --spindle_rpm 30000 ";
const std::string kLine = "--path line --from_mm 0,1,2 --to_mm 2,1,2 --feed_mm_per_s 20 ";
/// A ball that cuts away the whole block.
const std::string kGone =
    "drill --workpiece block --size_mm 1,1,1 --material cortical_bone --voxel_mm 0.1 --head sphere --radius_mm 1.5 "
    "--spindle_rpm 40000 --path line --from_mm 0.5,0.5,1.2 --to_mm 0.5,0.5,-2 --feed_mm_per_s 30 ";

class Outputs : public Program {
 protected:
  /// Runs the program with standard output at a place of the shell, e.g. ">/dev/full".
  ProgramOutcome run_to(const std::string& place, const std::string& arguments) {
    const std::string errors = path("stderr"),
                      command = std::string(kProgram) + " " + arguments + " 2>" + errors + " </dev/null " + place;
    const int status = std::system(("bash -c 'set -o pipefail; " + command + "'").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", read_bytes(errors)};
  }
  static std::size_t lines_of(const std::string& text) { return std::size_t(std::ranges::count(text, '\n')); }
};

TEST_F(Outputs, OfARunThatCutsEverythingAwayAreAllWrittenWithAWarning) {
  std::string arguments =
      kGone + "--json " + path("a.json") + " --steps_csv " + path("a.csv") + " --save " + path("a.vdb");
#ifdef HAPTICUT_HAS_IMPORT
  arguments += " --surface " + path("a.stl") + " --picture " + path("a.png") + " --record " + path("a.h5");
#endif
  const ProgramOutcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const nlohmann::json report = read_json(folder / "a.json");
  EXPECT_NEAR(report["removed_volume_mm3"]["total"].get<double>(), 1, 1e-7);  // sums of floats
  EXPECT_GT(read_bytes(folder / "a.csv").size(), 1000U);
#ifdef HAPTICUT_HAS_IMPORT
  EXPECT_NE(report["warnings"].dump().find("a.stl' has no triangle"), std::string::npos) << report["warnings"];
  EXPECT_NE(report["warnings"].dump().find("a.png' shows the background alone"), std::string::npos);
  EXPECT_EQ(read_bytes(folder / "a.stl").size(), 84U);
  EXPECT_TRUE(read_bytes(folder / "a.png").starts_with("\x89PNG"));
  EXPECT_EQ(run("replay " + path("a.h5")).code, 0);
  EXPECT_EQ(inspect(path("a.vdb"))["volume_mm3"]["cortical_bone"], 0);
  // Other formats, alone and converted.
  for (const std::string& each : {"--save " + path("b.nrrd"), "--surface " + path("b.ply")})
    EXPECT_EQ(run(kGone + each).code, 0) << each;
  EXPECT_EQ(inspect(path("b.nrrd"))["dims"], nlohmann::json({1, 1, 1}));
  for (const char* name : {"c.stl", "c.ply", "c.nrrd", "c.vdb"}) {
    const ProgramOutcome converted = run("convert " + path("a.vdb") + " " + path(name));
    EXPECT_EQ(converted.code, 0) << converted.errors;
    EXPECT_TRUE(std::filesystem::exists(folder / name));
  }
#endif
}

TEST_F(Outputs, ThatCannotBeWrittenLeaveTheOthers) {
  write_bytes(folder / "file", "");
  std::filesystem::create_symlink("/dev/full", folder / "full.vdb");
  const std::string nowhere = path("file/no/folder/");
  const ProgramOutcome outcome = run("drill " + kBlock + kBall + kLine + "--json " + path("a.json") + " --steps_csv " +
                                     nowhere + "a.csv --save " + path("full.vdb"));
  EXPECT_EQ(outcome.code, kFailed);
  EXPECT_NE(outcome.errors.find("a.csv"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("full.vdb"), std::string::npos) << outcome.errors;
  EXPECT_EQ(lines_of(outcome.errors), 2U) << outcome.errors;
  EXPECT_GT(read_json(folder / "a.json")["steps"], 0);
  EXPECT_NE(outcome.out.find("removed"), std::string::npos);
  // The report is the one that fails.
  EXPECT_EQ(run("drill " + kBlock + kBall + kLine + "--json /dev/full --steps_csv " + path("b.csv")).code, kFailed);
  EXPECT_GT(read_bytes(folder / "b.csv").size(), 1000U);
  const ProgramOutcome validated =
      run("validate --only groove --json " + nowhere + "v.json --markdown " + path("v.md"));
  EXPECT_EQ(validated.code, kFailed);
  EXPECT_GT(read_bytes(folder / "v.md").size(), 10U);
}

TEST_F(Outputs, ThatAllFailAreRefusedBeforeTheWork) {
  const ProgramOutcome outcome = run("drill " + kBlock + kBall + kLine + "--json /dev/full --steps_csv /dev/null");
  EXPECT_EQ(outcome.code, kFailed);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(lines_of(outcome.errors), 2U) << outcome.errors;
}

TEST_F(Outputs, OnAFullOrClosedStandardOutputAreAnErrorAndLeaveTheFiles) {
  const std::string drill = "drill " + kBlock + kBall + kLine + "--json " + path("a.json");
  for (const char* place : {">/dev/full", ">&-", "| true"}) {
    std::filesystem::remove(folder / "a.json");
    const ProgramOutcome outcome = run_to(place, drill);
    EXPECT_EQ(outcome.code, kFailed) << place;
    EXPECT_NE(outcome.errors.find("hapticut: cannot write to standard output: "), std::string::npos)
        << place << outcome.errors;
    EXPECT_EQ(lines_of(outcome.errors), 1U) << place << outcome.errors;
    EXPECT_GT(read_json(folder / "a.json")["steps"], 0) << place;
  }
  write_bytes(folder / "tests.csv",
              "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm\n1.6,1000,1,30,20\n1.6,1000,2,45,33\n");
  for (const std::string& arguments :
       {std::string("inspect molar --voxel_mm 0.5"), "calibrate " + path("tests.csv"),
        std::string("validate --only groove"), std::string("loop mock:rest --simulated-time --seconds 0.1"),
        "convert molar " + path("m.vdb") + " --voxel_mm 0.5", std::string("--help"), std::string("--version")})
    EXPECT_EQ(run_to(">/dev/full", arguments).code, kFailed) << arguments;
}

TEST_F(Outputs, CalledADashAreStandardOutputAlone) {
  write_bytes(folder / "tests.csv",
              "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm\n1.6,1000,1,30,20\n1.6,1000,2,45,33\n");
  const std::string drill = "drill " + kBlock + kBall + kLine;
  std::vector<std::string> commands = {drill, "inspect molar --voxel_mm 0.5", "calibrate " + path("tests.csv"),
                                       "validate --only groove", "loop mock:rest --simulated-time --seconds 0.1"};
#ifdef HAPTICUT_HAS_IO
  ASSERT_EQ(run(drill + "--record " + path("r.h5")).code, 0);
  commands.push_back("replay " + path("r.h5"));
#endif
  for (const std::string& command : commands) {
    const ProgramOutcome outcome = run(command + " --json -");
    EXPECT_EQ(outcome.code, 0) << command << outcome.errors;
    EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << command << outcome.out;
    EXPECT_NE(outcome.errors, "") << command << ": the table is on standard error";
    EXPECT_FALSE(std::filesystem::exists("-"));
  }
  const ProgramOutcome steps = run(drill + "--steps_csv - --json " + path("a.json"));
  EXPECT_EQ(steps.code, 0);
  EXPECT_EQ(read_csv(steps.out)["t_s"].size(), read_json(folder / "a.json")["steps"].get<std::size_t>());
  write_bytes(folder / "s.toml", "[output]\njson = \"-\"\n");
  EXPECT_TRUE(nlohmann::json::accept(run(drill + "--settings " + path("s.toml")).out));
  EXPECT_EQ(run_to(">/dev/full", drill + "--json -").code, kFailed);
}

TEST_F(Outputs, CalledADashAreOfTextAndOne) {
  const std::string drill = "drill " + kBlock + kBall + kLine;
  expect_refused(drill + "--json - --steps_csv -",
                 {"--steps_csv and --json both go to standard output. Give one of them a file."});
  expect_refused(drill + "--save -", {"extension must be"}, kWrongUsage);
  expect_refused(drill + "--record -", {"'-' is standard output, which takes text only"});
}

TEST_F(Outputs, OfWrongExtensionsAreAllNamedAndAWrongCommandLine) {
  expect_refused("drill " + kBlock + kBall + kLine + "--surface s.stl --save a.doc --picture adir",
                 {"'a.doc'", ".vdb", "'adir'", ".png"}, kWrongUsage);
}

TEST_F(Outputs, BehindLinksToOneMissingFileAreRefused) {
  std::filesystem::create_symlink("r.json", folder / "l.json");
  const std::string drill = "drill " + kBlock + kBall + kLine;
  expect_refused(drill + "--json " + path("r.json") + " --steps_csv " + path("l.json"), {"would overwrite"});
  EXPECT_FALSE(std::filesystem::exists(folder / "r.json"));
}

TEST_F(Outputs, ThatAreNoRegularFilesAreNamedAndPointToTheDash) {
  (void)run("drill " + kBlock + kBall + kLine + "--json /dev/stdout 2>" + path("said") + " | cat");
  const std::string said = read_bytes(folder / "said");
  for (const char* part : {"'/dev/stdout'", "not a regular file", "can be -"})
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

#ifdef HAPTICUT_HAS_IO
TEST_F(Outputs, OfARunAreWrittenWhenItsRecordingCannotStart) {
  // No file may exceed a size that the report fits in and the recording does not.
  const std::string limited = "bash -c 'ulimit -f 1000; exec \"$0\" \"$@\"' " + std::string(kProgram);
  const std::string output = "--record " + path("r.h5") + " --json " + path("q.json");
  for (const std::string& command :
       {"drill " + kBlock + kBall + kLine, std::string("loop mock:spiral --seconds 0.1 "
                                                       "--simulated_time --voxel_mm 0.5 ")}) {
    const ProgramOutcome outcome = run_program(folder, command + output, limited);
    EXPECT_EQ(outcome.code, kFailed) << command;
    EXPECT_NE(outcome.errors.find("cannot write the recording"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.out, "") << "the table of " << command;
    EXPECT_TRUE(std::filesystem::remove(folder / "q.json")) << command;
    EXPECT_FALSE(std::filesystem::exists(folder / "r.h5")) << command;
  }
}

TEST_F(Outputs, ARecordingBehindALinkIsMadeWhereTheLinkPoints) {
  std::filesystem::create_symlink("there.h5", folder / "l.h5");
  const ProgramOutcome outcome = run("drill " + kBlock + kBall + kLine + "--record " + path("l.h5"));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "l.h5"));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "there.h5"));
}

TEST_F(Outputs, ARecordingOfARefusedLoopIsRemoved) {
  ASSERT_EQ(run("loop mock:spiral --seconds 0.1 --simulated_time --voxel_mm 0.5 --record " + path("a.h5")).code, 0);
  expect_refused("loop replay:" + path("a.h5") +
                     " --coupling none --reference_stiffness 1e14 --voxel_mm 0.5 --record " + path("h.h5"),
                 {});
  EXPECT_FALSE(std::filesystem::exists(folder / "h.h5"));
}
#endif

}  // namespace
}  // namespace hapticut::cli_outputs_test
