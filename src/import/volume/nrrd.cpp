// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>
#include <type_traits>

#include "import/volume/formats.hpp"
#include "import/volume/nrrd_header.hpp"
#include "import/volume/unpack.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

// The common NRRD library copies header lines into a buffer of fixed length, and treats `left-anterior-superior` as the
// mirror image of `right-anterior-superior`. So the format is parsed here.

/// Position of the values when unpacked data begin with the header of a NIfTI file; else 0.
std::uint64_t nifti_header_in(const std::string& data) {
  if (data.size() < 352 || data.compare(344, 4, "n+1", 4) != 0) return 0;
  const auto offset = number_in<float>(std::string_view(data).substr(108));
  return offset >= 348 && offset < 1e9F ? std::uint64_t(offset) : 0;
}

/// Position of the values within `total` unpacked bytes.
std::uint64_t values_offset(const NrrdHeader& header, std::uint64_t nifti, std::uint64_t total, std::uint64_t needed) {
  if (header.byte_skip > 0) return std::uint64_t(header.byte_skip);
  if (header.byte_skip < 0) {
    // -1 means: the last bytes of the data; -1 - n: n bytes before that, but not before the first byte.
    const std::uint64_t before_end = needed + std::uint64_t(-(header.byte_skip + 1));
    return before_end < total ? total - before_end : 0;
  }
  // The data file is a whole NIfTI file: its header is not part of the values.
  return nifti + needed == total ? nifti : 0;
}

std::size_t after_lines(std::string_view data, std::int64_t count) {
  std::size_t at = 0;
  for (; count > 0; --count) {
    const std::size_t end = data.find('\n', at);
    if (end == std::string_view::npos) throw Error("it has fewer lines than its header says to skip.");
    at = end + 1;
  }
  return at;
}

/// Parses numbers in text form, in the type of the header.
template <class Value>
void append_value(double number, std::string& bytes) {
  if constexpr (std::is_integral_v<Value>) {
    const double end = std::ldexp(1.0, std::numeric_limits<Value>::digits);  // first value that does not fit
    if (!(number >= double(std::numeric_limits<Value>::min()) && number < end && number == std::floor(number)))
      throw Error("it has the value " + format_number(number, std::round(number)) + ", which does not fit its type.");
  }
  append_bytes_of(bytes, Value(number));
}

std::string parse_text_values(std::string_view text, ValueType type, std::uint64_t count) {
  std::string bytes;
  TextLines words(text);
  const auto is_end = [](std::string_view word) { return word.find_first_not_of('\0') == std::string_view::npos; };
  for (std::uint64_t n = 0; n < count; ++n) {
    std::string_view word = words.word_of_any_line();
    if (word.ends_with(',')) word.remove_suffix(1);
    const std::optional<double> number = parse_real(word);
    if (!number)
      throw Error(word.empty() ? "it has " + std::to_string(n) + " values instead of " + std::to_string(count) + "."
                               : in_quotes(word) + " among its values is not a number.");
    with_value_type(type, [&](auto zero) { append_value<decltype(zero)>(*number, bytes); });
  }
  if (const std::string_view more = words.word_of_any_line(); !is_end(more))
    throw Error("it has more than " + std::to_string(count) + " values: " + in_quotes(more) +
                " follows them. Check the sizes in its header.");
  return bytes;
}

std::string from_hex(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdefABCDEF";
  std::string bytes;
  int high = -1;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
    const std::size_t place = kDigits.find(c);
    if (place == std::string_view::npos) throw Error("its values are not hexadecimal digits.");
    const int digit = int(place < 16 ? place : place - 6);
    if (high >= 0) bytes += char(16 * high + digit);
    high = high < 0 ? digit : -1;
  }
  return bytes;
}

/// @param slices  number of slices among the values, 0 if they are a part of one
std::string parse_nrrd_values(const NrrdHeader& header, std::string_view data, std::uint64_t samples,
                              std::uint64_t slices) {
  const std::uint64_t needed = samples * size_of(header.type);
  data.remove_prefix(after_lines(data, header.line_skip));
  if (header.encoding == "ascii") {
    require_bytes(double(samples), double(data.size()), kNotCompressed);
    return parse_text_values(data, header.type, samples);
  }
  std::string unpacked;
  std::string_view values = data;
  if (header.encoding == "hex") values = unpacked = from_hex(data);
  if (header.encoding == "gzip" || header.encoding == "bzip2") {
    require_bytes(double(needed), double(data.size()), kDeflate);
    // A header or skipped bytes may precede the values.
    const std::uint64_t max_bytes =
        2 * needed + std::uint64_t(std::max<std::int64_t>(header.byte_skip, 0)) + (1U << 20U);
    values = unpacked = header.encoding == "gzip" ? unpack_gzip(data, max_bytes) : unpack_bzip2(data, max_bytes);
  }
  const std::uint64_t nifti = header.encoding == "raw" ? 0 : nifti_header_in(unpacked);
  const std::uint64_t offset = values_offset(header, nifti, values.size(), needed);
  require_bytes(double(offset) + double(needed), double(values.size()), kNotCompressed);
  if (header.byte_skip >= 0)
    require_no_more(offset + needed, values, needed / std::max<std::uint64_t>(slices, 1), header.data_files.empty());
  return std::string(values.substr(offset, needed));
}

}  // namespace

RawImage parse_nrrd(std::string_view bytes, const DataFile& data_file) {
  const NrrdHeader header = parse_nrrd_header(bytes);
  RawImage image;
  image.type = header.type;
  image.geometry = header.geometry;
  const std::uint64_t samples = image.needed() / size_of(image.type),
                      files = std::max<std::size_t>(1, header.data_files.size());
  if (samples % files != 0) throw Error("its samples cannot be divided among its " + std::to_string(files) + " files.");
  const std::uint64_t slices = std::uint64_t(image.geometry.dims[2]) / files;
  if (header.data_files.empty()) image.bytes = parse_nrrd_values(header, bytes.substr(header.end), samples, slices);
  for (const std::string& name : header.data_files)
    image.bytes += parse_nrrd_values(header, data_file(name), samples / files, slices);
  if (header.big_endian != (std::endian::native == std::endian::big)) swap_bytes(image);
  return image;
}

}  // namespace hapticut
