// SPDX-License-Identifier: Apache-2.0
// Every case of `hapticut validate`, and the pages of the documentation that name them and the tests.
#include "bench/validation/checks.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "bench/validation/measurements.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/places.hpp"

namespace hapticut::validation {
void PrintTo(const Experiment& experiment, std::ostream* out) { *out << experiment.name; }
}  // namespace hapticut::validation

namespace hapticut::validation_test {
namespace {

using validation::Check;
using validation::Experiment;

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Everything but the defects, which have a test of their own.
std::vector<Experiment> closed_forms() {
  std::vector<Experiment> experiments = validation::all_experiments();
  std::erase_if(experiments, [](const Experiment& e) { return e.name.starts_with("defect"); });
  return experiments;
}

std::string name_for_gtest(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

void expect_pass(const Check& check) {
  EXPECT_TRUE(check.pass()) << check.id << ": expected " << check.expected << ", computed " << check.computed << " "
                            << check.unit << ", off by " << check.relative_error() << ", tolerance " << check.tolerance;
}

class Validation : public testing::TestWithParam<Experiment> {};

TEST_P(Validation, IsWithinItsTolerances) {
  for (const Check& check : GetParam().run()) expect_pass(check);
}

INSTANTIATE_TEST_SUITE_P(Experiments, Validation, testing::ValuesIn(closed_forms()),
                         [](const auto& e) { return name_for_gtest(e.param.name); });

// The thesis's model and the default one on the same case: the first shows the defect, in the second it is gone.
class Defect : public testing::TestWithParam<Experiment> {};

// Proves: defects of the thesis's model.
TEST_P(Defect, IsShownByTheThesisAndCuredInTheDefault) {
  const std::string name = GetParam().name.substr(std::string("defect ").size());
  bool shown = false, cured = false;
  for (const Check& check : GetParam().run()) {
    std::cout << check.id << ", " << check.what << ": " << check.with_unit(std::to_string(check.computed))
              << " (expected " << check.expected << ")\n";
    expect_pass(check);
    shown |= check.id.starts_with(name + " thesis");
    cured |= check.id.starts_with(name + " cured");
  }
  EXPECT_TRUE(shown && cured);
}

INSTANTIATE_TEST_SUITE_P(OfTheThesis, Defect, testing::ValuesIn(validation::defect_experiments()),
                         [](const auto& e) { return name_for_gtest(e.param.name); });

TEST(MeasurementsPage, IsWhatTheLibraryWrites) {
  EXPECT_EQ(contents(test::source_path("docs/measurements.md")), validation::measurements_page())
      << "run hapticut validate --measurements docs/measurements.md";
}

// DC4: in the library, the bur of the source removes under its load what it removed there, half of it under half the
// load, and the load that a removal needs is the load that gives it.
TEST(DiamondBur, DC4NeedsItsLoadForItsRemoval) {
  using validation::DiamondBur;
  const Material diamond = presets::enamel(CutterKind::fine_diamond);
  EXPECT_NEAR(diamond.specific_cutting_energy / DiamondBur::energy(), 1, 5e-3) << "three digits of the preset";
  constexpr double kThickLayer = 0.05;  // [1] of an engaged layer of a twenty-fourth of the radius
  const auto plate = [&] { return DiamondBur::Plate(diamond, 0.025 * units::mm); };
  EXPECT_NEAR(plate().removal_under(DiamondBur::kLoad) / DiamondBur::kRemoval, 1, kThickLayer);
  EXPECT_NEAR(plate().removal_under(DiamondBur::kLoad / 2) / DiamondBur::kRemoval, 0.5, 0.5 * kThickLayer);
  const double load = plate().load_at(DiamondBur::kRemoval);
  EXPECT_NEAR(load / DiamondBur::kLoad, 1, kThickLayer);
  EXPECT_GT(load, 0.43) << "within what dentists press with (DC3)";
  EXPECT_LT(load, 1.79);
}

// A load that the edges carry cuts nothing.
TEST(DiamondBur, BelowItsEdgePressureACarbideBurrRemovesNothing) {
  using validation::DiamondBur;
  Material carbide = presets::enamel(CutterKind::fine_diamond);
  carbide.specific_cutting_energy = 1.75e9;
  carbide.edge_pressure = 200e3;
  const double edges = carbide.edge_pressure * DiamondBur::Plate::kArea;
  EXPECT_LT(DiamondBur::Plate(carbide, 0.015 * units::mm).removal_under(0.8 * edges), 0.01 * DiamondBur::kRemoval);
}

TEST(Check, OfANumberThatIsNoneDoesNotPass) {
  Check check{"x", "", "", 1, std::nan(""), 0.1};
  EXPECT_FALSE(check.pass());
  check.computed = 1.05;
  EXPECT_TRUE(check.pass());
  check.computed = 1.2;
  EXPECT_FALSE(check.pass());
}

/// `Suite.Name` of every test that a file of the tests declares.
std::set<std::string> declared_tests() {
  std::set<std::string> names;
  const std::regex declaration(R"((?:TEST|TEST_P|TEST_F|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+))");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_path("tests"))) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = contents(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match)
      names.insert((*match)[1].str() + "." + (*match)[2].str());
  }
  return names;
}

