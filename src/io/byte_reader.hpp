// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "hapticut/core/errors.hpp"

namespace hapticut {

/// The first bytes as a number.
/// @pre there are enough bytes
/// @param reversed  the bytes are in the opposite order to the machine's
template <class Number>
[[nodiscard]] Number number_in(std::string_view bytes, bool reversed = false) {
  std::array<char, sizeof(Number)> raw;
  std::copy_n(bytes.begin(), raw.size(), raw.begin());
  if (reversed) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

/// Appends the bytes of a number, in the machine's order.
template <class Number>
void append_bytes_of(std::string& bytes, const Number& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Reads the bytes of a file in order, never beyond their end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t position() const { return at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

  /// The next `count` bytes.
  /// @throws Error when the file has fewer
  std::string_view read(std::uint64_t count) {
    if (count > bytes_.size() - at_) throw Error("it ends too early; it is truncated or damaged. Get a complete copy.");
    const std::string_view part = bytes_.substr(at_, std::size_t(count));
    at_ += std::size_t(count);
    return part;
  }

  /// The next bytes as a number, little-endian unless `reversed`.
  template <class T>
  T read(bool reversed = false) {
    return number_in<T>(read(sizeof(T)), reversed);
  }

  /// Skips the next `count` bytes.
  /// @throws Error when the file has fewer
  void skip(std::uint64_t count) { (void)read(count); }

  /// Skips to a position.
  /// @throws Error when the position was passed already or is outside the file
  void advance_to(std::uint64_t position) {
    if (position < at_) throw Error("its table of offsets is damaged. Get a complete copy.");
    skip(position - at_);
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace hapticut
