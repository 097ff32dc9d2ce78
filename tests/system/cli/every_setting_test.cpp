// SPDX-License-Identifier: Apache-2.0
// Every setting of every command refuses a value of another type, by flag and by key, and says what is allowed.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "settings/settings_file.hpp"
#include "support/refusal.hpp"

namespace hapticut::every_setting_test {
namespace {

using settings::Setting;
using Kind = Setting::Kind;

const std::map<Kind, std::vector<std::string>>& wrong_texts() {
  static const std::map<Kind, std::vector<std::string>> texts = {
      {Kind::number, {"wide", "2mm", "1,2", "nan", "inf", ""}},
      {Kind::integer, {"wide", "1.5", "-1", "nan"}},
      {Kind::numbers, {"1", "1,2", "1,2,x", "1,2,3,4,5,6,7", "nan,1,1"}},
      {Kind::text, {""}},
      {Kind::boolean, {"maybe"}},
      {Kind::tables, {"enamel", "=1", "enamel="}}};
  return texts;
}

TEST(EverySetting, RefusesATextOfAnotherTypeByItsFlag) {
  std::size_t flags = 0;
  for (const apps::Command& command : apps::all_commands())
    for (const Setting& setting : command.settings) {
      if (setting.flag.empty()) continue;
      ++flags;
      for (const std::string& text : wrong_texts().at(setting.kind))
        EXPECT_EQ(test::refusal([&] { apply_flag(setting, {text}); }),
                  setting.flag + " " + (text.empty() ? "''" : text) + ": must be " + setting.allowed + ".")
            << command.name;
    }
  EXPECT_GT(flags, 200U);
}

/// A value that no setting of a kind accepts, in TOML and in messages.
const std::map<Kind, std::vector<std::pair<const char*, const char*>>>& wrong_values() {
  static const std::map<Kind, std::vector<std::pair<const char*, const char*>>> values = {
      {Kind::number,
       {{"true", "true"}, {"\"2 mm\"", "the text \"2 mm\""}, {"[1]", "a list"}, {"nan", "nan"}, {"inf", "inf"}}},
      {Kind::integer, {{"2.5", "a number"}, {"-1", "-1"}}},
      {Kind::numbers, {{"3", "a number"}, {"[1, 2, \"x\"]", "a list"}, {"[nan]", "[nan]"}}},
      {Kind::text, {{"3", "a number"}, {"\"\"", "\"\""}}},
      {Kind::boolean, {{"1", "a number"}, {"\"true\"", "the text \"true\""}}}};
  return values;
}

void expect_refused_in_file(const std::vector<Setting>& all, const std::string& begin, const std::string& end,
                            const std::string& prefix, const Setting& setting) {
  const std::string name = prefix + setting.key;
  const auto error_for = [&](const std::string& value) {
    return test::refusal([&] { read_settings("\n" + begin + setting.key + " = " + value + end, "s.toml", all); });
  };
  if (setting.kind == Kind::tables) {
    EXPECT_EQ(error_for("3"), "s.toml:2: " + name + ": must be a list of tables, each " + setting.allowed + ".");
    for (const Setting& inner : setting.open_table(""))
      expect_refused_in_file(all, begin + setting.key + " = [{", "}]", name + ".", inner);
  } else if (setting.kind == Kind::named_tables) {
    EXPECT_EQ(error_for("3"), "s.toml:2: " + name + ": must contain tables, written [" + name + ".NAME].");
    for (const Setting& inner : setting.open_table("dentin"))
      expect_refused_in_file(all, begin + setting.key + ".dentin.", end, name + ".dentin.", inner);
  } else {
    for (const auto& [value, called] : wrong_values().at(setting.kind))
      EXPECT_EQ(error_for(value), "s.toml:2: " + name + ": must be " + setting.allowed + ", not " + called + ".");
  }
}

TEST(EverySetting, RefusesAValueOfAnotherTypeInAFileWithLineAndKey) {
  for (const apps::Command& command : apps::all_commands())
    for (const Setting& setting : command.settings) expect_refused_in_file(command.settings, "", "", "", setting);
}

}  // namespace
}  // namespace hapticut::every_setting_test
