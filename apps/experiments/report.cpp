// SPDX-License-Identifier: Apache-2.0
#include "experiments/report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace hapticut::experiments {
namespace {

std::string percent(double share, int count) { return digits(100 * share, count) + " %"; }

/// The number at the start of an id: "C20" for "C20 thrust", "DC4" for "DC4 half"; empty for an id without a number.
std::string form_of(const std::string& id) {
  const std::string word = id.substr(0, id.find(' '));
  const std::size_t digit = word.find_first_of("0123456789");
  return digit == 1 || (digit == 2 && word.starts_with("DC")) ? word : "";
}

bool is_order(const Check& check) { return check.id.ends_with(" order"); }

/// The cases of one form in one experiment.
struct Cases {
  std::string form;
  std::vector<const Check*> all;

  /// The case that is nearest to its tolerance, or farthest beyond it.
  [[nodiscard]] const Check* worst(bool of_orders) const {
    const Check* found = nullptr;
    for (const Check* check : all)
      if (is_order(*check) == of_orders && (found == nullptr || !(check->of_tolerance() <= found->of_tolerance())))
        found = check;
    return found;
  }
  [[nodiscard]] std::string row(const std::string& experiment) const {
    const Check& worst_one = *worst(false);
    const Check* order = worst(true);
    std::string names;
    for (const Check* check : all) {
      if (is_order(*check)) continue;
      const std::string name =
          check->id.size() > form.size() + 1 && !form.empty() ? check->id.substr(form.size() + 1) : check->id;
      const char* mark = check == &worst_one && all.size() > 1 ? "**" : "";
      names += (names.empty() ? mark : std::string("; ") + mark) + name + mark;
    }
    const bool pass = std::all_of(all.begin(), all.end(), [](const Check* check) { return check->pass(); });
    return "| " + experiment + " | " + form + " | " + all.front()->what + " | " + names + " | " +
           percent(worst_one.relative_error(), 2) + (pass ? "" : " **FAIL**") + " | " +
           percent(worst_one.tolerance.share, 3) + " | " + worst_one.tolerance.reason + " | " +
           (order == nullptr ? "" : digits(order->computed) + " of " + digits(order->expected)) + " |\n";
  }
};

}  // namespace

std::string digits(double value, int count) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

std::string rows_of(const std::string& experiment, const std::vector<Check>& checks) {
  std::vector<Cases> forms;
  for (const Check& check : checks) {
    const std::string form = form_of(check.id);
    auto found = std::find_if(forms.begin(), forms.end(), [&](const Cases& cases) { return cases.form == form; });
    if (found == forms.end()) found = forms.insert(forms.end(), {form, {}});
    found->all.push_back(&check);
  }
  std::string rows;
  for (const Cases& cases : forms) rows += cases.row(experiment);
  return rows;
}

std::string validation_report(const std::string& rows) {
  return R"(# Validation

Each row is one closed form of an experiment. It names all cases, the worst one in bold, and gives the error, the
tolerance and the reason for the tolerance of this worst case. "Order" is the order in which the error falls with the
voxel size, and the expected order. An error "over its bound" is relative to a bound that the reason names; 100 % is
the bound. "grid" and "pushed" are the worst of seven directions of the grid and of three or more stiffnesses.

| experiment | form | first case | cases | error | tolerance | reason | order |
|---|---|---|---|---|---|---|---|
)" + rows;
}

}  // namespace hapticut::experiments
