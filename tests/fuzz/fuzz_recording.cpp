// SPDX-License-Identifier: Apache-2.0
// A fuzzer of recordings: the library opens damaged files with accepted checksums. HDF5 may crash the reader program;
// then the file is refused.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "support/temporary_folder.hpp"

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {
  return ::setenv("HAPTICUT_RECORDING_READER", FUZZ_READER, 1);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticut;
  constexpr std::uint64_t kSteps = 100;
  static const test::TemporaryFolder folder;
  test::write_bytes(folder / "a.h5", {reinterpret_cast<const char*>(data), size});
  try {
    const Recording recording = read_recording(folder / "a.h5");
    (void)recording.read(0, kSteps);
    (void)recording.read(recording.size() - std::min(kSteps, recording.size()), kSteps);
    (void)recording.workpiece();
  } catch (const Error&) {
  }
  return 0;
}
