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

/// An open box as a mesh, and a volume of one label.
void write_inputs(const TemporaryFolder& folder) {
  write_bytes(folder / "m.off", "OFF\n4 4 6\n0 0 0\n30 0 0\n0 30 0\n0 0 30\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  write_bytes(folder / "v.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 200 200 200\nspacings: 0.1 0.1 0.1\nencoding: raw\n\n" +
                  std::string(std::size_t(200) * 200 * 200, '\1'));
}

TEST_F(Memory, ThatRunsOutAnywhereIsOneSentence) {
  if (kWithAddressSanitizer || kWithThreadSanitizer) GTEST_SKIP() << "a sanitizer needs terabytes of address space";
  write_inputs(folder);
  std::vector<std::string> commands = {
      "inspect molar --voxel_mm 0.03", "convert molar " + path("m.vdb") + " --voxel_mm 0.04",
      "drill --workpiece molar --voxel_mm 0.04 --head sphere --radius_mm 1 --spindle_rpm 30000 --path line --from_mm "
      "0,0,9 --to_mm 0,0,8 --feed_mm_per_s 20"};
#ifdef HAPTICUT_HAS_IO
  commands.push_back("inspect " + path("m.off") + " --material dentin --voxel_mm 0.08");
  commands.push_back("inspect " + path("v.nrrd") + " --label dentin=1 --voxel_mm 0.07");
#endif
  int sentences = 0;
  for (const std::string& command : commands)
    for (int kilobytes = 250'000; kilobytes <= 1'000'000; kilobytes += 150'000) {
      const std::string limit = "bash -c 'ulimit -v " + std::to_string(kilobytes) + "; exec \"$0\" \"$@\"' ";
      const Outcome outcome = run_program(folder, command, limit + kProgram);
      if (outcome.code == 0 || outcome.code == 127) continue;  // 127: the libraries do not fit
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
