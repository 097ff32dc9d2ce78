// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// @file
/// Compressed data in memory. What is damaged, cut short or grows beyond a limit is an Error, a sentence that begins
/// with "its".
namespace hapticut {

/// Unpacks gzip or zlib data; several gzip members make one whole.
/// @param max_bytes  [bytes] that may come out
[[nodiscard]] std::string unpack_gzip(std::string_view packed, std::uint64_t max_bytes);

/// The first unpacked bytes, at max_bytes `count`.
[[nodiscard]] std::string start_of_gzip(std::string_view packed, std::size_t count);

/// @param max_bytes  [bytes] that may come out
[[nodiscard]] std::string unpack_bzip2(std::string_view packed, std::uint64_t max_bytes);

}  // namespace hapticut
