// SPDX-License-Identifier: Apache-2.0
// Every case of `hapticut validate`, and the pages of the documentation that name them and the tests.
#include "validation/checks.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>
#include <sstream>

#include "validation/measurements.hpp"

namespace hapticut {

namespace validation {
void PrintTo(const Experiment& experiment, std::ostream* out) { *out << experiment.name; }
}  // namespace validation

namespace {

using validation::Check;
using validation::Experiment;

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class Validation : public testing::TestWithParam<Experiment> {};

TEST_P(Validation, IsWithinItsTolerances) {
  for (const Check& check : GetParam().run())
    EXPECT_TRUE(check.pass()) << check.id << ": expected " << check.expected << ", computed " << check.computed << " "
                              << check.unit << ", off by " << check.relative_error() << ", tolerance "
                              << check.tolerance;
}

INSTANTIATE_TEST_SUITE_P(Experiments, Validation, testing::ValuesIn(validation::all_experiments()), [](const auto& e) {
  std::string name = e.param.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

// The thesis's model and the default one on the same case: the first shows the defect, in the second it is gone.
class Defect : public testing::TestWithParam<const char*> {};

TEST_P(Defect, IsShownByTheThesisAndCuredInTheDefault) {
  const std::string name = GetParam();
  bool shown = false, cured = false;
  for (const Experiment& experiment : validation::defect_experiments()) {
    if (experiment.name != std::string("defect ").append(name)) continue;
    for (const Check& check : experiment.run()) {
      std::cout << check.id << ", " << check.what << ": " << check.computed << " " << check.unit << " (expected "
                << check.expected << ")\n";
      EXPECT_TRUE(check.pass()) << check.id;
      shown |= check.id.starts_with(name + " thesis");
      cured |= check.id.starts_with(name + " cured");
    }
  }
  EXPECT_TRUE(shown && cured);
}

INSTANTIATE_TEST_SUITE_P(OfTheThesis, Defect, testing::Values("D1", "D2", "D5", "D6", "D7", "D8", "D11", "D15"),
                         [](const auto& name) { return std::string(name.param); });

TEST(AllExperiments, CoverEveryClosedFormAndTheDrillingsOfBone) {
  std::set<std::string> first_words;
  for (const Experiment& experiment : validation::all_experiments())
    for (const Check& check : experiment.run()) first_words.insert(check.id.substr(0, check.id.find(' ')));
  for (int n = 1; n <= 34; ++n) EXPECT_EQ(first_words.count(std::string("C").append(std::to_string(n))), 1U) << n;
  for (const char* row : {"B1a", "B1b", "B1c", "B1d", "B1e", "B1f"}) EXPECT_EQ(first_words.count(row), 1U) << row;
}

TEST(MeasurementsPage, IsWhatTheLibraryWrites) {
  EXPECT_EQ(contents(std::filesystem::path(HAPTICUT_DOCS) / "measurements.md"), validation::measurements_page())
      << "run hapticut validate --measurements docs/measurements.md";
}

// DC4: the bur of the source under its load removes what it removed there, and needs half the load for half of it.
TEST(DiamondBur, DC4NeedsItsLoadForItsRemoval) {
  using validation::DiamondBur;
  EXPECT_NEAR(DiamondBur::energy(), 113e9, 2e9);
  EXPECT_NEAR(DiamondBur::load(DiamondBur::kRemoval, DiamondBur::energy()), 0.64, 0.01);
  EXPECT_GT(DiamondBur::load(DiamondBur::kRemoval, DiamondBur::energy()), 0.43)
      << "within what dentists press with (DC3)";
  EXPECT_LT(DiamondBur::load(DiamondBur::kRemoval, DiamondBur::energy()), 1.79);
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
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HAPTICUT_TESTS_FOLDER)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = contents(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match)
      names.insert((*match)[1].str() + "." + (*match)[2].str());
  }
  return names;
}

TEST(ForcesPage, NamesOnlyTestsThatExistAndMany) {
  const std::set<std::string> declared = declared_tests();
  const std::string page = contents(std::filesystem::path(HAPTICUT_DOCS) / "forces.md") +
                           contents(std::filesystem::path(HAPTICUT_DOCS) / "measurements.md");
  ASSERT_FALSE(page.empty());
  const std::regex name(R"(`(\w+\.[A-Z]\w{5,})`)");
  int named = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), name), end; match != end; ++match, ++named)
    EXPECT_TRUE(declared.count((*match)[1].str()) == 1)
        << "docs/forces.md or measurements.md names a test that is not there: " << (*match)[1];
  EXPECT_GE(named, 40);
}

// Every formula has its proof in its row; the table of defects has one test for all of its rows.
TEST(ForcesPage, NamesATestInEveryRowOfItsTables) {
  std::istringstream page(contents(std::filesystem::path(HAPTICUT_DOCS) / "forces.md"));
  const std::regex name(R"(`\w+\.[A-Z]\w{5,}`)"), heading(R"(\| (term|law|\|).*)"), defect(R"(\| D\d+ \|.*)");
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| ") || std::regex_match(line, heading) || std::regex_match(line, defect)) continue;
    EXPECT_TRUE(std::regex_search(line, name)) << "names no test: " << line;
    ++rows;
  }
  EXPECT_GE(rows, 35);
}

TEST(ValidationPage, ListsEveryCaseOnceAndOnlyThose) {
  const std::string page = contents(std::filesystem::path(HAPTICUT_DOCS) / "validation.md");
  std::set<std::string> ids;
  for (const Experiment& experiment : validation::all_experiments())
    for (const Check& check : experiment.run()) {
      EXPECT_TRUE(ids.insert(check.id).second) << check.id << " appears twice";
      EXPECT_NE(page.find("\n| " + check.id + " | "), std::string::npos)
          << check.id << " is missing: run hapticut validate --markdown docs/validation.md";
    }
  const std::regex row(R"(\n\| [^|]+ \| [^|]+ \| [^|]+ \|)");
  const auto rows = std::distance(std::sregex_iterator(page.begin(), page.end(), row), std::sregex_iterator());
  EXPECT_EQ(std::size_t(rows), ids.size() + 1) << "and the heading";
  EXPECT_GE(ids.size(), 40U);
}

}  // namespace
}  // namespace hapticut
