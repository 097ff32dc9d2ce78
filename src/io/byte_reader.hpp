// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

#include "hapticut/core/errors.hpp"

namespace hapticut {

/// Goes through the bytes of a file and never beyond their end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t position() const { return at_; }

  /// The next `count` bytes.
  /// @throws Error when the file has fewer
  std::string_view take(std::uint64_t count) {
    if (count > bytes_.size() - at_) throw Error("it ends too early; it was cut off or damaged. Get a complete copy.");
    const std::string_view part = bytes_.substr(at_, std::size_t(count));
    at_ += std::size_t(count);
    return part;
  }

  /// The next bytes as a number, little-endian like the machine.
  template <class T>
  T take() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
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
