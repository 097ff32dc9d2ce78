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
/// @pre there are as many
/// @param reversed  they are in the other order than the machine's
template <class Number>
[[nodiscard]] Number number_in(std::string_view bytes, bool reversed = false) {
  std::array<char, sizeof(Number)> raw;
  std::copy_n(bytes.begin(), raw.size(), raw.begin());
  if (reversed) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

/// Puts the bytes of a number behind others, in the machine's order.
template <class Number>
void append_bytes_of(std::string& bytes, const Number& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Goes through the bytes of a file and never beyond their end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t position() const { return at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

  /// The next `count` bytes.
  /// @throws Error when the file has fewer
  std::string_view take(std::uint64_t count) {
    if (count > bytes_.size() - at_) throw Error("it ends too early; it was cut off or damaged. Get a complete copy.");
    const std::string_view part = bytes_.substr(at_, std::size_t(count));
    at_ += std::size_t(count);
    return part;
  }

  /// The next bytes as a number, little-endian like the machine unless they are reversed.
  template <class T>
  T take(bool reversed = false) {
    return number_in<T>(take(sizeof(T)), reversed);
  }

  /// @throws Error when that is behind or outside the file
  void advance_to(std::uint64_t position) {
    if (position < at_) throw Error("its table of offsets is damaged. Get a complete copy.");
    take(position - at_);
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace hapticut
