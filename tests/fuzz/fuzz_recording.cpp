// SPDX-License-Identifier: Apache-2.0
// A fuzzer of recordings: what HDF5 and the reader make of damaged bytes. HDF5 itself is not compiled for it, so it
// sees a wrong access there only when it ends the program.
#include <algorithm>
#include <cstdint>
#include <string>

#include "hapticut/core/errors.hpp"
#include "io/recording/recording_access.hpp"

/// HDF5 forgets some hundred bytes of a file that it refuses.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticut;
  constexpr std::uint64_t kSteps = 100;
  try {
    const Recording recording = recording_of_bytes({reinterpret_cast<const char*>(data), size}, "a.h5");
    (void)recording.read(0, kSteps);
    (void)recording.read(recording.size() - std::min(kSteps, recording.size()), kSteps);
    (void)recording.workpiece();
  } catch (const Error&) {
  }
  return 0;
}
