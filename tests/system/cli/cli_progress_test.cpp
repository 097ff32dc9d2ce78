// SPDX-License-Identifier: Apache-2.0
// A progress bar for long work, only on a terminal.
#include <gtest/gtest.h>

#include <regex>

#include "support/program.hpp"
#include "support/terminal.hpp"

namespace hapticut::cli_progress_test {
namespace {

/// Commands that may take long, on small inputs.
struct LongWork {
  const char* name;
  std::string arguments;
  std::string bar;  // regular expression of the output
};

void PrintTo(const LongWork& work, std::ostream* out) { *out << work.name; }

class Progress : public testing::TestWithParam<LongWork> {
 protected:
  [[nodiscard]] std::string arguments() const {
    return std::regex_replace(GetParam().arguments, std::regex("FOLDER"), (folder_ / "").string());
  }
  test::TemporaryFolder folder_;
};

TEST_P(Progress, IsDrawnOnATerminalAndWipedAwayBeforeAnythingElseIsPrinted) {
  const std::string written = test::run_on_terminal(std::string(test::kProgram) + " " + arguments());
  const std::string bar = "\r" + GetParam().bar, wiped = "\r\x1b\\[K";
  EXPECT_TRUE(std::regex_search(written, std::regex(bar))) << written;
  EXPECT_FALSE(std::regex_search(written, std::regex(bar + "(?!" + bar + "|" + wiped + ")"))) << written;
}

TEST_P(Progress, IsNotWrittenToAFileOrAPipe) {
  const test::ProgramOutcome outcome = test::run_program(folder_, arguments());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
}

std::vector<LongWork> long_works() {
  std::vector<LongWork> works = {
      {"Drill", "drill " + test::kBlock + test::kBall + test::kGroove, "drilling \\[[#.]{40}\\] +[0-9]+ %"},
      {"Inspect", "inspect molar --voxel_mm 0.4", "making the workpiece of molar, [0-9]+ s"},
      {"Convert", "convert molar FOLDERmolar.vdb --voxel_mm 0.4", "making the workpiece of molar, [0-9]+ s"},
      {"Validate", "validate --only milling", "validating \\[[#.]{40}\\] +[0-9]+ %"},
      {"Stability", "stability --device touch", "simulating devices, [0-9]+ s"},
  };
  return works;
}

INSTANTIATE_TEST_SUITE_P(Commands, Progress, testing::ValuesIn(long_works()),
                         [](const auto& work) { return std::string(work.param.name); });

}  // namespace
}  // namespace hapticut::cli_progress_test
