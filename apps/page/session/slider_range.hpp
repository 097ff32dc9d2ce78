// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "hapticut/core/description.hpp"

/// @file
/// The range of a slider: the comfortable part of what the described field allows.
namespace hapticut::apps {

/// @param comfortable  numbers that a user tries, in the shown unit
/// @param factor       value of the field divided by the shown value
template <class S>
[[nodiscard]] constexpr Range slider_range(double S::*member, const Range& comfortable, double factor = 1) {
  const Range allowed = range_of(member);
  return Range::between(std::max(comfortable.low, allowed.low / factor),
                        std::min(comfortable.high, allowed.high / factor));
}

/// A number of an effect in a panel. Its unit and its allowed range are those of its description.
template <class Effect>
struct EffectNumber {
  std::uint16_t id;
  const char* label;
  double Effect::*member;
  Range comfortable;

  [[nodiscard]] constexpr Range range() const { return slider_range(member, comfortable); }
  [[nodiscard]] constexpr std::string_view unit() const {
    std::string_view found;
    for_each_number<Effect>([&](const auto& field) {
      if (field.member == member) found = field.unit;
    });
    return found;
  }
};

}  // namespace hapticut::apps
