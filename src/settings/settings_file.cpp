// SPDX-License-Identifier: Apache-2.0
#include "settings/settings_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "io/file_errors.hpp"

namespace hapticut::settings {
namespace {

using Kind = Setting::Kind;

constexpr const char* kWritePaths = "write paths with / or in single quotes.";
constexpr const char* kWriteLists =
    "a list is written [1.5, 2, 3] or [\"a\", \"b\"], and a table {name = 3}; write it like this, and close it.";

bool has_control_characters(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; });
}

/// @param number  counted from 1
std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1 && !text.empty(); --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  text = text.substr(0, text.find('\n'));
  return text.substr(0, text.find_last_not_of("\r\t ") + 1);
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Why a value is not valid TOML, and the cure.
std::string cause_of_value(std::string_view value) {
  const auto starts_with = [&](std::string_view text) { return value.starts_with(text); };
  const std::string_view word = value.substr(0, value.find_first_of(" \t#,"));
  if (value.empty() || starts_with("#")) return "there is no value after the =; write it in the same line.";
  if (starts_with("\"") && value.find('\\') != std::string_view::npos)
    return std::string("a backslash in double quotes begins an escape such as \\n; ") + kWritePaths;
  if (starts_with("\"") || starts_with("'"))
    return "a text ends at the next quotation mark in the same line, and only a comment may follow; close the text, or "
           "use the other kind of quotation marks when the text contains one.";
  for (const char* quote : {"\u201c", "\u201d", "\u201e", "\u2018", "\u2019", "\u201a", "\u00ab", "\u00bb", "`"})
    if (starts_with(quote)) return "these quotation marks are not allowed; put texts in straight ones, \"like this\".";
  if (is_one_of(word, {"True", "TRUE", "False", "FALSE"})) return "true and false must be in lower case.";
  if (starts_with("[") || starts_with("{") || starts_with("(")) return kWriteLists;
  const std::size_t sign = starts_with("-") || starts_with("+") ? 1 : 0;
  if (value.find_first_of("0123456789.,") == sign)
    return "a number is written 0.2 or 2, with a decimal point between digits and nothing after it; a list is written "
           "[1, 2, 3].";
  return "it is not a number, true or false; put texts in quotation marks, \"like this\".";
}

/// Why a line is not valid TOML, and the cure.
/// @param said  the message of toml++
std::string cause_of(std::string_view line, std::string_view said) {
  if (said.find("utf-8") != std::string_view::npos || line.find('\0') != std::string_view::npos)
    return "the text is not in UTF-8; save it in UTF-8.";
  if (said.find("redefine") != std::string_view::npos)
    return "this line repeats a key or a table; leave one of them out.";
  const std::size_t first = line.find_first_not_of(" \t"), equals = line.find('=');
  if (first != std::string_view::npos && line[first] == '[' && said.find("table header") != std::string_view::npos)
    return "a table begins with its name in brackets, alone in a line; write [tool].";
  if (first != std::string_view::npos && line[first] == '#')
    return "there is a control character in a comment; delete it.";
  if (said.find("array") != std::string_view::npos || said.find("inline table") != std::string_view::npos)
    return kWriteLists;  // the list may begin in an earlier line
  if (equals == std::string_view::npos || equals == first || said.find("expected '='") != std::string_view::npos)
    return "this is neither [table] nor name = value; write one of them.";
  const std::string_view value = line.substr(equals + 1);
  return cause_of_value(value.substr(std::min(value.find_first_not_of(" \t"), value.size())));
}

/// Applies one TOML file to settings; its errors name file and line.
class Reader {
 public:
  Reader(std::string file, const std::filesystem::path& folder, ExplainKey explain)
      : file_(std::move(file)),
        folder_(folder.empty() ? folder : std::filesystem::absolute(folder)),
        explain_(std::move(explain)) {}

  /// @param prefix  prefix of the keys in messages, "" or "tool."
  void read_table(const toml::table& table, const std::string& prefix, const std::vector<Setting>& settings) const {
    read_entries(table, "", prefix, settings, explain_);
  }

 private:
  [[noreturn]] void fail(const toml::source_region& where, const Sentence& message) const {
    throw Error(file_ + ":" + std::to_string(where.begin.line) + ": " + message);
  }

