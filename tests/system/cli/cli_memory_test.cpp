// SPDX-License-Identifier: Apache-2.0
// The program with little memory: it does its work, or it ends with one sentence and exit code 1.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/sanitizers.hpp"

namespace hapticut::cli_memory_test {
namespace {

using namespace test;
using Memory = Program;

/// A volume of two labels that alternate, so that every block of the workpiece needs its own memory.
void write_checkerboard(const std::filesystem::path& path) {
  constexpr int kEdge = 240;  // samples
  std::string bytes =
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 240 240 240\nspacings: 0.1 0.1 0.1\nencoding: raw\n\n";
  for (int k = 0; k < kEdge; ++k)
    for (int j = 0; j < kEdge; ++j)
      for (int i = 0; i < kEdge; ++i) bytes += char(1 + (i + j + k) % 2);
  write_bytes(path, bytes);
}

TEST_F(Memory, ThatRunsOutAnywhereIsOneSentence) {
  if (kWithAddressSanitizer || kWithThreadSanitizer) GTEST_SKIP() << "a sanitizer needs terabytes of address space";
  std::vector<std::string> commands = {"inspect molar --voxel_mm 0.02"};
#ifdef HAPTICUT_HAS_IMPORT
  write_checkerboard(folder / "v.nrrd");
  commands = {"inspect " + path("v.nrrd") + " --label dentin=1 --label enamel=2",
              "convert " + path("v.nrrd") + " " + path("v.vdb") + " --label dentin=1 --label enamel=2"};
#endif
  int sentences = 0;
  for (const std::string& command : commands)
    for (int kilobytes = 200'000; kilobytes <= 400'000; kilobytes += 10'000) {
      const std::string limit = "bash -c 'ulimit -v " + std::to_string(kilobytes) + "; exec \"$0\" \"$@\"' ";
      const ProgramOutcome outcome = run_program(folder, command, limit + kProgram);
      if (outcome.code == 127) continue;  // the libraries do not fit
      if (outcome.code == 0) break;       // nor does it fail with more memory
      ++sentences;
      EXPECT_EQ(outcome.code, kFailed) << command << " with " << kilobytes << " kB\n" << outcome.errors;
      EXPECT_TRUE(outcome.errors.starts_with("hapticut: ")) << command << " with " << kilobytes << '\n'
                                                            << outcome.errors;
      EXPECT_EQ(outcome.errors.find('\n'), outcome.errors.size() - 1) << command << '\n' << outcome.errors;
      EXPECT_NE(outcome.errors.find("memory"), std::string::npos) << command << '\n' << outcome.errors;
    }
  EXPECT_GT(sentences, 3) << "the limits must matter";
}

}  // namespace
}  // namespace hapticut::cli_memory_test
