// SPDX-License-Identifier: Apache-2.0
// hapticut inspect and convert, and behaviour common to all subcommands.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "hapticut/core/units.hpp"
#include "support/program.hpp"

namespace hapticut::cli_test {
namespace {

using namespace test;
using Inspect = Program;
using Convert = Program;

TEST_F(Inspect, CountsWhatABlockHoldsAndSaysWhereItIs) {
  const nlohmann::json report = inspect("block --size_mm 2,3,4 --voxel_mm 0.1 --material dentin");
  EXPECT_EQ(report["dims"], nlohmann::json({20, 30, 40}));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(report["size_mm"][axis].get<double>(), 2 + axis, 1e-9);
    EXPECT_NEAR(report["center_mm"]["dentin"][axis].get<double>(), (2 + axis) / 2.0, 1e-9);
  }
  EXPECT_NEAR(report["spacing_mm"][1].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(report["voxels"]["dentin"], 24000);
  EXPECT_NEAR(report["volume_mm3"]["dentin"].get<double>(), 24, 1e-9);
  EXPECT_GT(report["memory_bytes"], 0);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(report["box"]["min_mm"][axis].get<double>(), 0, 1e-9);
    EXPECT_NEAR(report["box"]["max_mm"][axis].get<double>(), 2 + axis, 1e-9);
  }
  EXPECT_EQ(report["pose"]["rotation"][1], nlohmann::json({0, 1, 0}));
  const std::string table = read_bytes(folder / "stdout");
  EXPECT_EQ(table.find("  size "), table.find('\n') + 1) << table;
  EXPECT_NE(table.find("2 x 3 x 4 mm"), std::string::npos) << table;
  EXPECT_NE(table.find(" g, centre 1 1.5 2 mm\n"), std::string::npos) << table;
}

TEST_F(Convert, KeepsAWorkpieceInVdb) {
  const ProgramOutcome outcome =
      run("convert block " + path("b.vdb") + " --size_mm 2,3,4 --voxel_mm 0.1 --material dentin");
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(inspect(path("b.vdb"))["voxels"]["dentin"], 24000);
}

TEST_F(Program, HelpsAndSaysItsVersion) {
  std::vector<std::string> names = {""};
  for (const apps::Command& command : apps::all_commands()) names.push_back(command.name + " ");
  for (const std::string& name : names) {
    const ProgramOutcome outcome = run(name + "--help");
    EXPECT_EQ(outcome.code, 0) << name;
    EXPECT_NE(outcome.out.find("Usage: hapticut"), std::string::npos) << name;
  }
  EXPECT_EQ(run("--version").out, HAPTICUT_PROGRAM_VERSION "\n");
}

}  // namespace
}  // namespace hapticut::cli_test
