// SPDX-License-Identifier: Apache-2.0
// hapticut drill --record, replay and export, run like a user does.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/recordings.hpp"

namespace hapticut::cli_replay_test {
namespace {

using namespace test;
using Replay = Program;

TEST_F(Replay, OfADrilledGrooveIsIdentical) {
  const nlohmann::json drilled = drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  const nlohmann::json replayed = report("replay " + path("a.h5"));
  EXPECT_EQ(read_bytes(folder / "stderr"), "");
  EXPECT_NE(read_bytes(folder / "stdout").find("every bit"), std::string::npos);
  EXPECT_EQ(replayed["steps"], drilled["steps"]);
  EXPECT_EQ(replayed["identical"], true);
  EXPECT_TRUE(replayed["first_difference"].is_null());
  EXPECT_EQ(replayed["recording"]["closed"], true);
  EXPECT_EQ(replayed["recording"]["lost_steps"], 0);
  EXPECT_EQ(replayed["build"], drilled["build"]);
  for (const char* name : {"version", "commit", "compiler", "cpu"})
    EXPECT_TRUE(replayed["build"].contains(name)) << name;
}

TEST_F(Replay, NeedsAFile) {
  EXPECT_EQ(run("replay").code, 2);
  EXPECT_EQ(run("replay " + path("absent.h5")).code, 1);
  EXPECT_EQ(run("export").code, 2);
  EXPECT_EQ(run("export " + path("absent.h5")).code, 2);
}

TEST_F(Replay, SaysThatALawIsOfAnotherKind) {
  (void)drill(kBlock + kBall + kGroove + "--law hertzian_burr --burr_stiffness_Pa 1e6 --record " + path("h.h5"));
  expect_refused("replay " + path("h.h5") + " --law foundation",
                 {"h.h5' was made with a law that computes the force at points of voxels, but --law integrates"});
}

TEST_F(Replay, ExportsTextAndArrays) {
  const nlohmann::json drilled = drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.csv")).code, 0);
  const auto columns = read_csv(read_bytes(folder / "a.csv"));
  EXPECT_EQ(columns.at("force_2").size(), drilled["steps"].get<std::size_t>());
  EXPECT_NEAR(columns.at("energy_cutting").back() / drilled["energy_J"]["cutting"].get<double>(), 1, 1e-12);
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("b.CSV")).code, 0);
  EXPECT_EQ(read_bytes(folder / "b.CSV"), read_bytes(folder / "a.csv"));
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.npz")).code, 0);
  EXPECT_EQ(read_bytes(folder / "a.npz").substr(0, 2), "PK");
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.wav")).code, 0);
  EXPECT_EQ(read_bytes(folder / "a.wav").substr(0, 4), "RIFF");
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.doc")).code, kWrongUsage);
  expect_refused("export " + path("a.h5") + " " + path("b.csv") + " --page " + path(""), {"--page is set"},
                 kWrongUsage);
}

TEST_F(Replay, SaysBeforeTheWorkThatARecordingCannotBeWritten) {
  std::ofstream(folder / "file") << "no folder";
  expect_refused("drill " + kBlock + kBall + kGroove + "--record " + path("file/a.h5"), {"file/a.h5"});
  EXPECT_EQ(read_bytes(folder / "stdout"), "");
}

// Two programs record to one file: the second is refused, and the first keeps its recording.
TEST_F(Replay, OfAFileThatAnotherProgramIsRecording) {
  const test::Scene& scene = find_scene("axial_flat");
  for (const char* when : {"to a new file", "over an older recording"}) {
    Simulation simulation = scene.make();
    Recorder recorder(folder / "a.h5", simulation, patient());
    for (int tick = 0; tick < 50; ++tick) recorder.step(scene.input(tick));
    std::filesystem::create_directory_symlink(folder / "", folder / "link");
    for (const std::string& name : {path("a.h5"), path("./link/a.h5")})
      for (const std::string& command : {"drill " + kBlock + kBall + kGroove + "--record " + name,
                                         "loop mock:spiral --seconds 0.1 --simulated_time --record " + name})
        expect_refused(command, {"a.h5'", "still writing", "another file"});
    std::filesystem::remove(folder / "link");
    for (int tick = 50; tick < 100; ++tick) recorder.step(scene.input(tick));
    recorder.close();
    EXPECT_EQ(report("replay " + path("a.h5"))["steps"], 100) << when;
  }
  (void)drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  EXPECT_NE(report("replay " + path("a.h5"))["steps"], 100) << "the file is free again";
}

}  // namespace
}  // namespace hapticut::cli_replay_test
