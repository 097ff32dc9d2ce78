// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bench/validation/checks.hpp"

/// @file
/// The page docs/validation.md. No times and no machine in it: it changes only when a result does.
namespace hapticut::validation {

/// A number with a few digits.
[[nodiscard]] std::string digits(double value, int count = 3);

/// A line of the table: experiment, id, case, expected, computed, error, tolerance, reason.
[[nodiscard]] std::string row_of(const std::string& experiment, const Check& check);

/// @param rows  of `row_of`
[[nodiscard]] std::string validation_page(const std::string& rows);

}  // namespace hapticut::validation
