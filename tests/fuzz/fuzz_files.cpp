// SPDX-License-Identifier: Apache-2.0
// A fuzzer of a format that is read from a file: recordings, settings, poses and profiles. FUZZ_FORMAT names it, and
// FUZZ_ENDING is that of its files.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "fuzz/readers.hpp"
#include "support/temporary_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hapticut::test::TemporaryFolder folder;
  const std::filesystem::path path = folder / ("input" FUZZ_ENDING);
  hapticut::test::write_bytes(path, {reinterpret_cast<const char*>(data), size});
  try {
    hapticut::test::read_as(FUZZ_FORMAT, path);
  } catch (const hapticut::Error&) {
  }
  return 0;
}
