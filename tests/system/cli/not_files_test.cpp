// SPDX-License-Identifier: Apache-2.0
// Special cases in place of a file: pipes, endless devices, a full disk, an older recording, a killed run.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <vector>

#include "import/mesh/mesh_extensions.hpp"
#include "import/volume/formats.hpp"
#include "support/program.hpp"

namespace hapticut::not_files_test {
namespace {

using namespace test;
using NotFiles = Program;

const std::string kLimited = std::string("timeout -k 1 120 ") + test::kProgram;

TEST_F(NotFiles, ArePipesAndEndlessDevices) {
  std::vector<std::string_view> extensions = volume_extensions();
  extensions.insert(extensions.end(), kMeshExtensions.begin(), kMeshExtensions.end());
  extensions.push_back(".vdb");
  for (const std::string_view extension : extensions) {
    const std::string pipe = path(std::string("pipe").append(extension));
    const std::string endless = path(std::string("endless").append(extension));
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", endless);
    for (const std::string& name : {pipe, endless})
      expect_refused("inspect " + name, {"regular file"}, kFailed, kLimited);
  }
  ASSERT_EQ(::mkfifo(path("pipe.csv").c_str(), 0600), 0);
  const std::string drilled = "drill " + kBlock + kBall;
  expect_refused(drilled + "--path poses --poses " + path("pipe.csv"), {"pipe.csv"}, kFailed, kLimited);
  expect_refused("drill " + kBlock + "--head profile --profile " + path("pipe.csv") + " " + kGroove, {"pipe.csv"},
                 kFailed, kLimited);
  expect_refused("drill --settings " + path("pipe.csv"), {"pipe.csv"}, kFailed, kLimited);
}

TEST_F(NotFiles, AFileThatMayNotGrowIsAnErrorAndNoSignal) {
  expect_refused("convert block " + path("a.vdb") + " --size_mm 6,6,3 --material enamel --voxel_mm 0.05", {"a.vdb"},
                 kFailed, "ulimit -f 1; " + kLimited);
  EXPECT_FALSE(std::filesystem::exists(path("a.vdb")));
}

TEST_F(NotFiles, AnOlderRecordingStaysUntilTheNewOneIsComplete) {
  (void)drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  const std::string old = read_bytes(folder / "a.h5");
  const ProgramOutcome killed = run_program(folder, "loop mock:spiral --seconds 60 --record " + path("a.h5"),
                                            std::string("timeout -s KILL 3 ") + test::kProgram);
  EXPECT_NE(killed.code, 0);
  EXPECT_EQ(read_bytes(folder / "a.h5"), old);
  EXPECT_EQ(run("replay " + path("a.h5.new")).code, 0);  // the steps of the killed run
  (void)drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5.new"));
  EXPECT_EQ(run("replay " + path("a.h5")).code, 0);
}

TEST_F(NotFiles, ADiskThatFillsEndsTheRecordingAndTheReportIsWritten) {
  expect_refused(
      "loop mock:spiral --simulated_time --seconds 120 --record " + path("a.h5") + " --json " + path("report.json"),
      {"a.h5", "its first "}, kFailed, "ulimit -f 24000; " + kLimited);
  EXPECT_TRUE(read_json(folder / "report.json").is_object());
  const ProgramOutcome replayed = run("replay " + path("a.h5") + " --json " + path("replay.json"));
  EXPECT_EQ(replayed.code, 0) << replayed.errors;
  const nlohmann::json recording = read_json(folder / "replay.json")["recording"];
  EXPECT_EQ(recording["closed"], true);
  EXPECT_GT(recording["lost_steps"].get<int>(), 0);
  EXPECT_FALSE(recording["remarks"].empty());
}

}  // namespace
}  // namespace hapticut::not_files_test
