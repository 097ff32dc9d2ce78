// SPDX-License-Identifier: Apache-2.0
// docs/command-line.md lists exactly the settings of the program, with the program's texts.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "support/places.hpp"

namespace hapticut::cli_docs_test {
namespace {

void add_rows(const settings::Setting& setting, const std::string& prefix, std::vector<std::string>& rows) {
  const std::string key = prefix + setting.key;
  const std::string flag = setting.flag.empty() ? "" : "`" + setting.flag + "`";
  if (setting.kind != settings::Setting::Kind::named_tables)
    rows.push_back("| `" + key + "` | " + flag + " | " + setting.meaning + " | " + setting.allowed + " |");
  if (!setting.open_table) return;
  const bool named = setting.kind == settings::Setting::Kind::named_tables;
  for (const settings::Setting& inner : setting.open_table("name"))
    add_rows(inner, key + (named ? ".NAME." : "[]."), rows);
}

TEST(CommandLinePage, ListsEverySettingAsTheProgramDescribesIt) {
  std::vector<std::string> expected;
  for (const cli::Command& command : cli::all_commands())
    for (const settings::Setting& setting : command.settings) add_rows(setting, "", expected);
  ASSERT_GT(expected.size(), 80U);

  std::ifstream page(test::source_path("docs/command-line.md"));
  std::set<std::string> found;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("| `")) found.insert(line);
  for (const std::string& row : expected)
    EXPECT_TRUE(found.contains(row)) << "missing in docs/command-line.md:\n" << row;
  for (const std::string& row : expected) found.erase(row);
  for (const std::string& row : found) ADD_FAILURE() << "not so in the program:\n" << row;
}

TEST(CommandLinePage, BeginsWithEveryCommand) {
  std::ifstream page(test::source_path("docs/command-line.md"));
  std::set<std::string> found, expected;
  for (std::string line; std::getline(page, line) && line.rfind("## ", 0) != 0;)
    if (line.rfind("hapticut ", 0) == 0) found.insert(line.substr(9, line.find(' ', 9) - 9));
  for (const cli::Command& command : cli::all_commands()) expected.insert(command.name);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace hapticut::cli_docs_test
