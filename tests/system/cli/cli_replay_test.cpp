// SPDX-License-Identifier: Apache-2.0
// hapticut drill --record, replay and export, run as a user runs them.
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace hapticut::cli_replay_test {
namespace {

using namespace test;
using Replay = Program;

TEST_F(Replay, OfADrilledGrooveIsIdentical) {
  const nlohmann::json drilled = drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  const Outcome outcome = run("replay " + path("a.h5") + " --json " + path("replay.json"));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_NE(outcome.out.find("every bit"), std::string::npos);
  const nlohmann::json report = read_json(folder / "replay.json");
  EXPECT_EQ(report["steps"], drilled["steps"]);
  EXPECT_EQ(report["identical"], true);
  EXPECT_TRUE(report["first_difference"].is_null());
  EXPECT_EQ(report["recording"]["closed"], true);
  EXPECT_EQ(report["recording"]["lost_steps"], 0);
  EXPECT_EQ(report["build"], (nlohmann::json{{"version", drilled["build"]["version"]},
                                             {"commit", drilled["build"]["commit"]},
                                             {"compiler", drilled["build"]["compiler"]},
                                             {"cpu", drilled["build"]["cpu"]}}));
}

TEST_F(Replay, OfAFileThatIsCutShortIsRefused) {
  (void)drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  const std::string bytes = read_bytes(folder / "a.h5");
  write_bytes(folder / "a.h5", bytes.substr(0, bytes.size() / 2));
  const Outcome outcome = run("replay " + path("a.h5"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("damaged"), std::string::npos) << outcome.errors;
}

TEST_F(Replay, NeedsAFile) {
  EXPECT_EQ(run("replay").code, 2);
  EXPECT_EQ(run("replay " + path("absent.h5")).code, 1);
  EXPECT_EQ(run("export").code, 2);
  EXPECT_EQ(run("export " + path("absent.h5")).code, 2);
}

TEST_F(Replay, ExportsTextAndArrays) {
  const nlohmann::json drilled = drill(kBlock + kBall + kGroove + "--record " + path("a.h5"));
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.csv")).code, 0);
  const auto columns = read_csv(read_bytes(folder / "a.csv"));
  EXPECT_EQ(columns.at("force_2").size(), drilled["steps"].get<std::size_t>());
  EXPECT_NEAR(columns.at("energy_cutting").back() / drilled["energy_J"]["cutting"].get<double>(), 1, 1e-12);
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.npz")).code, 0);
  EXPECT_EQ(read_bytes(folder / "a.npz").substr(0, 2), "PK");
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.wav")).code, 0);
  EXPECT_EQ(read_bytes(folder / "a.wav").substr(0, 4), "RIFF");
  EXPECT_EQ(run("export " + path("a.h5") + " " + path("a.doc")).code, 1);
}

TEST_F(Replay, SaysBeforeTheWorkThatARecordingCannotBeWritten) {
  std::ofstream(folder / "file") << "no folder";
  const Outcome outcome = run("drill " + kBlock + kBall + kGroove + "--record " + path("file/a.h5"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.errors.find("file/a.h5"), std::string::npos);
}

}  // namespace
}  // namespace hapticut::cli_replay_test
