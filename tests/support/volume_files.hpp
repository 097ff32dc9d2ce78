// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

/// Writes volumes in formats that the library only reads, byte by byte from the descriptions of the formats, for tests
/// without external files.
namespace hapticut::test {

template <class Number>
std::string little(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

template <class Number>
std::string big(Number number) {
  const std::string bytes = little(number);
  return {bytes.rbegin(), bytes.rend()};
}

template <class Number>
std::string little(const std::vector<Number>& numbers) {
  std::string bytes;
  for (const Number number : numbers) bytes += little(number);
  return bytes;
}

/// A gzip file.
inline std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, uLong(bytes.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// One PNG slice of grey values.
/// @param claimed_width, claimed_height, kind  values of the header, which may be false; kind 0: grey values
template <class Grey>
std::string png_slice(std::uint32_t width, std::uint32_t height, const std::vector<Grey>& values,
                      std::uint32_t claimed_width = 0, std::uint32_t claimed_height = 0, char kind = 0) {
  const auto chunk = [](const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto sum = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
    return big(std::uint32_t(data.size())) + body + big(sum);
  };
  std::string rows;
  for (std::uint32_t y = 0; y < height; ++y) {
    rows += '\0';  // not filtered
    for (std::uint32_t x = 0; x < width; ++x) rows += big(values[y * width + x]);
  }
  uLongf size = compressBound(uLong(rows.size()));
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
           uLong(rows.size()));
  packed.resize(size);
  const std::string header = big(claimed_width != 0 ? claimed_width : width) +
                             big(claimed_height != 0 ? claimed_height : height) + char(8 * sizeof(Grey)) + kind +
                             std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", packed) + chunk("IEND", "");
}

/// One uncompressed TIFF slice of grey values.
template <class Grey>
std::string tiff_slice(std::uint32_t width, std::uint32_t height, const std::vector<Grey>& values,
                       std::uint32_t claimed_width = 0, std::uint32_t claimed_height = 0) {
  const std::string data = little(values) + (values.size() * sizeof(Grey) % 2 != 0 ? std::string(1, '\0') : "");
  const auto size = std::uint32_t(values.size() * sizeof(Grey));
  const std::uint32_t w = claimed_width != 0 ? claimed_width : width;
  const std::uint32_t h = claimed_height != 0 ? claimed_height : height;
  constexpr std::uint32_t kFirst = 8;  // byte of the file where the values begin
  const std::map<std::uint16_t, std::uint32_t> tags = {
      {256, w}, {257, h}, {258, 8 * sizeof(Grey)}, {259, 1}, {262, 1}, {273, kFirst}, {277, 1}, {278, h}, {279, size}};
  constexpr std::uint16_t kLong = 4;
  std::string directory = little(std::uint16_t(tags.size()));
  for (const auto& [tag, value] : tags)
    directory += little(tag) + little(kLong) + little(std::uint32_t(1)) + little(value);
  return std::string("II*\0", 4) + little(std::uint32_t(kFirst + data.size())) + data + directory +
         std::string(4, '\0');
}

/// A NIfTI-1 file of int16 values.
struct NiftiFile {
  std::vector<std::int16_t> dims = {4, 3, 5};  ///< number of samples along each axis
  std::vector<float> spacing = {0.1F, 0.2F, 0.7F};
  std::vector<float> rows = {};        ///< 12 numbers: the affine map to x right, y front, z up, in mm
  std::vector<float> quaternion = {};  ///< 6 numbers: b, c, d and the offset, in mm
  float qfac = 1, slope = 0, intercept = 0;
  std::vector<std::int16_t> values = {};

  [[nodiscard]] std::string bytes(bool big_endian = false) const {
    std::string header(352, '\0');
    const auto put = [&](std::size_t at, auto number) {
      const std::string part = big_endian ? big(number) : little(number);
      header.replace(at, part.size(), part);
    };
    put(0, std::int32_t(348));
    put(40, std::int16_t(dims.size()));
    for (std::size_t n = 0; n < 7; ++n) put(42 + 2 * n, n < dims.size() ? dims[n] : std::int16_t(1));
    put(70, std::int16_t(4));  // int16
    put(72, std::int16_t(16));
    put(76, qfac);
    for (std::size_t n = 0; n < spacing.size(); ++n) put(80 + 4 * n, spacing[n]);
    put(108, 352.0F);
    put(112, slope);
    put(116, intercept);
    header[123] = 2;  // mm
    put(252, std::int16_t(quaternion.empty() ? 0 : 1));
    put(254, std::int16_t(rows.empty() ? 0 : 1));
    for (std::size_t n = 0; n < quaternion.size(); ++n) put(256 + 4 * n, quaternion[n]);
    for (std::size_t n = 0; n < rows.size(); ++n) put(280 + 4 * n, rows[n]);
    header.replace(344, 3, "n+1");
    for (const std::int16_t value : values) header += big_endian ? big(value) : little(value);
    return header;
  }
};

/// A tar archive.
inline std::string tar_archive(const std::map<std::string, std::string>& files) {
  std::string archive;
  for (const auto& [name, content] : files) {
    std::string header(512, '\0');
    const auto put = [&](std::size_t at, const char* format, auto value) {
      char text[32];
      std::snprintf(text, sizeof text, format, value);
      header.replace(at, std::strlen(text), text);
    };
    header.replace(0, name.size(), name);
    put(100, "%07o", 0644U);
    put(108, "%07o", 0U);
    put(116, "%07o", 0U);
    put(124, "%011lo", static_cast<unsigned long>(content.size()));
    put(136, "%011o", 0U);
    header.replace(148, 8, "        ");
    header[156] = '0';
    header.replace(257, 5, "ustar");
    header.replace(263, 2, "00");
    unsigned sum = 0;
    for (const char c : header) sum += static_cast<unsigned char>(c);
    put(148, "%06o", sum);
    header[154] = '\0';
    archive += header + content + std::string((512 - content.size() % 512) % 512, '\0');
  }
  return archive + std::string(1024, '\0');
}

/// A project of InVesalius.
inline std::string invesalius_project(const std::array<int, 3>& dims, const std::vector<std::int16_t>& values) {
  const auto array = [](const std::string& tag, const std::vector<std::string>& numbers) {
    std::string text = "<array>";
    for (const std::string& number : numbers)
      text += std::string("<").append(tag).append(">") + number + "</" + tag + ">";
    return text + "</array>";
  };
  const std::string list =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<plist version=\"1.0\"><dict><key>matrix</key><dict>"
      "<key>dtype</key><string>int16</string><key>filename</key><string>matrix.dat</string><key>shape</key>" +
      array("integer", {std::to_string(dims[2]), std::to_string(dims[1]), std::to_string(dims[0])}) +
      "</dict><key>spacing</key>" + array("real", {"0.1", "0.2", "0.7"}) + "</dict></plist>\n";
  return gzipped(tar_archive({{"project/main.plist", list}, {"project/matrix.dat", little(values)}}));
}

}  // namespace hapticut::test