TEST(ForcesPage, NamesOnlyTestsThatExistAndMany) {
  const std::set<std::string> declared = declared_tests();
  const std::string page =
      contents(test::source_path("docs/forces.md")) + contents(test::source_path("docs/measurements.md"));
  ASSERT_FALSE(page.empty());
  const std::regex name(R"(`(\w+\.[A-Z]\w{5,})`)");
  int named = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), name), end; match != end; ++match, ++named)
    EXPECT_TRUE(declared.count((*match)[1].str()) == 1)
        << "docs/forces.md or measurements.md names a test that is not there: " << (*match)[1];
  EXPECT_GE(named, 40);
}

// The tables of section 9 are written by tests/meta/proofs.py; that each row has a test, and that no term and no closed
// form is missing, must not depend on who ran it last.
TEST(ForcesPage, NamesATestInEveryRowOfItsTablesOfProofs) {
  const std::string page = contents(test::source_path("docs/forces.md"));
  std::istringstream proofs(page.substr(page.find("<!-- proofs -->")));
  const std::regex name(R"(`\w+\.[A-Z]\w{5,}`)"), heading(R"(\| (term|number) \|.*)");
  int rows = 0;
  for (std::string line; std::getline(proofs, line);) {
    if (!line.starts_with("| ") || std::regex_match(line, heading)) continue;
    EXPECT_TRUE(std::regex_search(line, name)) << "names no test: " << line;
    ++rows;
  }
  EXPECT_GE(rows, 42 + 34);
}

// The program's test holds the page against a run of all cases.
TEST(ValidationPage, HasEveryClosedFormAndTheMeasurementsAndEachCaseOnce) {
  std::istringstream page(contents(test::source_path("docs/validation.md")));
  std::set<std::string> ids, first_words;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| ") || line.starts_with("| id ")) continue;
    const std::string id = line.substr(2, line.find(" | ") - 2);
    EXPECT_TRUE(ids.insert(id).second) << id << " appears twice";
    first_words.insert(id.substr(0, id.find(' ')));
    EXPECT_EQ(line.find("FAIL"), std::string::npos) << line;
  }
  EXPECT_GE(ids.size(), 40U);
  for (int n = 1; n <= 34; ++n) EXPECT_EQ(first_words.count(std::string("C").append(std::to_string(n))), 1U) << n;
  for (const char* row : {"B1a", "B1b", "B1c", "B1d", "B1e", "B1f", "DC4"})
    EXPECT_EQ(first_words.count(row), 1U) << row;
  for (const char* row : {"D1", "D2", "D5", "D6", "D7", "D8", "D11", "D15"})
    EXPECT_EQ(first_words.count(row), 1U) << row;
}

}  // namespace
}  // namespace hapticut::validation_test
