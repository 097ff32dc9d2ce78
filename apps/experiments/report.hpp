// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/checks.hpp"

/// @file
/// The table that `hapticut validate --markdown` writes. It has no times, so it changes only when a result changes.
namespace hapticut::experiments {

/// A number with a few digits.
[[nodiscard]] std::string digits(double value, int count = 3);

/// The rows of an experiment, one for each closed form: experiment, form, first case in words, names of the cases;
/// error, tolerance and reason of the worst case; order of convergence.
[[nodiscard]] std::string rows_of(const std::string& experiment, const std::vector<Check>& checks);

/// @param rows  from `rows_of`
/// @return the table in Markdown, with a heading that explains its columns
[[nodiscard]] std::string validation_report(const std::string& rows);

}  // namespace hapticut::experiments
