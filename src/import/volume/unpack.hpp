// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// @file
/// Unpacks compressed data in memory. Throws an Error without the name of the file when the data are damaged,
/// truncated or exceed a limit.
namespace hapticut {

/// Unpacks gzip or zlib data; several gzip members are concatenated.
/// @param max_bytes  [bytes] limit of the unpacked size
[[nodiscard]] std::string unpack_gzip(std::string_view packed, std::uint64_t max_bytes);

/// The first unpacked bytes, up to `count`.
[[nodiscard]] std::string start_of_gzip(std::string_view packed, std::size_t count);

/// @param max_bytes  [bytes] limit of the unpacked size
[[nodiscard]] std::string unpack_bzip2(std::string_view packed, std::uint64_t max_bytes);

}  // namespace hapticut
