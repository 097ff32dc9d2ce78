// SPDX-License-Identifier: Apache-2.0
// Every case of `hapticut validate`, and the pages of the documentation that name them and the tests.
#include "validation/checks.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace hapticut {
namespace {

using validation::Check;
using validation::Experiment;

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

TEST(Check, OfANumberThatIsNoneDoesNotPass) {
  Check check{"x", "", "", 1, std::nan(""), 0.1};
  EXPECT_FALSE(check.pass());
  check.computed = 1.05;
  EXPECT_TRUE(check.pass());
  check.computed = 1.2;
  EXPECT_FALSE(check.pass());
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
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
  const std::string page = contents(std::filesystem::path(HAPTICUT_DOCS) / "forces.md");
  ASSERT_FALSE(page.empty());
  const std::regex name(R"(`(\w+\.[A-Z]\w{5,})`)");
  int named = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), name), end; match != end; ++match, ++named)
    EXPECT_TRUE(declared.count((*match)[1].str()) == 1)
        << "docs/forces.md names a test that is not there: " << (*match)[1];
  EXPECT_GE(named, 40);
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
