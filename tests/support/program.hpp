// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/places.hpp"
#include "support/temporary_folder.hpp"

/// @file
/// Runs the command line program as a user does.
namespace hapticut::test {

struct ProgramOutcome {
  int code;            // exit code
  std::string out;     // what was printed
  std::string errors;  // what was printed on stderr
};

/// Runs `hapticut <arguments>`. The outputs go to the folder's files `stdout` and `stderr`.
inline ProgramOutcome run_program(const TemporaryFolder& folder, const std::string& arguments,
                                  const std::string& program = kProgram) {
  const std::string out = (folder / "stdout").string(), errors = (folder / "stderr").string();
  const std::string command = program + " " + arguments + " >" + out + " 2>" + errors + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(out), read_bytes(errors)};
}

inline nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return nlohmann::json::parse(stream);
}

// A 6 mm block of cortical bone, a ball of 1 mm radius; coarse voxels keep the tests short.
inline const std::string kBlock = "--workpiece block --size_mm 6,6,3 --material cortical_bone --voxel_mm 0.2 ";
inline const std::string kSpinningBall = "--head sphere --radius_mm 1 --spindle_rpm 30000 ";
inline const std::string kBall = kSpinningBall + "--reference_stiffness 1e14 ";
inline const std::string kStiffBall = kSpinningBall + "--reference_stiffness 3e15 ";  // a thin engaged layer
inline const std::string kGroove = "--path line --from_mm -2,3,2.5 --to_mm 8,3,2.5 --feed_mm_per_s 20 ";

inline constexpr int kFailed = 1, kWrongUsage = 2;  // exit codes

/// The columns of a CSV file by name; text cells read as 0.
inline std::map<std::string, std::vector<double>> read_csv(const std::string& text) {
  std::istringstream lines(text);
  std::string line, cell;
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  for (int row = 0; std::getline(lines, line); ++row) {
    std::istringstream cells(line);
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (row == 0)
        names.push_back(cell);
      else
        columns[names.at(i)].push_back(std::atof(cell.c_str()));
    }
  }
  return columns;
}

class Program : public testing::Test {
 protected:
  ProgramOutcome run(const std::string& arguments) { return run_program(folder, arguments); }
  /// The report of a command that succeeds.
  nlohmann::json report(const std::string& arguments) {
    const ProgramOutcome outcome = run(arguments + " --json " + path("report.json"));
    EXPECT_EQ(outcome.code, 0) << arguments << '\n' << outcome.errors;
    return outcome.code == 0 ? read_json(folder / "report.json") : nlohmann::json();
  }
  nlohmann::json inspect(const std::string& arguments) { return report("inspect " + arguments); }
  nlohmann::json drill(const std::string& arguments) {
    const nlohmann::json of_run = report("drill " + arguments);
    EXPECT_EQ(read_bytes(folder / "stderr"), "") << arguments;
    return of_run;
  }
  /// Every step of a path, by the columns of its file.
  std::map<std::string, std::vector<double>> steps(const std::string& arguments) {
    (void)drill(arguments + " --steps_csv " + path("steps.csv"));
    return read_csv(read_bytes(folder / "steps.csv"));
  }
  /// The message of a refused command: one line without C++ names.
  std::string refusal(const std::string& arguments, int code = kFailed, const std::string& program = kProgram) {
    const ProgramOutcome outcome = run_program(folder, arguments, program);
    EXPECT_EQ(outcome.code, code) << arguments << '\n' << outcome.errors;
    EXPECT_TRUE(outcome.errors.starts_with("hapticut: ")) << outcome.errors;
    EXPECT_EQ(outcome.errors.find('\n'), outcome.errors.size() - 1) << outcome.errors;
    EXPECT_EQ(outcome.errors.find("::"), std::string::npos) << outcome.errors;
    return outcome.errors;
  }
  void expect_refused(const std::string& arguments, const std::vector<std::string>& parts, int code = kFailed,
                      const std::string& program = kProgram) {
    const std::string said = refusal(arguments, code, program);
    for (const std::string& part : parts)
      EXPECT_NE(said.find(part), std::string::npos) << arguments << '\n' << said << "lacks: " << part;
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  TemporaryFolder folder;
};

}  // namespace hapticut::test
