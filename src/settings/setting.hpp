// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"

/// @file
/// What a user can set: one list of settings serves the flags, the settings file, their help and their error messages.
namespace hapticut::settings {

/// The command line itself is wrong: exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A value before it is checked.
using Value = std::variant<bool, double, std::string, std::vector<double>>;

/// One thing that can be set, by a flag or by a key of a settings file.
struct Setting {
  enum class Kind { number, integer, numbers, text, boolean, tables, named_tables };

  std::string key;      ///< in a settings file, with its table: "tool.radius_mm"
  std::string flag;     ///< on the command line: "--radius_mm"; empty: settings file only
  std::string meaning;  ///< what it is, for the help
  std::string allowed;  ///< completes "must be ..."
  Kind kind = Kind::text;

  /// Takes a value of this setting's kind; says whether it is allowed.
  std::function<bool(const Value&)> assign = {};

  /// Of kind tables: makes an element and returns its settings, with keys relative to it. Of kind named_tables: the
  /// same for the table of that name.
  std::function<std::vector<Setting>(const std::string& name)> open_table = {};
  /// Of kind tables: forgets all elements, before a list that replaces them.
  std::function<void()> clear = {};
  /// Of kind tables: takes the flag's short form of one element; says whether it is allowed.
  std::function<bool(const std::string& text)> assign_short_form = {};
  /// Of a text that names a file: the same from a settings file in `folder`, where names are relative to it.
  std::function<std::string(const std::string& text, const std::filesystem::path& folder)> in_folder = {};
  const std::string* file = nullptr;  ///< the same: where its name is kept
};

/// Lists of settings as one.
[[nodiscard]] std::vector<Setting> together(std::vector<std::vector<Setting>> lists);

/// Words in a sentence: "block, slab, molar".
/// @param word_of  what stands for an element of the list
template <class List, class WordOf = std::identity>
[[nodiscard]] std::string joined(const List& list, const std::string& separator = ", ", const WordOf& word_of = {}) {
  std::string text;
  for (const auto& element : list) text += (text.empty() ? "" : separator) + std::string(std::invoke(word_of, element));
  return text;
}

namespace detail {

inline double& stored(double& target) { return target; }
inline double& stored(std::optional<double>& target) { return target.emplace(); }

}  // namespace detail

/// A number.
/// @tparam Target  double or std::optional<double>
/// @param factor   what is stored, and must be within the range, over what is given
template <class Target>
[[nodiscard]] Setting number(std::string key, std::string flag, Target& target, Range range, std::string meaning,
                             double factor = 1) {
  return {std::move(key),
          std::move(flag),
          std::move(meaning),
          range.text(),
          Setting::Kind::number,
          [&target, range, factor](const Value& value) {
            const double given = std::get<double>(value) * factor;
            if (!std::isfinite(given) || !range.contains(given)) return false;
            detail::stored(target) = given;
            return true;
          }};
}

/// What users write in place of a unit of SI: mm for m, and the end of the key that says so.
struct ShownUnit {
  std::string name;
  double factor;  ///< SI over shown
};
[[nodiscard]] ShownUnit shown_unit(std::string_view unit);

/// All fields of a struct of numbers: key, flag, unit, range, meaning and default as the struct describes them.
/// @param table   of the settings file: "effects"
/// @param except  a member with a key of its own
template <Described S>
void add_fields(const std::string& table, S& target, double S::*except, std::vector<Setting>& settings) {
  for_each_field<S>([&](const auto& field) {
    if (field.member == except) return;
    const ShownUnit shown = shown_unit(field.unit);
    const std::string name = field.name + (shown.name.empty() ? "" : "_" + shown.name);
    const double standard = S{}.*field.member / shown.factor;
    settings.push_back(
        number(table + "." + name, "--" + name, target.*field.member, field.range,
               std::string(field.text) + " [" + (std::isinf(standard) ? "no limit" : format_number(standard)) + "]",
               shown.factor));
  });
}

/// A whole number within `low` ... `high`.
[[nodiscard]] Setting integer(std::string key, std::string flag, std::size_t& target, double low, double high,
                              std::string meaning);

/// Exactly `count` numbers.
[[nodiscard]] Setting numbers(std::string key, std::string flag, std::vector<double>& target, std::size_t count,
                              Range range, std::string meaning);

/// Three numbers.
[[nodiscard]] Setting vector(std::string key, std::string flag, std::optional<Vec3>& target, Range range,
                             std::string meaning);

/// Any text that is not empty.
[[nodiscard]] Setting text(std::string key, std::string flag, std::string& target, std::string meaning);

/// The name of a file; in a settings file it is relative to the folder of that.
/// @param words  that stand for something else than a file: "molar"
[[nodiscard]] Setting path(std::string key, std::string flag, std::string& target, std::string meaning,
                           std::vector<std::string> words = {});

/// One of a few words, each with what it stands for.
template <class Meaning>
[[nodiscard]] Setting choice(std::string key, std::string flag, std::optional<Meaning>& target,
                             std::vector<std::pair<std::string, Meaning>> words, std::string meaning) {
  return {std::move(key),
          std::move(flag),
          std::move(meaning),
          "one of " + joined(words, ", ", &std::pair<std::string, Meaning>::first),
          Setting::Kind::text,
          [&target, words = std::move(words)](const Value& value) {
            for (const auto& [word, stands_for] : words)
              if (word == std::get<std::string>(value)) {
                target = stands_for;
                return true;
              }
            return false;
          }};
}

/// One of the names of an enumeration.
template <NamedEnum E>
[[nodiscard]] Setting choice(std::string key, std::string flag, std::optional<E>& target, std::string meaning) {
  std::vector<std::pair<std::string, E>> words;
  for (const Named<E>& one : names_of(Of<E>{})) words.emplace_back(one.name, one.value);
  return choice(std::move(key), std::move(flag), target, std::move(words), std::move(meaning));
}

/// Yes or no.
[[nodiscard]] Setting boolean(std::string key, std::string flag, bool& target, std::string meaning);

/// Applies the texts that followed a flag on the command line; a repeated flag of kind tables adds elements.
/// @throws UsageError naming the flag, what was given and what is allowed
void apply_flag(const Setting& setting, const std::vector<std::string>& texts);

/// What messages print of a value: `-1`, `"fast"`, `true`.
[[nodiscard]] std::string describe(const Value& value);

/// The name among `candidates` that is nearest to a misspelled one, or nothing when none is near.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view misspelled,
                                                      const std::vector<std::string>& candidates);

/// " Did you mean X?" or nothing.
[[nodiscard]] std::string suggestion(std::string_view misspelled, const std::vector<std::string>& candidates);

/// The whole of a text as a number, or nothing.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The parts of a text between separators; "a,b" -> {"a", "b"}.
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

}  // namespace hapticut::settings