  void read_entries(const toml::table& table, const std::string& inner, const std::string& prefix,
                    const std::vector<Setting>& settings, const ExplainKey& explain) const {
    for (const auto& [key_node, node] : table) {
      const std::string key = inner + std::string(key_node.str());
      const auto setting =
          std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == key; });
      if (setting != settings.end()) {
        read_setting(node, prefix + key, *setting);
      } else if (std::any_of(settings.begin(), settings.end(),
                             [&](const Setting& s) { return s.key.starts_with(key + "."); })) {
        if (!node.is_table()) fail(node.source(), prefix + key + ": must be a table, written [" + prefix + key + "].");
        read_entries(*node.as_table(), key + ".", prefix, settings, explain);
      } else {
        const std::string explained = explain ? explain(prefix + key) : "";
        if (!explained.empty()) fail(key_node.source(), explained);
        std::vector<std::string> known;
        known.reserve(settings.size());
        for (const Setting& s : settings) known.push_back(prefix + s.key);
        fail(key_node.source(), prefix + key + ": there is no such setting." + suggestion(prefix + key, known));
      }
    }
  }

  void read_setting(const toml::node& node, const std::string& name, const Setting& setting) const {
    if (setting.kind == Kind::tables) return read_tables(node, name, setting);
    if (setting.kind == Kind::named_tables) return read_named_tables(node, name, setting);
    std::optional<Value> value = value_of(node, setting.kind);
    if (!value) {
      const Value given = node.is_string() ? Value(node.as_string()->get()) : Value(describe_type(node));
      fail(node.source(), name + ": must be " + setting.allowed + ", not " +
                              (node.is_string() ? "the text " + describe(given) : std::get<std::string>(given)) + ".");
    }
    if (setting.in_folder && has_control_characters(std::get<std::string>(*value)))
      fail(node.source(), name + ": the file name contains a control character, which a backslash in double quotes " +
                              "makes; " + kWritePaths);
    if (setting.in_folder && !folder_.empty()) value = setting.in_folder(std::get<std::string>(*value), folder_);
    if (!setting.assign(*value))
      fail(node.source(), name + ": must be " + setting.allowed + ", not " + describe(*value) + ".");
  }

  void read_tables(const toml::node& node, const std::string& name, const Setting& setting) const {
    const toml::array* elements = node.as_array();
    if (elements == nullptr) fail(node.source(), name + ": must be a list of tables, each " + setting.allowed + ".");
    setting.clear();
    for (const toml::node& element : *elements) {
      if (!element.is_table())
        fail(element.source(), name + ": must be a list of tables, each " + setting.allowed + ".");
      read_table(*element.as_table(), name + ".", setting.open_table(""));
    }
  }

  void read_named_tables(const toml::node& node, const std::string& name, const Setting& setting) const {
    if (!node.is_table()) fail(node.source(), name + ": must contain tables, written [" + name + ".NAME].");
    for (const auto& [key_node, element] : *node.as_table()) {
      const std::string key(key_node.str());
      if (!element.is_table())
        fail(key_node.source(), name + "." + key + ": must be a table, written [" + name + "." + key + "].");
      std::vector<Setting> inner;
      try {
        inner = setting.open_table(key);
      } catch (const Error& error) {
        fail(key_node.source(), name + "." + key + ": " + error.sentence());
      }
      read_entries(*element.as_table(), "", name + "." + key + ".", inner, setting.explain);
    }
  }

  static std::string describe_type(const toml::node& node) {
    if (node.is_number()) return "a number";
    if (node.is_boolean()) return node.as_boolean()->get() ? "true" : "false";
    if (node.is_array()) return "a list";
    return node.is_table() ? "a table" : "a date or time";
  }

  static std::optional<double> number_of(const toml::node& node) {
    if (node.is_integer()) return double(node.as_integer()->get());
    if (node.is_floating_point()) return node.as_floating_point()->get();
    return std::nullopt;
  }

  static std::optional<Value> value_of(const toml::node& node, Kind kind) {
    if (kind == Kind::text && node.is_string()) return node.as_string()->get();
    if (kind == Kind::boolean && node.is_boolean()) return node.as_boolean()->get();
    if (kind == Kind::integer && node.is_integer()) return double(node.as_integer()->get());
    if (kind == Kind::number) {
      const std::optional<double> value = number_of(node);
      if (value) return *value;
    }
    if (kind == Kind::numbers && node.is_array()) {
      std::vector<double> values;
      for (const toml::node& element : *node.as_array()) {
        const std::optional<double> value = number_of(element);
        if (!value) return std::nullopt;
        values.push_back(*value);
      }
      return values;
    }
    return std::nullopt;
  }

  std::string file_;
  std::filesystem::path folder_;
  ExplainKey explain_;
};

std::string text_of_file(const std::filesystem::path& path, const std::string& advice) {
  std::error_code error;
  std::ifstream file;
  // Check the type before opening: opening a pipe blocks, and a device has no end.
  if (std::filesystem::is_regular_file(path, error)) file.open(path, std::ios::binary);
  if (std::filesystem::is_directory(path, error))
    throw Error(path.string() + ": it is a folder; name the settings file in it.");
  if (is_missing(path)) throw Error(path.string() + ": there is no such settings file." + advice);
  if (const std::string reason = unreachable(path); !reason.empty()) throw Error(path.string() + ": " + reason);
  if (!file.is_open()) throw Error(path.string() + ": it cannot be read; check its kind and its permissions.");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::set<std::string> read_settings(std::string_view text, const std::string& name,
                                    const std::vector<Setting>& settings, const std::set<std::string>& ignored,
                                    const std::filesystem::path& folder, const ExplainKey& explain) {
  toml::table table;
  try {
    table = toml::parse(text, name);
  } catch (const toml::parse_error& problem) {
    const std::size_t line = problem.source().begin.line;
    throw Error(name + ":" + std::to_string(line) +
                ": not valid TOML: " + cause_of(line_of(text, line), problem.description()));
  }
  for (const std::string& key : ignored) table.erase(key);
  Reader(name, folder, explain).read_table(table, "", settings);
  std::set<std::string> keys;
  for (const auto& [key, node] : table) keys.emplace(key.str());
  return keys;
}

std::set<std::string> read_settings_file(const std::filesystem::path& path, const std::vector<Setting>& settings,
                                         const std::set<std::string>& ignored, const std::string& advice,
                                         const ExplainKey& explain) {
  return read_settings(text_of_file(path, advice), path.string(), settings, ignored,
                       std::filesystem::absolute(path).parent_path(), explain);
}

}  // namespace hapticut::settings
