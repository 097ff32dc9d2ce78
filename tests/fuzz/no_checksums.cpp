// SPDX-License-Identifier: Apache-2.0
// Replaces HDF5's function in the fuzzer's reader: accepts every checksum of metadata.
#include <cstddef>
#include <cstdint>

extern "C" int H5F_get_checksums(const std::uint8_t* /*bytes*/, std::size_t /*count*/, std::uint32_t* stored,
                                 std::uint32_t* computed) {
  if (stored != nullptr) *stored = 0;
  if (computed != nullptr) *computed = 0;
  return 0;
}
