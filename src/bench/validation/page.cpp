// SPDX-License-Identifier: Apache-2.0
#include "bench/validation/page.hpp"

#include <array>
#include <cstdio>

namespace hapticut::validation {

std::string digits(double value, int count) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

std::string row_of(const std::string& experiment, const Check& c) {
  const auto percent = [](double share) { return digits(100 * share, 2) + " %"; };
  return "| " + experiment + " | " + c.id + " | " + c.what + " | " + c.with_unit(digits(c.expected, 4)) + " | " +
         c.with_unit(digits(c.computed, 4)) + " | " + percent(c.relative_error()) + (c.pass() ? "" : " **FAIL**") +
         " | " + percent(c.tolerance.share) + " | " + c.tolerance.reason + " |\n";
}

std::string validation_page(const std::string& rows) {
  return R"(<!-- SPDX-License-Identifier: Apache-2.0 -->
# Validation

What each closed form gives, what the library gives, how far it may be off, and why. Written by
`hapticut validate --markdown docs/validation.md`; `--only` takes the name of an experiment. Each is a test of the library too. The
formulas are in [model.md](model.md). C20 ... C34 are for a constant energy, which no preset of blades or drills has: with theirs
hold C35 ... C38 and C42. "grid" and "pushed" are the worst of 7 directions of the grid and 3 or more stiffnesses; an error "over its
bound" is the worst of all cases, places in the grid and voxel sizes, and 100 % of the bound, which the reason names.

| experiment | id | case | expected | computed | error | tolerance | reason |
|---|---|---|---|---|---|---|---|
)" + rows;
}

}  // namespace hapticut::validation
