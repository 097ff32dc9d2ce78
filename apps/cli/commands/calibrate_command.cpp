// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "cli/commands/command.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"
#include "reports/delivery.hpp"
#include "reports/json_file.hpp"
#include "reports/table.hpp"
#include "settings/csv_file.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

struct CalibrateSettings {
  std::string file, json;
  std::optional<ChipTerm> term;
  std::optional<CutterKind> cutter;
};

const std::vector<std::string> kColumns = {"radius_mm", "spindle_rpm", "feed_mm_per_s",
                                           "thrust_N",  "torque_Nmm",  "lips"};
constexpr std::size_t kNeeded = 5;  // `lips` is optional: default 2, as for a twist drill

std::string joined_columns() {
  return joined(std::span(kColumns).first(kNeeded)) + " and optionally " + kColumns[kNeeded];
}

/// The number in a column; 0 for an empty cell of a thrust or torque that was not measured.
/// @param column  of kColumns
/// @throws Error that names file, line, column and value
double number_at(CsvFile& file, const std::string& cell, std::size_t column) {
  if (cell.empty() && (column == 3 || column == 4)) return 0;
  const std::optional<double> value = file.number(cell);
  // The speed of a spindle may be negative.
  const bool may_be_negative = column == 1;
  if (!value || !std::isfinite(*value) || *value == 0 || (*value < 0 && !may_be_negative))
    file.fail(kColumns[column] + " = \"" + cell + "\"; must be a number " +
              (may_be_negative ? "other than 0." : "> 0."));
  return *value;
}

/// The place of each column of kColumns in the file; none for `lips` if it is not there.
/// @throws Error that names the column that is not known or missing
std::vector<std::optional<std::size_t>> columns_of(CsvFile& file) {
  (void)file.read_names("name the columns " + joined_columns());
  file.require_known(kColumns);
  std::vector<std::optional<std::size_t>> places;
  for (const std::string& name : kColumns) {
    places.push_back(file.column(name));
    if (!places.back() && places.size() <= kNeeded)
      file.fail("the column " + name + " is missing; the first line must name the columns " + joined_columns() + ".");
  }
  return places;
}

/// @throws Error that names file, line and column
std::vector<DrillingTest> read_tests(const std::string& path) {
  CsvFile file(path, "file of drilling tests", "hapticut calibrate");
  const std::vector<std::optional<std::size_t>> places = columns_of(file);
  std::vector<DrillingTest> tests;
  for (std::vector<std::string> cells; file.next(cells);) {
    const auto value = [&](std::size_t column) { return number_at(file, cells[*places[column]], column); };
    tests.push_back({value(0) * units::mm, value(1) * units::rpm, value(2) * units::mm_per_s, value(3),
                     value(4) * units::N_mm, places[kNeeded] ? value(kNeeded) : DrillingTest{}.lips});
    if (tests.back().thrust == 0 && tests.back().torque == 0)
      file.fail("thrust_N and torque_Nmm are both empty; enter at least one, or leave the line out.");
  }
  if (tests.empty()) file.fail("there is no drilling test; write one per line, below the names of the columns.");
  return tests;
}

/// "; presets of twist_drill: 0.3 ... 0.6"; empty: presets have no such number.
std::string beside_presets(const Calibration& c, std::string_view number) {
  const PresetConstant* const range = presets_beside(c, number);
  if (range == nullptr) return "";
  const std::string low = rounded(range->low, 3), high = rounded(range->high, 3);
  return "; presets of " + std::string(range->of) + ": " + (low == high ? low : low + " ... " + high);
}

/// The ranges beside the fitted numbers.
Json presets_json(const Calibration& c) {
  Json ranges = Json::object();
  for (const char* number : {"specific_cutting_energy", "cutting_ratio", "edge_length", "size_length"})
    if (const PresetConstant* const range = presets_beside(c, number))
      ranges[number] = {{"of", std::string(range->of)}, {"low", range->low}, {"high", range->high}};
  return ranges;
}

