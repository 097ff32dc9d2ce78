// SPDX-License-Identifier: Apache-2.0
// docs/command-line.md lists every setting of the program with its flag, default and range, and no other. The sentence
// about each setting is in `--help` only.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "cli/commands/command.hpp"
#include "support/places.hpp"

namespace hapticut::cli_docs_test {
namespace {

/// A setting, as described by a row of the page.
struct Row {
  std::string key, flag, standard, allowed;

  [[nodiscard]] auto members() const { return std::tie(key, flag, standard, allowed); }
  [[nodiscard]] bool operator<(const Row& other) const { return members() < other.members(); }
};

std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << "key '" << row.key << "', flag '" << row.flag << "', default '" << row.standard << "', allowed '"
             << row.allowed << "'";
}

/// A default of several words may be worded differently on the page.
std::string comparable(const std::string& standard) {
  return standard.find(' ') == std::string::npos ? standard : "(words)";
}

/// The default of a setting, from the brackets at the end of its sentence; empty: the setting has no default.
std::string default_in(const std::string& meaning) {
  const std::size_t open = meaning.rfind(" [");
  if (open == std::string::npos || !meaning.ends_with("]")) return "";
  return meaning.substr(open + 2, meaning.size() - open - 3);
}

/// The allowed values as the tables of the page write them: "a number from 0 to 90" -> "0 ... 90", "a number > 0 and <=
/// 20" -> "> 0, <= 20".
std::string shortened(const std::string& allowed) {
  if (allowed == "a text that is not empty") return "text";
  if (allowed == "true or false") return "true, false";
  if (allowed == "a number") return "number";
  std::string text = allowed.substr(0, allowed.find(", where"));
  text = std::regex_replace(text, std::regex(R"(^a number from (\S+) to (\S+)$)"), "$1 ... $2");
  text = std::regex_replace(text, std::regex(R"(^a number (> \S+) and (<= \S+)$)"), "$1, $2");
  text = std::regex_replace(text, std::regex(R"(^(?:a|a list of) whole numbers? from (\S+) to (\S+)$)"),
                            "whole, $1 ... $2");
  return std::regex_replace(text, std::regex("^(a number|one of) "), "");
}

void add_rows(const settings::Setting& setting, const std::string& prefix, std::set<Row>& rows) {
  const std::string key = prefix + setting.key;
  const bool named = setting.kind == settings::Setting::Kind::named_tables;
  if (!named) rows.insert({key, setting.flag, comparable(default_in(setting.meaning)), shortened(setting.allowed)});
  if (!setting.open_table) return;
  for (const settings::Setting& inner : setting.open_table("name"))
    add_rows(inner, key + (named ? ".NAME." : "[]."), rows);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 1, end = 0; (end = line.find('|', begin)) != std::string::npos; begin = end + 1)
    cells.push_back(trimmed(line.substr(begin, end - begin)));
  return cells;
}

/// The flag of a key whose row does not name a flag.
std::string usual_flag(const std::string& key) {
  if (key.starts_with("material.") || key.find("[]") != std::string::npos) return "";
  return "--" + key.substr(key.rfind('.') + 1);
}

/// A row lists keys that have default and range in common: "| `scale`, `device` (`DEVICE`) | what | default | allowed
/// |". A heading with `[table]` names the table of the keys. A key of another table is given in full.
std::set<Row> rows_of_page(const std::set<std::string>& known) {
  const std::regex heading(R"(^## .*`\[([\w.]+)\]`)"), name(R"(`([\w.\[\]]+)`(?: \(`([-\w]+)`\))?)");
  std::ifstream page(test::source_path("docs/command-line.md"));
  std::set<Row> rows;
  std::string table;
  for (std::string line; std::getline(page, line);) {
    if (std::smatch found; line.starts_with("## "))
      table = std::regex_search(line, found, heading) ? found.str(1) + "." : "";
    if (!line.starts_with("| `")) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 4) {
      ADD_FAILURE() << "not a row of four cells:\n" << line;
      continue;
    }
    for (std::sregex_iterator at(cells[0].begin(), cells[0].end(), name), end; at != end; ++at) {
      const std::string in_table = table + at->str(1), key = known.contains(in_table) ? in_table : at->str(1);
      rows.insert({key, (*at)[2].matched ? at->str(2) : usual_flag(key), comparable(cells[2]), cells[3]});
    }
  }
  return rows;
}

TEST(CommandLinePage, ListsEverySettingWithItsFlagDefaultAndRange) {
  std::set<Row> expected;
  for (const apps::Command& command : apps::all_commands())
    for (const settings::Setting& setting : command.settings) add_rows(setting, "", expected);
  ASSERT_GT(expected.size(), 80U);
  std::set<std::string> known;
  for (const Row& row : expected) known.insert(row.key);

  const std::set<Row> found = rows_of_page(known);
  for (const Row& row : expected) EXPECT_TRUE(found.contains(row)) << "missing in docs/command-line.md: " << row;
  for (const Row& row : found) EXPECT_TRUE(expected.contains(row)) << "not so in the program: " << row;
}

TEST(CommandLinePage, BeginsWithEveryCommand) {
  std::ifstream page(test::source_path("docs/command-line.md"));
  std::set<std::string> found, expected;
  for (std::string line; std::getline(page, line) && line.rfind("## ", 0) != 0;)
    if (line.rfind("hapticut ", 0) == 0) found.insert(line.substr(9, line.find(' ', 9) - 9));
  for (const apps::Command& command : apps::all_commands()) expected.insert(command.name);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace hapticut::cli_docs_test
