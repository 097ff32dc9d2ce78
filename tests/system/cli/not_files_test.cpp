// SPDX-License-Identifier: Apache-2.0
// What stands where a file should: pipes, endless devices, a disk that is full, an older recording, a run that is
// killed.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "support/program.hpp"

namespace hapticut::not_files_test {
namespace {

using namespace test;
using NotFiles = Program;

const std::string kLimited = std::string("timeout -k 1 120 ") + test::kProgram;

void expect_one_sentence(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
}

TEST_F(NotFiles, ArePipesAndEndlessDevices) {
  for (const std::string ending : {".stl", ".obj", ".ply", ".vdb", ".nrrd", ".nii", ".mha", ".dcm", ".inv3"}) {
    const std::string pipe = path("pipe" + ending), endless = path("endless" + ending);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", endless);
    for (const std::string& name : {pipe, endless})
      expect_one_sentence(run_program(folder, "inspect " + name, kLimited), "regular file");
  }
  ASSERT_EQ(::mkfifo(path("pipe.csv").c_str(), 0600), 0);
  const std::string drilled = "drill " + kBlock + kBall;
  expect_one_sentence(run_program(folder, drilled + "--path poses --poses " + path("pipe.csv"), kLimited), "pipe.csv");
  expect_one_sentence(
      run_program(folder, "drill " + kBlock + "--head profile --profile " + path("pipe.csv") + " " + kGroove, kLimited),
      "pipe.csv");
  expect_one_sentence(run_program(folder, "drill --settings " + path("pipe.csv"), kLimited), "pipe.csv");
}

TEST_F(NotFiles, AFileThatMayNotGrowIsAnErrorAndNoSignal) {
  const Outcome outcome =
      run_program(folder, "convert block " + path("a.vdb") + " --size_mm 6,6,3 --material enamel --voxel_mm 0.05",
                  "ulimit -f 1; " + kLimited);
  expect_one_sentence(outcome, "a.vdb");
  EXPECT_FALSE(std::filesystem::exists(path("a.vdb")));
}

TEST_F(NotFiles, AnOlderRecordingStaysUntilTheNewOneIsComplete) {
  (void)drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  const std::string old = read_bytes(folder / "a.h5");
  const Outcome killed = run_program(folder, "loop mock:spiral --seconds 60 --record " + path("a.h5"),
                                     std::string("timeout -s KILL 3 ") + test::kProgram);
  EXPECT_NE(killed.code, 0);
  EXPECT_EQ(read_bytes(folder / "a.h5"), old);
  EXPECT_EQ(run("replay " + path("a.h5.new")).code, 0);  // what the killed one had made
  (void)drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5.new"));
  EXPECT_EQ(run("replay " + path("a.h5")).code, 0);
}

TEST_F(NotFiles, ADiskThatFillsEndsTheRecordingAndTheReportIsWritten) {
  const Outcome outcome = run_program(
      folder,
      "loop mock:spiral --simulated_time --seconds 120 --record " + path("a.h5") + " --json " + path("report.json"),
      std::string("ulimit -f 24000; timeout -k 1 120 ") + test::kProgram);
  expect_one_sentence(outcome, "a.h5");
  EXPECT_NE(outcome.errors.find("its first "), std::string::npos) << outcome.errors;
  EXPECT_TRUE(read_json(folder / "report.json").is_object());
  const Outcome replayed = run("replay " + path("a.h5") + " --json " + path("replay.json"));
  EXPECT_EQ(replayed.code, 0) << replayed.errors;
  const nlohmann::json recording = read_json(folder / "replay.json")["recording"];
  EXPECT_EQ(recording["closed"], true);
  EXPECT_GT(recording["lost_steps"].get<int>(), 0);
  EXPECT_FALSE(recording["remarks"].empty());
}

}  // namespace
}  // namespace hapticut::not_files_test
