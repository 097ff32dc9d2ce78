// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "hapticut/core/on_one_line.hpp"

/// @file
/// The one exception type of the library, thrown by set-up code only. The step never throws; it reports `StepStatus`
/// bits.
namespace hapticut {

/// Something that was asked for cannot be done. `what()` is one sentence that says what was given, what is allowed and
/// what to do about it, on one line and in UTF-8, whatever a damaged file has in the place of a name.
class Error : public std::runtime_error {
 public:
  /// @param sentence  each byte that is not part of a printable character of UTF-8 becomes a question mark
  explicit Error(std::string sentence) : std::runtime_error(on_one_line(std::move(sentence))) {}
};

/// A number the way messages print it: shortest form with six significant digits, e.g. `1e-05`, `0.3`, `nan`.
[[nodiscard]] inline std::string format_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Throws unless `value` is finite and greater than zero.
/// @param name  what the user called it, with its unit, e.g. "SphereHead::radius [m]"
inline void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be a finite number > 0.");
}

/// Throws when a size is so large that it must have been meant in millimetres.
/// @param largest  [m] that makes sense
inline void require_metres(double value, double largest, const char* name) {
  if (value > largest)
    throw Error(std::string(name) + " = " + format_number(value) + "; must be <= " + format_number(largest) +
                ". Sizes are in metres: " + format_number(value) + " mm is " + format_number(1e-3 * value) + ".");
}

inline constexpr double kMaxHeadReach = 0.3;  ///< [m] reach of a head; larger ones were meant in mm
inline constexpr double kMaxFeed = 0.5;       ///< [m/s] of what cuts; faster ones were meant in mm/s

/// Throws unless a feed is positive and no faster than kMaxFeed.
inline void require_feed(double value, const char* name) {
  require_positive(value, name);
  if (value > kMaxFeed)
    throw Error(std::string(name) + " = " + format_number(value) + "; must be <= " + format_number(kMaxFeed) +
                ". Speeds are in m/s: " + format_number(value) + " mm/s is " + format_number(1e-3 * value) + ".");
}

/// Throws unless `value` is finite and not negative.
inline void require_not_negative(double value, const char* name) {
  if (!(std::isfinite(value) && value >= 0))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be a finite number >= 0.");
}

/// Throws unless `low <= value <= high`.
inline void require_between(double value, double low, double high, const char* name) {
  if (!(value >= low && value <= high))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be between " + format_number(low) + " and " +
                format_number(high) + ".");
}

}  // namespace hapticut

/// Checks our own reasoning in debug and sanitizer builds; never a user's input.
#define HAPTICUT_ASSERT(condition) assert(condition)
