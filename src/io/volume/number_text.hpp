// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "io/mesh/text_lines.hpp"

namespace hapticut {

/// The numbers of a text, whatever the language of the machine; nothing where one of its words is none.
/// @param separators  any of these characters stand between two numbers
[[nodiscard]] inline std::optional<std::vector<double>> numbers_in(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;
       at = text.find_first_not_of(separators, at)) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    const std::optional<double> number = parse_real(text.substr(at, end - at));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    at = end;
  }
  return numbers;
}

}  // namespace hapticut
