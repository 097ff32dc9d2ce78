// SPDX-License-Identifier: Apache-2.0
// In front of HDF5's own function, in the fuzzer's reader: every checksum of metadata is right, as one that was made to
// fit.
#include <cstddef>
#include <cstdint>

extern "C" int H5F_get_checksums(const std::uint8_t* /*bytes*/, std::size_t /*count*/, std::uint32_t* stored,
                                 std::uint32_t* computed) {
  if (stored != nullptr) *stored = 0;
  if (computed != nullptr) *computed = 0;
  return 0;
}
