// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "hapticut/core/description.hpp"
#include "settings/required.hpp"
#include "settings/setting.hpp"

/// @file
/// Settings for the fields of a described struct, of which a user gives some.
namespace hapticut::settings {

/// What a field is called in settings, if not as in C++.
struct Word {
  std::string_view field;  ///< name in C++
  std::string_view key;
  /// The default, e.g. "no weight"; empty: the number in the struct; ", or ...": a text after this number.
  std::string_view standard = {};
};

/// Names of the settings of a struct: the key "effects.vibration_max_N" has table, prefix, word and unit.
struct Keys {
  std::string_view table;
  std::string_view prefix = {};
  Word words[4] = {};
  std::string_view before = {};  ///< text before each sentence of the help

  [[nodiscard]] Word word_of(std::string_view field) const {
    for (const Word& word : words)
      if (word.field == field) return word;
    return {field, field};
  }

  /// The key without its table, which is also the flag: "vibration_max_N".
  template <class S, class T>
  [[nodiscard]] std::string name_of(const Field<S, T>& field) const {
    const std::string unit = shown_unit(field.unit).name;
    std::string name(prefix);
    for (const std::string_view part : {word_of(field.name).key, std::string_view(unit)})
      if (!part.empty()) name.append(name.empty() ? "" : "_").append(part);
    return name;
  }
  template <class S, class T>
  [[nodiscard]] std::string key_of(const Field<S, T>& field) const {
    return std::string(table) + "." + name_of(field);
  }
};

/// Whether a field of this type is a setting: a number, three numbers, or a number that may be left out.
template <class T>
inline constexpr bool kIsSetting = kIsNumber<T> || std::is_same_v<T, Vec3> || std::is_same_v<T, std::optional<double>>;

/// The fields of S that a user has given. Fields of other types than those of settings are left out.
template <Described S>
class Given {
  template <class T>
  using Kept = std::conditional_t<std::is_same_v<T, std::optional<double>>, T, std::optional<T>>;

 public:
  template <class T>
  [[nodiscard]] Kept<T>& operator[](T S::*member) {
    return find(*this, member);
  }
  template <class T>
  [[nodiscard]] const Kept<T>& operator[](T S::*member) const {
    return find(*this, member);
  }

  /// Adds a setting for each field. Range, text and default come from the description of S. A number whose default is
  /// out of its range has none.
  void add_settings(const Keys& keys, std::vector<Setting>& settings) {
    for_each(*this, [&](const auto& field, auto& given) {
      const ShownUnit unit = shown_unit(field.unit);
      const std::string name = keys.name_of(field);
      std::string standard(keys.word_of(field.name).standard);
      if (standard.empty() || standard.starts_with(',')) standard.insert(0, standard_of(field, unit.factor));
      std::string meaning = std::string(keys.before) + field.text + (standard.empty() ? "" : " [" + standard + "]");
      using Number = std::remove_cvref_t<decltype(*given)>;
      if constexpr (std::is_same_v<Number, int>)
        settings.push_back(integer(keys.key_of(field), "--" + name, given, field.range.low, field.range.high, meaning));
      else if constexpr (std::is_same_v<Number, Vec3>)
        settings.push_back(vector(keys.key_of(field), "--" + name, given, field.range, meaning, unit.factor));
      else
        settings.push_back(number(keys.key_of(field), "--" + name, given, field.range, meaning, unit.factor));
    });
  }

  /// S with the given values, and with its defaults elsewhere.
  /// @param owner  what needs the values: "a sphere"
  /// @throws Error when a value without a default is missing
  [[nodiscard]] S make(const Keys& keys, const Sentence& owner) const {
    S s;
    for_each(*this, [&](const auto& field, const auto& given) {
      if (given)
        s.*field.member = *given;
      else if (!has_default(field))
        fail_missing(Name(keys.key_of(field)), owner);
    });
    return s;
  }

  /// @throws Error when a value is given, see `settings::refuse`
  void refuse(const Keys& keys, const Sentence& owner, const Sentence& instead) const {
    for_each(*this, [&](const auto& field, const auto& given) {
      using Shown = std::conditional_t<kIsNumber<std::remove_cvref_t<decltype(*given)>>, double, Vec3>;
      const double factor = shown_unit(field.unit).factor;
      if (given) settings::refuse(std::optional(Shown(*given / factor)), Name(keys.key_of(field)), owner, instead);
    });
  }

 private:
  template <class>
  struct OptionalOf;
  template <class... T>
  struct OptionalOf<std::tuple<Field<S, T>...>> {
    using Values = std::tuple<Kept<T>...>;
  };

  /// Calls `visit(field, given)` for each field that is a setting.
  template <class Self, class Visit>
  static void for_each(Self& self, Visit&& visit) {
    const auto visit_one = [&]<class T>(const Field<S, T>& field, auto& given) {
      if constexpr (kIsSetting<T>) visit(field, given);
    };
    std::apply(
        [&](const auto&... fields) {
          std::apply([&](auto&... given) { (visit_one(fields, given), ...); }, self.values_);
        },
        fields_of(Of<S>{}));
  }

  template <class Self, class T>
  static auto& find(Self& self, T S::*member) {
    std::conditional_t<std::is_const_v<Self>, const Kept<T>, Kept<T>>* found = nullptr;
    for_each(self, [&](const auto& field, auto& given) {
      if constexpr (std::is_same_v<decltype(field.member), T S::*>)
        if (field.member == member) found = &given;
    });
    return *found;
  }

  template <class T>
  static bool has_default(const Field<S, T>& field) {
    if constexpr (kIsNumber<T>) return field.range.contains(S{}.*field.member);
    return true;
  }

  /// The default of a field as users write it; empty if it has none.
  template <class T>
  static std::string standard_of(const Field<S, T>& field, double factor) {
    if (!has_default(field)) return "";
    const auto text_of = [](double number) { return std::isinf(number) ? "no limit" : format_number(number); };
    const T standard = S{}.*field.member;
    if constexpr (std::is_same_v<T, std::optional<double>>)
      return standard ? text_of(*standard / factor) : "";
    else if constexpr (std::is_same_v<T, Vec3>)
      return joined(Vec3(standard / factor), ",", text_of);
    else
      return text_of(double(standard) / factor);
  }

  typename OptionalOf<decltype(fields_of(Of<S>{}))>::Values values_;
};

}  // namespace hapticut::settings
