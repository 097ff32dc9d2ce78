// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

#include "cli/command.hpp"
#include "cli/json_file.hpp"
#include "cli/table.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"

namespace hapticut::cli {
namespace {

struct CalibrateSettings {
  std::string file, json;
};

constexpr const char* kColumns = "radius_mm,spindle_rpm,feed_mm_per_s,thrust_N,torque_Nmm";
constexpr std::size_t kCount = 5;

/// @throws Error naming the file and the line
std::vector<DrillingTest> read_tests(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw Error(path + " cannot be read. Give a CSV file with the columns " + kColumns + ".");
  std::string line;
  std::getline(in, line);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (line != kColumns) throw Error(path + ":1: the first line is '" + line + "'; it must be " + kColumns + ".");
  std::vector<DrillingTest> tests;
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::array<double, kCount> values{};
    std::istringstream cells(line);
    std::string cell;
    std::size_t n = 0;
    for (; std::getline(cells, cell, ','); ++n) {
      std::istringstream text(cell);
      double value = 0;
      std::string rest;
      if (n >= kCount || !(text >> value) || (text >> rest))
        throw Error(path + ":" + std::to_string(number) + ": '" + cell +
                    "' is not one of five numbers. The columns are " + kColumns + ".");
      values[n] = value;
    }
    if (n != kCount)
      throw Error(path + ":" + std::to_string(number) + ": " + std::to_string(n) +
                  " numbers; there must be five. The columns are " + kColumns + ".");
    tests.push_back({values[0] * units::mm, values[1] * units::rpm, values[2] * units::mm_per_s, values[3],
                     values[4] * units::N_mm});
  }
  return tests;
}

void run(const CalibrateSettings& s) {
  const std::vector<DrillingTest> tests = read_tests(s.file);
  const Calibration c = calibrate(tests);
  Table table("hapticut calibrate: " + s.file + ", " + std::to_string(tests.size()) +
              (tests.size() == 1 ? " test" : " tests"));
  table.add("specific_cutting_energy", rounded(c.specific_cutting_energy, 4) + " J/m^3");
  table.add("cutting_ratio", rounded(c.cutting_ratio, 4));
  table.add("edge_pressure", rounded(c.edge_pressure, 4) + " Pa" +
                                 (c.edge_identified ? "" : ", taken as 0: the tests do not identify it"));
  table.add("residuals", "thrust " + rounded(100 * c.thrust_residual, 3) + " %, torque " +
                             rounded(100 * c.torque_residual, 3) + " % (root mean square)");
  Json rows = Json::array();
  for (const DrillingTest& t : tests) {
    const AxialCutForce model = axial_cut_force(c, t.radius, t.spindle_speed, t.feed_speed);
    rows.push_back({{"thrust_N", t.thrust},
                    {"model_thrust_N", model.thrust},
                    {"torque_Nmm", t.torque / units::N_mm},
                    {"model_torque_Nmm", model.torque / units::N_mm}});
  }
  std::fputs(table.text().c_str(), stdout);
  if (!c.edge_identified)
    std::fputs("To tell edge from chip, add tests at another feed per turn: u, kappa and p_e are one equation short.\n",
               stdout);
  write_json(s.json, {{"specific_cutting_energy", c.specific_cutting_energy},
                      {"cutting_ratio", c.cutting_ratio},
                      {"edge_pressure", c.edge_pressure},
                      {"edge_identified", c.edge_identified},
                      {"thrust_residual", c.thrust_residual},
                      {"torque_residual", c.torque_residual},
                      {"tests", rows}});
}

}  // namespace

Command calibrate_command() {
  auto settings = std::make_shared<CalibrateSettings>();
  return {"calibrate",
          "Fit cutting energy, cutting ratio and edge pressure to drilling tests",
          {text("calibrate.tests", "TESTS", settings->file, "CSV file of drilling tests"),
           text("output.json", "--json", settings->json, "report for machines")},
          [settings] { run(*settings); }};
}

}  // namespace hapticut::cli
