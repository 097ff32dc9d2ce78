// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <stdexcept>
#include <string>

/// @file
/// The one exception type of the library, thrown by set-up code only. The step never throws; it reports `StepStatus`
/// bits.
namespace hapticut {

/// Something that was asked for cannot be done. `what()` is one sentence that says what was given, what is allowed and
/// what to do about it.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A number the way messages print it: shortest form with six significant digits, e.g. `1e-05`, `0.3`, `nan`.
[[nodiscard]] std::string format_number(double value);

/// Throws unless `value` is finite and greater than zero.
/// @param name  what the user called it, with its unit, e.g. "SphereHead::radius [m]"
void require_positive(double value, const char* name);

/// Throws unless `value` is finite and not negative.
void require_not_negative(double value, const char* name);

/// Throws unless `low <= value <= high`.
void require_between(double value, double low, double high, const char* name);

}  // namespace hapticut

/// Checks our own reasoning in debug and sanitizer builds; never a user's input.
#define HAPTICUT_ASSERT(condition) assert(condition)
