// SPDX-License-Identifier: Apache-2.0
// Checks of compressed pictures, and the run-length decoder (PS3.5, annex G).
#include <array>

#include "hapticut/core/errors.hpp"
#include "import/dicom/dicom_picture.hpp"
#include "io/byte_reader.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kRleHeader = 64;  // [bytes]

[[noreturn]] void fail_rle(const std::string& reason) {
  throw Error("its picture, compressed by run lengths (RLE), is damaged: " + reason + ". Get a complete copy.");
}

/// Unpacks one byte of each value, in the order of the values.
void unpack_segment(std::string_view segment, std::size_t samples, char* to, std::size_t step) {
  std::size_t done = 0;
  const auto put = [&](char value) {
    if (done == samples) fail_rle("a segment contains too many values");
    to[step * done++] = value;
  };
  for (std::size_t at = 0; at < segment.size() && done < samples;) {
    const int byte = std::uint8_t(segment[at++]), n = byte < 128 ? byte : byte - 256;
    if (n >= 0) {
      if (std::size_t(n) + 1 > segment.size() - at) fail_rle("a segment is truncated");
      for (int k = 0; k <= n; ++k) put(segment[at++]);
    } else if (n > -128) {
      if (at == segment.size()) fail_rle("a segment is truncated");
      for (int k = 0; k <= -n; ++k) put(segment[at]);
      ++at;
    }
  }
  if (done < samples) fail_rle("a segment contains too few values");
}

}  // namespace

std::string unpack_rle(std::string_view packed, std::size_t samples, std::size_t bytes_per_sample) {
  if (packed.size() < kRleHeader) fail_rle("it has no header");
  const auto header = number_in<std::array<std::uint32_t, kRleHeader / 4>>(packed);
  if (header[0] != bytes_per_sample)
    fail_rle("it has " + std::to_string(header[0]) + " segments; there must be " + std::to_string(bytes_per_sample));
  std::string values(samples * bytes_per_sample, '\0');
  for (std::size_t n = 0; n < bytes_per_sample; ++n) {
    const std::size_t begin = header[n + 1], end = n + 1 < bytes_per_sample ? header[n + 2] : packed.size();
    if (begin < kRleHeader || begin > end || end > packed.size()) fail_rle("its segments lie outside of it");
    // The most significant byte is first.
    unpack_segment(packed.substr(begin, end - begin), samples, values.data() + (bytes_per_sample - 1 - n),
                   bytes_per_sample);
  }
  return values;
}

void require_jpeg_2000_of(std::string_view stream, const DicomPicture& picture) {
  constexpr std::size_t kHeader = 42;
  const std::size_t begin = stream.find(std::string_view("\xff\x4f\xff\x51", 4));
  if (begin == std::string_view::npos || stream.size() - begin < kHeader)
    throw Error("its picture is not in JPEG 2000, although its header says so; it is damaged. Get a complete copy.");
  const std::string_view header = stream.substr(begin, kHeader);
  const auto word = [&](std::size_t at) { return number_in<std::uint32_t>(header.substr(at), true); };
  const std::uint32_t left = word(16), top = word(20), tile_width = word(24), tile_height = word(28),
                      tile_left = word(32), tile_top = word(36);
  const bool of_the_size = std::uint64_t(word(8)) == std::uint64_t(left) + std::uint64_t(picture.geometry.dims[0]) &&
                           std::uint64_t(word(12)) == std::uint64_t(top) + std::uint64_t(picture.geometry.dims[1]);
  const bool has_tiles = tile_width > 0 && tile_height > 0 && tile_left <= left && tile_top <= top &&
                         std::uint64_t(tile_left) + tile_width > left && std::uint64_t(tile_top) + tile_height > top;
  if (!of_the_size || !has_tiles || header.substr(40, 2) != std::string_view("\0\1", 2))
    throw Error("the size of its JPEG 2000 picture differs from its header; it is damaged. Get a complete copy.");
}

}  // namespace hapticut
