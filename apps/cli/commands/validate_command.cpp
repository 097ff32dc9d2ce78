// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "cli/commands/command.hpp"
#include "experiments/checks.hpp"
#include "experiments/published.hpp"
#include "experiments/report.hpp"
#include "hapticut/core/build_info.hpp"
#include "hapticut/core/errors.hpp"
#include "io/text_lines.hpp"
#include "reports/delivery.hpp"
#include "reports/json_file.hpp"
#include "reports/progress.hpp"
#include "reports/table.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

using experiments::Check;

struct ValidateSettings {
  std::string only, json, markdown, measurements;
  double tolerance_factor = 1;
};

std::string percent(double fraction) { return rounded(100 * fraction, 2) + " %"; }

/// "expected 3.77 N, computed 3.78 N, off by 0.2 % of 1 %"; where 0 is expected, "computed 0.92, at most 1: 0.92 of its
/// bound".
std::string comparison(const Check& c) {
  const std::string computed = "computed " + c.with_unit(rounded(c.computed, 5));
  if (c.expected == 0 && c.scale != 0)
    return computed + ", at most " + c.with_unit(rounded(c.tolerance.share * std::abs(c.scale), 5)) + ": " +
           rounded(c.of_tolerance(), 2) + " of its bound";
  return "expected " + c.with_unit(rounded(c.expected, 5)) + ", " + computed + ", off by " +
         percent(c.relative_error()) + " of " + percent(c.tolerance.share);
}

/// Two lines, so each fits a terminal.
std::string lines_of(const Check& c) {
  const auto padded = [](std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
  };
  return padded(c.pass() ? "ok" : "FAIL", 4) + ' ' + padded(c.id, 24) + ' ' + c.what + "\n     " + comparison(c) +
         ", " + c.tolerance.reason + '\n';
}

void run_validate(const ValidateSettings& s) {
  Delivery delivery({s.json, s.markdown, s.measurements});
  std::vector<experiments::Experiment> experiments;
  std::vector<std::string> names;
  for (experiments::Experiment& experiment : experiments::all_experiments()) {
    names.push_back(experiment.name);
    if (lower_case(experiment.name).find(lower_case(s.only)) != std::string::npos)
      experiments.push_back(std::move(experiment));
  }
  if (experiments.empty())
    throw Error("no experiment has '" + s.only + "' in its name. Leave --only out to run all experiments, or choose " +
                "from: " + joined(names, "; ") + ".");

  std::string rows;
  std::size_t count = 0;
  Json cases = Json::array();
  ProgressBar progress("validating", experiments.size());
  int failed = 0;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t n = 0; n < experiments.size(); ++n) {
    std::vector<Check> results = experiments[n].run();
    progress.advance_to(n + 1);
    const auto paused = progress.pause();
    for (Check& c : results) {
      c.tolerance.share *= s.tolerance_factor;
      delivery.print(lines_of(c));
      cases.push_back({{"experiment", experiments[n].name},
                       {"id", c.id},
                       {"case", c.what},
                       {"unit", c.unit},
                       {"expected", c.expected},
                       {"computed", c.computed},
                       {"relative_error", c.relative_error()},
                       {"tolerance", c.tolerance.share},
                       {"reason", c.tolerance.reason},
                       {"pass", c.pass()}});
      failed += c.pass() ? 0 : 1;
      ++count;
    }
    rows += experiments::rows_of(experiments[n].name, results);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_json(delivery, s.json,
             {{"cases", cases},
              {"failed", failed},
              {"seconds", seconds},
              {"build", {{"version", build_info().version}, {"commit", build_info().commit}}}});
  delivery.print(std::to_string(count) + " cases, " + std::to_string(failed) + " failed, " + rounded(seconds, 3) +
                 " s\n");
  delivery.write(s.markdown, [&] { write_text(s.markdown, experiments::validation_report(rows)); });
  delivery.write(s.measurements, [&] { write_text(s.measurements, experiments::measurements_report()); });
  delivery.attempt([&] {
    if (failed > 0)
      throw Error(std::to_string(failed) + " of " + std::to_string(count) +
                  " cases exceed their tolerance: this build computes wrong results.");
  });
  delivery.finish();
}

}  // namespace

Command validate_command() {
  auto settings = std::make_shared<ValidateSettings>();
  return {
      "validate",
      "Compare the library with closed-form solutions and report the errors",
      {text("validate.only", "--only", settings->only, "run only the experiments whose name contains this text"),
       json_setting(settings->json),
       number("validate.tolerance_factor", "--tolerance_factor", settings->tolerance_factor, Range::between(0, 1),
              "multiplies all tolerances; smaller values show the margin of each case [1]"),
       path("output.markdown", "--markdown", settings->markdown,
            "writes a table with the worst case of each form as Markdown; -: to standard output", {kStandardOutput}),
       path("output.measurements", "--measurements", settings->measurements,
            "writes the comparison with published measurements as Markdown; -: to standard output", {kStandardOutput})},
      [settings] { run_validate(*settings); }};
}

}  // namespace hapticut::apps
