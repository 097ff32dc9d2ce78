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
#include "hapticut/core/units.hpp"

/// @file
/// Settings of the user. One list of settings serves the flags, the settings file, the help and the error messages.
namespace hapticut::settings {

/// The command line is wrong: exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A value before it is checked.
using Value = std::variant<bool, double, std::string, std::vector<double>>;

/// One setting, given by a flag or by a key of a settings file.
struct Setting {
  enum class Kind { number, integer, numbers, text, boolean, tables, named_tables };

  std::string key;      ///< name in a settings file, with its table: "tool.radius_mm"
  std::string flag;     ///< on the command line: "--radius_mm"; empty: settings file only
  std::string meaning;  ///< text of the help
  std::string allowed;  ///< completes "must be ..."
  Kind kind = Kind::text;

  /// Stores a value of this setting's kind.
  /// @return false when the value is not allowed
  std::function<bool(const Value&)> assign = {};

  /// For kind `tables`: appends an element and returns its settings, with relative keys. For kind `named_tables`: opens
  /// the table of that name and returns its settings.
  std::function<std::vector<Setting>(const std::string& name)> open_table = {};
  /// For kind `named_tables`: why there is no such key, as a message; empty: no reason is known.
  std::function<std::string(const std::string& key)> explain = {};
  /// For kind `tables`: removes all elements, before a list replaces them.
  std::function<void()> clear = {};
  /// For kind `tables`: appends one element from the short form of the flag.
  /// @return false when the text is not allowed
  std::function<bool(const std::string& text)> assign_short_form = {};
  /// For a text that names a file: the name relative to `folder`, the folder of the settings file.
  std::function<std::string(const std::string& text, const std::filesystem::path& folder)> in_folder = {};
  /// Removes what belongs to another value, e.g. the dimensions of another head. Called when a flag replaces the value
  /// of a settings file, before the flags are applied.
  std::function<void()> begin_anew = {};
  /// For a text that names a file: all files that it stands for; none while the text is empty.
  std::function<std::vector<std::filesystem::path>()> files = {};
};

/// Joins lists of settings.
[[nodiscard]] std::vector<Setting> together(std::vector<std::vector<Setting>> lists);

/// Words in a sentence: "block, slab, molar".
/// @param word_of  the text of an element
template <class List, class WordOf = std::identity>
[[nodiscard]] std::string joined(const List& list, const std::string& separator = ", ", const WordOf& word_of = {}) {
  std::string text;
  for (const auto& element : list) text += (text.empty() ? "" : separator) + std::string(std::invoke(word_of, element));
  return text;
}

namespace detail {

inline void store(double& target, double number) { target = number; }
inline void store(std::optional<double>& target, double number) { target = number; }
inline void store(std::optional<AngularSpeed>& target, double number) { target = number * units::rad_per_s; }

}  // namespace detail

/// A number.
/// @tparam Target  double, or optional: double, AngularSpeed
/// @param factor   stored value divided by given value; the range limits the stored value
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
            detail::store(target, given);
            return true;
          }};
}

/// The unit that users write instead of an SI unit, e.g. mm instead of m. Its name is the end of the key.
struct ShownUnit {
  std::string name;
  double factor;  ///< value in SI units divided by shown value
};
[[nodiscard]] ShownUnit shown_unit(std::string_view unit);

/// A whole number within `low` ... `high`.
[[nodiscard]] Setting integer(std::string key, std::string flag, std::size_t& target, double low, double high,
                              std::string meaning);
[[nodiscard]] Setting integer(std::string key, std::string flag, std::optional<double>& target, double low, double high,
                              std::string meaning);
[[nodiscard]] Setting integer(std::string key, std::string flag, std::optional<int>& target, double low, double high,
                              std::string meaning);

/// Exactly `count` numbers.
[[nodiscard]] Setting numbers(std::string key, std::string flag, std::vector<double>& target, std::size_t count,
                              Range range, std::string meaning);

/// Three numbers.
/// @param factor  stored value divided by given value; the range limits the stored values
[[nodiscard]] Setting vector(std::string key, std::string flag, std::optional<Vec3>& target, Range range,
                             std::string meaning, double factor = 1);

/// Any text that is not empty.
[[nodiscard]] Setting text(std::string key, std::string flag, std::string& target, std::string meaning);

/// The name of a file. In a settings file it is relative to the folder of the settings file.
/// @param words  words that are not file names: "molar"
[[nodiscard]] Setting path(std::string key, std::string flag, std::string& target, std::string meaning,
                           std::vector<std::string> words = {});

/// One of a few words, each with its value.
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

/// True or false.
[[nodiscard]] Setting boolean(std::string key, std::string flag, bool& target, std::string meaning);
[[nodiscard]] Setting boolean(std::string key, std::string flag, std::optional<bool>& target, std::string meaning);

/// Applies the texts after a flag of the command line. A repeated flag of kind `tables` adds elements.
/// @throws UsageError that names the flag, the given text and what is allowed
void apply_flag(const Setting& setting, const std::vector<std::string>& texts);

/// A value in a message: `-1`, `"fast"`, `true`.
[[nodiscard]] std::string describe(const Value& value);

/// The candidate most similar to a misspelled name; nullopt when no candidate is similar.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view misspelled,
                                                      const std::vector<std::string>& candidates);

/// " Did you mean X?", or an empty text.
[[nodiscard]] std::string suggestion(std::string_view misspelled, const std::vector<std::string>& candidates);

/// The whole text as a number; nullopt when it is not a number.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The parts of a text between separators: "a,b" -> {"a", "b"}.
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

}  // namespace hapticut::settings