void run_calibrate(const CalibrateSettings& s) {
  if (s.file.empty()) throw UsageError("the file of drilling tests is missing. Use: hapticut calibrate TESTS.csv.");
  Delivery delivery({s.json});
  const std::vector<DrillingTest> tests = read_tests(s.file);
  const Calibration c = calibrate(tests, s.term, s.cutter);
  Table table("hapticut calibrate: " + s.file + ", " + std::to_string(tests.size()) +
              (tests.size() == 1 ? " test" : " tests"));
  table.add("specific_cutting_energy", rounded(c.specific_cutting_energy, 4) + " J/m^3" +
                                           (c.chip_identified ? "" : ": the tests do not identify it") +
                                           beside_presets(c, "specific_cutting_energy"));
  table.add("cutting_ratio", rounded(c.cutting_ratio, 4) + (c.ratio_identified ? "" : ": assumed, not measured") +
                                 beside_presets(c, "cutting_ratio"));
  const std::string not_known = c.edge_identified ? ""
                                : c.edge_assumed || c.size_assumed
                                    ? ": that of the presets, the tests do not identify it"
                                    : ": the tests do not identify it";
  const ChipTerm shown = c.size_assumed ? ChipTerm::size_length : c.term;
  for (const auto& [term, value, unit] :
       {std::tuple(ChipTerm::edge_length, c.edge_length, " m"), std::tuple(ChipTerm::size_length, c.size_length, " m"),
        std::tuple(ChipTerm::edge_pressure, c.edge_pressure, " Pa")})
    table.add(name_or_null(term),
              shown == term ? rounded(value, 4) + unit + not_known + beside_presets(c, name_or_null(term)) : "0");
  table.add("residuals", "thrust " + rounded(100 * c.thrust_residual, 3) + " %, torque " +
                             rounded(100 * c.torque_residual, 3) + " % (root mean square)" +
                             (c.checked ? "" : ", unchecked: as many constants as measured numbers"));
  Json rows = Json::array();
  for (const DrillingTest& t : tests) {
    const AxialCutForce model = axial_cut_force(c, t.radius, t.spindle_speed, t.feed_speed, t.lips);
    const auto measured = [](double value) { return value > 0 ? Json(value) : Json(nullptr); };
    rows.push_back({{"thrust_N", measured(t.thrust)},
                    {"model_thrust_N", model.thrust},
                    {"torque_Nmm", measured(t.torque / units::N_mm)},
                    {"model_torque_Nmm", model.torque / units::N_mm}});
  }
  write_json(delivery, s.json,
             {{"cutter", name_or_null(c.cutter)},
              {"term", name_or_null(c.term)},
              {"presets", presets_json(c)},
              {"specific_cutting_energy", c.specific_cutting_energy},
              {"cutting_ratio", c.cutting_ratio},
              {"edge_pressure", c.edge_pressure},
              {"edge_length", c.edge_length},
              {"size_length", c.size_length},
              {"ratio_identified", c.ratio_identified},
              {"edge_identified", c.edge_identified},
              {"edge_assumed", c.edge_assumed},
              {"size_assumed", c.size_assumed},
              {"better_term", c.better_term ? Json(name_or_null(*c.better_term)) : Json(nullptr)},
              {"worst_factor", c.worst_factor},
              {"checked", c.checked},
              {"chip_identified", c.chip_identified},
              {"thrust_residual", c.thrust_residual},
              {"torque_residual", c.torque_residual},
              {"tests", rows}});
  delivery.print(table.text() + advice_on(c));
  delivery.finish();
}

}  // namespace

Command calibrate_command() {
  auto settings = std::make_shared<CalibrateSettings>();
  return {
      "calibrate",
      "Fit cutting energy, cutting ratio and the effect of edges or thin chips to drilling tests",
      {path("calibrate.tests", "TESTS", settings->file, "CSV file of drilling tests"),
       choice("calibrate.term", "--term", settings->term,
              "third fitted constant: why the force does not vanish with the chip thickness [that of the presets of "
              "the cutter]"),
       choice("calibrate.cutter", "--cutter", settings->cutter,
              "cutter of the tests, whose presets are compared [by the thickness of the chips]"),
       json_setting(settings->json)},
      [settings] { run_calibrate(*settings); }};
}

}  // namespace hapticut::apps
