// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/description.hpp"

#include <cmath>

#include "hapticut/core/errors.hpp"

namespace hapticut {

bool Range::contains(double value) const {
  if (std::isinf(value) && value > 0) return infinity_is_in;
  return std::isfinite(value) && value <= high && (low_open ? value > low : value >= low);
}

std::string Range::text() const {
  const bool below = std::isfinite(low), above = std::isfinite(high);
  if (below && above) return "a number from " + format_number(low) + " to " + format_number(high);
  if (below) return "a number " + std::string(low_open ? "> " : ">= ") + format_number(low);
  return "a number";
}

std::string Range::short_text() const {
  if (!std::isfinite(low)) return "";
  if (std::isfinite(high)) return format_number(low) + " ... " + format_number(high);
  return (low_open ? "> " : ">= ") + format_number(low);
}

void require_within(double value, const Range& range, const std::string& name) {
  if (range.contains(value)) return;
  const std::string given = name + " = " + format_number(value) + "; must be ";
  if (range.infinity_is_in)
    throw Error(given + "> " + format_number(range.low) + ". Leave it at infinity for no limit.");
  if (std::isfinite(range.low) && std::isfinite(range.high))
    throw Error(given + "between " + format_number(range.low) + " and " + format_number(range.high) + ".");
  if (std::isfinite(range.low))
    throw Error(given + "a finite number " + (range.low_open ? "> " : ">= ") + format_number(range.low) + ".");
  throw Error(given + "a finite number.");
}

std::string unit_in_names(std::string_view unit) {
  std::string name;
  if (unit == "1") return name;
  for (const char letter : unit) {
    if (letter == '/')
      name += "_per_";
    else if (letter != '^' && letter != ' ' && letter != '(' && letter != ')')
      name += letter;
  }
  return name;
}

}  // namespace hapticut
