// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// @file
/// Text that is safe to show on a terminal, in a page, or as a Python string.
namespace hapticut {

/// Length [bytes] of the printable UTF-8 character that a text begins with; 0 if it begins with anything else.
[[nodiscard]] inline std::size_t printable_character(std::string_view text) {
  const auto lead = std::uint8_t(text.front());
  if (lead < 0x80) return lead >= ' ' && lead != 0x7f ? 1 : 0;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc0 || lead > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = lead & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((std::uint8_t(text[i]) & 0xc0U) != 0x80) return 0;
    code = code << 6 | (std::uint8_t(text[i]) & 0x3fU);
  }
  constexpr std::uint32_t kFirst[] = {0xa0, 0x800, 0x10000};  // 0x80 ... 0x9f control terminals
  const bool is_half_of_a_pair = code >= 0xd800 && code <= 0xdfff;
  return code >= kFirst[length - 2] && code <= 0x10ffff && !is_half_of_a_pair ? length : 0;
}

/// Makes a text one line of valid UTF-8: each byte that is not part of a printable character becomes a question mark.
[[nodiscard]] inline std::string on_one_line(std::string sentence) {
  for (std::size_t at = 0; at < sentence.size();) {
    const std::size_t length = printable_character(std::string_view(sentence).substr(at));
    if (length == 0) sentence[at] = '?';
    at += length == 0 ? 1 : length;
  }
  return sentence;
}

}  // namespace hapticut
