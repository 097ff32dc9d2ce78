// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "hapticut/core/sentence.hpp"

/// @file
/// The one exception type of the library, thrown by set-up code only. The step never throws; it reports `StepStatus`
/// bits.
namespace hapticut {

/// A request that cannot be fulfilled. One sentence says what was given, what is allowed and what to do. It is one line
/// of valid UTF-8, even if a damaged file contributed a name. `what()` has the names of C++.
class Error : public std::runtime_error {
 public:
  explicit Error(Sentence sentence)
      : std::runtime_error(sentence.in_cpp()), sentence_(std::make_shared<const Sentence>(std::move(sentence))) {}

  /// For a front end, which writes it in its own words.
  [[nodiscard]] const Sentence& sentence() const { return *sentence_; }

 private:
  std::shared_ptr<const Sentence> sentence_;  // shared, because copies of exceptions must not throw
};

namespace detail {

/// The number with up to `digits` significant digits.
inline std::string with_digits(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// Whether a number with up to six significant digits needs at most four, like 0.3 and 2000.
inline bool looks_round(const std::string& text) {
  int digits = 0, zeros = 0;
  for (const char c : text) {
    if (c == 'e') break;
    if (c < '0' || c > '9' || (digits == 0 && c == '0')) continue;
    ++digits;
    zeros = c == '0' ? zeros + 1 : 0;
  }
  return digits - zeros <= 4;
}

/// The fewest digits, at least six, that read back as the same number.
inline std::string with_all_digits(double value) {
  int digits = 6;
  while (digits < 17 && std::strtod(with_digits(value, digits).c_str(), nullptr) != value) ++digits;
  return with_digits(value, digits);
}

}  // namespace detail

/// Formats a number for messages: up to six significant digits, e.g. `1e-05`, `0.3`, `nan`. A number that would look
/// round and is not gets the digits that show it, e.g. `2.00000004`.
[[nodiscard]] inline std::string format_number(double value) {
  constexpr double kNoise = 1e-14;  // [1] relative error of a few operations, e.g. from millimetres to metres and back
  std::string short_text = detail::with_digits(value, 6);
  if (!std::isfinite(value) || !detail::looks_round(short_text)) return short_text;
  const double read = std::strtod(short_text.c_str(), nullptr);
  const bool is_float = std::abs(value) < 1e38 && double(float(value)) == value;
  if (is_float ? float(read) == float(value) : std::abs(read - value) <= kNoise * std::abs(value)) return short_text;
  std::string text = short_text;
  for (int digits = 7; digits <= 17 && std::strtod(text.c_str(), nullptr) == read; ++digits)
    text = detail::with_digits(value, digits);
  return text;
}

/// Formats a number that is compared with another one: different numbers never look the same.
[[nodiscard]] inline std::string format_number(double value, double beside) {
  std::string text = format_number(value);
  return value != beside && text == format_number(beside) ? detail::with_all_digits(value) : text;
}

/// Throws unless `value` is finite and greater than zero.
/// @param what  the value with its unit: "SphereHead::radius [m]"
inline void require_positive(double value, const Subject& what) {
  if (!(std::isfinite(value) && value > 0))
    throw Error(what + " = " + format_number(value) + "; must be a finite number > 0.");
}

/// Throws when a size is so large that it must have been meant in millimetres.
/// @param limit  [m] largest plausible size
inline void require_metres(double value, double limit, const Subject& what) {
  if (value > limit)
    throw Error(what + " = " + format_number(value, limit) + "; must be <= " + format_number(limit, value) +
                ". Sizes are in metres: " + format_number(value) + " mm is " + format_number(1e-3 * value) + ".");
}

inline constexpr double kMaxVoxelSize = 0.02;  ///< [m] larger ones were meant in mm
inline constexpr double kMaxHeadReach = 0.3;   ///< [m] reach of a head; larger ones were meant in mm
inline constexpr double kMaxHandleReach = 5;   ///< [m] from hand to head; longer ones were meant in mm
inline constexpr double kMaxFeed = 0.5;        ///< [m/s] feed of a cutting head; larger ones were meant in mm/s

/// Throws unless a feed [m/s] is positive and at most kMaxFeed.
inline void require_feed(double value, const Subject& what) {
  require_positive(value, what);
  if (value > kMaxFeed)
    throw Error(what + " = " + format_number(value, kMaxFeed) + "; must be <= " + format_number(kMaxFeed) +
                ". Speeds are in m/s: " + format_number(value) + " mm/s is " + format_number(1e-3 * value) + ".");
}

/// Throws unless `value` is finite and not negative.
inline void require_not_negative(double value, const Subject& what) {
  if (!(std::isfinite(value) && value >= 0))
    throw Error(what + " = " + format_number(value) + "; must be a finite number >= 0.");
}

/// Throws unless `low <= value <= high`.
inline void require_between(double value, double low, double high, const Subject& what) {
  if (!(value >= low && value <= high))
    throw Error(what + " = " + format_number(value, value < low ? low : high) + "; must be between " +
                format_number(low, value) + " and " + format_number(high, value) + ".");
}

}  // namespace hapticut

/// Checks the library's own logic in debug and sanitizer builds; never a user's input.
#define HAPTICUT_ASSERT(condition) assert(condition)
