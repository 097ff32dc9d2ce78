// SPDX-License-Identifier: Apache-2.0
// The walk through a .vdb file that stands before OpenVDB, and OpenVDB behind it.
#include <cstdint>
#include <string>

#include "hapticut/core/errors.hpp"
#include "io/vdb/vdb_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    (void)hapticut::workpiece_of_vdb(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const hapticut::Error&) {
  }
  return 0;
}
