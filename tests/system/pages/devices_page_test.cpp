// SPDX-License-Identifier: Apache-2.0
// docs/devices_tests.md names tests; here they are looked for.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "support/places.hpp"

namespace hapticut::devices_page_test {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file.is_open()) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

void collect(const std::string& text, const std::regex& declaration, std::set<std::string>& names) {
  for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match)
    names.insert((*match)[1].str() + "." + (*match)[2].str());
}

/// Tests of our programs, and those that CMake runs.
std::set<std::string> declared_tests() {
  std::set<std::string> names;
  const std::regex test(R"((?:TEST|TEST_P|TEST_F|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+))");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_path("tests")))
    if (entry.path().extension() == ".cpp") collect(contents(entry.path()), test, names);
  for (const char* stand_in : {"openhaptics_stand_in", "force_dimension_stand_in"})
    collect(contents(test::source_path("tests") / "support" / stand_in / "CMakeLists.txt"),
            std::regex(R"(vendor_\w+_test\((\w+)\.(\w+))"), names);
  return names;
}

TEST(DevicesTestsPage, NamesOnlyTestsThatExist) {
  const std::set<std::string> declared = declared_tests();
  const std::string page = contents(test::source_path("docs/devices_tests.md"));
  const std::regex name(R"(`(\w+\.\w+)`)");
  int named = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), name), end; match != end; ++match, ++named)
    EXPECT_EQ(declared.count((*match)[1].str()), 1U) << "docs/devices_tests.md names " << (*match)[1];
  EXPECT_GE(named, 110);
}

TEST(DevicesTestsPage, HasEveryItemOfTheChecklistAndEveryTestOfTheAdapter) {
  const std::string page = contents(test::source_path("docs/devices_tests.md"));
  for (int item = 1; item <= 15; ++item)
    EXPECT_NE(page.find("\n| " + std::to_string(item) + ". "), std::string::npos) << item;
  int left_out = 0;
  for (const std::string& test : declared_tests())
    for (const char* suite : {"OpenHapticsFaults.", "ForceDimension.", "ForceDimensionFaults.", "DhdStandIn."})
      if (test.starts_with(suite) && page.find("`" + test + "`") == std::string::npos) ++left_out;
  EXPECT_EQ(left_out, 0) << "a test of the adapter that no item of the checklist asks for: name it on the page";
}

}  // namespace
}  // namespace hapticut::devices_page_test
