// SPDX-License-Identifier: Apache-2.0
// A fuzzer of .vdb files: the check before OpenVDB, then OpenVDB. Reads a saved workpiece, else a level set or fog
// volume of another program.
#include <cstdint>
#include <string>

#include "hapticut/core/errors.hpp"
#include "io/vdb/vdb_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticut;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    (void)workpiece_of_vdb(bytes);
    return 0;
  } catch (const Error&) {
  }
  try {
    (void)workpiece_of_vdb(bytes, VdbImport{.material = {.name = "any"}});
  } catch (const Error&) {
  }
  return 0;
}
