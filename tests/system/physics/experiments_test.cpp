// SPDX-License-Identifier: Apache-2.0 The experiments of `hapticut validate`: each is a test, and its rows must be in
// docs/validation.md.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "experiments/checks.hpp"
#include "experiments/measurements.hpp"
#include "experiments/page.hpp"
#include "support/places.hpp"

namespace hapticut::experiments {
void PrintTo(const Experiment& experiment, std::ostream* out) { *out << experiment.name; }
}  // namespace hapticut::experiments

namespace hapticut::experiments_test {
namespace {

using experiments::all_experiments;
using experiments::Check;

std::string page(const char* name) {
  std::ifstream in(test::source_path(name));
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

using Cells = std::vector<std::string>;

/// The lines of a table, cell by cell, without markup.
std::vector<Cells> rows_of(const std::string& table) {
  std::vector<Cells> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| experiment ")) continue;
    std::erase(line, '*');
    std::istringstream row(line.substr(1));
    rows.emplace_back();
    for (std::string cell; std::getline(row, cell, '|');)
      if (!cell.empty()) rows.back().push_back(cell.substr(1, cell.size() - 2));
  }
  return rows;
}

/// The rows of an experiment without the computed values, whose last digits, and thus the worst case, depend on the
/// processor.
std::vector<Cells> what_is_asked(const std::string& table, const std::string& experiment) {
  std::vector<Cells> rows = rows_of(table);
  std::erase_if(rows, [&](const Cells& row) { return row.at(0) != experiment; });
  for (Cells& row : rows) row.resize(4);
  return rows;
}

class Experiment : public testing::TestWithParam<experiments::Experiment> {};

TEST_P(Experiment, IsWithinItsTolerances) {
  const std::vector<Check> checks = GetParam().run();
  for (const Check& check : checks)
    EXPECT_TRUE(check.pass()) << check.id << ": expected " << check.expected << ", computed " << check.computed << " "
                              << check.unit << ", off by " << check.relative_error() << ", tolerance "
                              << check.tolerance.share << ", " << check.tolerance.reason;
  const std::string table = experiments::rows_of(GetParam().name, checks);
  EXPECT_EQ(what_is_asked(page("docs/validation.md"), GetParam().name), what_is_asked(table, GetParam().name))
      << "run hapticut validate --markdown docs/validation.md";
}

INSTANTIATE_TEST_SUITE_P(All, Experiment, testing::ValuesIn(all_experiments()), [](const auto& e) {
  std::string name = e.param.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

TEST(ValidationPage, HasTheExperimentsInTheirOrderAndEachCaseOnce) {
  std::vector<std::string> named, known;
  for (const experiments::Experiment& experiment : all_experiments()) known.push_back(experiment.name);
  std::set<std::string> ids, forms;
  for (const Cells& row : rows_of(page("docs/validation.md"))) {
    if (named.empty() || named.back() != row.at(0)) named.push_back(row[0]);
    forms.insert(row.at(1));
    std::istringstream names(row.at(3));
    for (std::string name; std::getline(names >> std::ws, name, ';');)
      EXPECT_TRUE(ids.insert(std::string(row[1]).append(" ").append(name)).second)
          << row[1] << ", " << name << " appears twice";
  }
  EXPECT_EQ(named, known);
  std::vector<std::string> numbers = {"C42", "B1a", "B1b", "B1c", "B1d", "B1e", "B1f", "DC4"};
  for (int n = 1; n <= 38; ++n) numbers.push_back(std::string("C").append(std::to_string(n)));
  for (const int n : {1, 2, 5, 6, 7, 8, 11, 15}) numbers.push_back(std::string("D").append(std::to_string(n)));
  for (const std::string& number : numbers) EXPECT_EQ(forms.count(number), 1U) << number;
}

// The thesis's model and the default model on one case: the first shows the defect, the second does not.
TEST(ValidationPage, ShowsEachDefectInTheThesisAndThatItIsCuredInTheDefault) {
  std::map<std::string, std::string> cases;
  for (const Cells& row : rows_of(page("docs/validation.md"))) cases[row.at(1)] += row.at(3);
  for (const experiments::Experiment& experiment : experiments::defect_experiments()) {
    const std::string name = experiment.name.substr(std::string("defect ").size());
    for (const char* model : {"thesis", "cured"}) EXPECT_NE(cases[name].find(model), std::string::npos) << name;
  }
}

TEST(MeasurementsPage, IsWhatTheLibraryWrites) {
  EXPECT_EQ(page("docs/measurements.md"), experiments::measurements_page())
      << "run hapticut validate --measurements docs/measurements.md";
}

TEST(Check, OfANumberThatIsNoneDoesNotPass) {
  Check check{"x", "", "", 1, std::nan(""), {0.1, ""}};
  EXPECT_FALSE(check.pass());
  check.computed = 1.05;
  EXPECT_TRUE(check.pass());
  check.computed = 1.2;
  EXPECT_FALSE(check.pass());
  check.at_least = true;
  EXPECT_TRUE(check.pass());
}

}  // namespace
}  // namespace hapticut::experiments_test
