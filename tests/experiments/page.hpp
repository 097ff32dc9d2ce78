// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/checks.hpp"

/// @file
/// The page docs/validation.md. No times and no machine in it: it changes only when a result does.
namespace hapticut::experiments {

/// A number with a few digits.
[[nodiscard]] std::string digits(double value, int count = 3);

/// The lines of an experiment in the table, one for each form: experiment, form, first case in words, names of the
/// cases, error, tolerance and reason of the worst of them, order of convergence.
[[nodiscard]] std::string rows_of(const std::string& experiment, const std::vector<Check>& checks);

/// @param rows  of `rows_of`
[[nodiscard]] std::string validation_page(const std::string& rows);

}  // namespace hapticut::experiments
