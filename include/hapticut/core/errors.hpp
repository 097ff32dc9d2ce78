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

/// A request that cannot be fulfilled. `what()` is one sentence that says what was given, what is allowed and what to
/// do. It is one line of valid UTF-8, even if a damaged file contributed a name.
class Error : public std::runtime_error {
 public:
  /// @param sentence  the message; each byte that is not part of a printable UTF-8 character becomes a question mark
  explicit Error(std::string sentence) : std::runtime_error(on_one_line(std::move(sentence))) {}
};

/// Formats a number for messages: shortest form with up to six significant digits, e.g. `1e-05`, `0.3`, `nan`.
[[nodiscard]] inline std::string format_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Throws unless `value` is finite and greater than zero.
/// @param name  name of the value as the user knows it, with its unit, e.g. "SphereHead::radius [m]"
inline void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    throw Error(std::string(name) + " = " + format_number(value) + "; must be a finite number > 0.");
}

/// Throws when a size is so large that it must have been meant in millimetres.
/// @param limit  [m] largest plausible size
inline void require_metres(double value, double limit, const char* name) {
  if (value > limit)
    throw Error(std::string(name) + " = " + format_number(value) + "; must be <= " + format_number(limit) +
                ". Sizes are in metres: " + format_number(value) + " mm is " + format_number(1e-3 * value) + ".");
}

inline constexpr double kMaxHeadReach = 0.3;  ///< [m] reach of a head; larger ones were meant in mm
inline constexpr double kMaxFeed = 0.5;       ///< [m/s] of a cutting head; larger ones were meant in mm/s

/// Throws unless a feed [m/s] is positive and at most kMaxFeed.
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

/// Checks the library's own logic in debug and sanitizer builds; never a user's input.
#define HAPTICUT_ASSERT(condition) assert(condition)
