// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "io/recording/hdf5.hpp"
#include "io/text_lines.hpp"

/// @file
/// Settings as data sets of a group: name, unit and value. Writer and reader have the same call operator, so one list
/// of calls serves both. For a described struct (core/description.hpp) the fields are that list.
///
/// A group lists its names in the attribute `fields`. So a reader can distinguish a missing data set from a field that
/// is newer than the file and keeps its default. The reader refuses unknown fields.
namespace hapticut {

inline constexpr char kFieldsAttribute[] = "fields";

/// The names that a group of a file should contain.
[[nodiscard]] inline std::vector<std::string> fields_listed(RecordingSource& source, const std::string& group) {
  return items_of(source.text_attribute(group, kFieldsAttribute));
}

[[nodiscard]] inline bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Writes settings into a group.
class SettingsWriter {
 public:
  explicit SettingsWriter(hid_t group) : group_(group) {}

  void operator()(const char* name, const char* unit, const double& value) { write(name, unit, &value, 1); }
  void operator()(const char* name, const char* unit, const std::optional<double>& value) {
    if (value) (*this)(name, unit, *value);
  }
  void operator()(const char* name, const char* unit, const std::vector<double>& values) {
    write(name, unit, values.data(), values.size());
  }
  template <std::integral Whole>
  void operator()(const char* name, const Whole& value) {
    const auto number = std::uint64_t(value);
    note(name);
    hdf5::write_attribute(hdf5::write_array(group_, name, &number, {1}).get(), "unit", "1");
  }
  void operator()(const char* name, const std::string& text) {
    note(name);
    hdf5::write_text(group_, name, text);
  }
  template <NamedEnum Enum>
  void operator()(const char* name, const Enum& value) {
    (*this)(name, std::string(name_or_null(value)));
  }
  template <NamedEnum Enum>
  void operator()(const char* name, const std::optional<Enum>& value) {
    if (value) (*this)(name, *value);
  }

  /// Ends the group by writing the list of its names.
  void close() { hdf5::write_attribute(group_, kFieldsAttribute, names_); }

 private:
  void write(const char* name, const char* unit, const double* values, std::size_t count) {
    note(name);
    hdf5::write_attribute(hdf5::write_array(group_, name, values, {count}).get(), "unit", unit);
  }
  void note(const char* name) { append_item(names_, name); }

  hid_t group_;
  std::string names_;
};

/// Reads settings from a group, by the same calls as SettingsWriter.
class SettingsReader {
 public:
  SettingsReader(RecordingSource& source, const std::string& group)
      : source_(source), name_(group), listed_(fields_listed(source, group)) {}

  void operator()(const char* name, const char* /*unit*/, double& value) {
    if (has(name)) value = only(name, source_.reals(at(name)));
  }
  void operator()(const char* name, const char* unit, std::optional<double>& value) {
    if (has(name)) (*this)(name, unit, value.emplace());
  }
  void operator()(const char* name, const char* /*unit*/, std::vector<double>& values) {
    if (has(name)) values = source_.reals(at(name));
  }
  template <std::integral Whole>
  void operator()(const char* name, Whole& value) {
    if (has(name)) value = Whole(only(name, source_.whole_numbers(at(name))));
  }
  void operator()(const char* name, std::string& text) {
    if (has(name)) text = source_.text(at(name));
  }
  template <NamedEnum Enum>
  void operator()(const char* name, Enum& value) {
    std::string found = name_or_null(value);
    (*this)(name, found);
    const std::optional<Enum> known = value_named<Enum>(found);
    if (!known)
      throw Error("its '" + name_ + "/" + name + "' is \"" + found + "\", but must be one of " + list_of_names<Enum>() +
                  ".");
    value = *known;
  }
  template <NamedEnum Enum>
  void operator()(const char* name, std::optional<Enum>& value) {
    if (has(name)) (*this)(name, value.emplace());
  }

  /// @throws Error when the group contains a field that was not read
  void close() const {
    for (const std::string& field : listed_)
      if (!contains(asked_, field))
        throw Error("it has '" + name_ + "/" + field +
                    "', which this version of hapticut does not know; use a newer version.");
  }

 private:
  /// Whether the group has this field; if not, the value stays unchanged.
  /// @throws Error when the list of fields names it
  bool has(const char* name) {
    asked_.emplace_back(name);
    if (source_.exists(at(name))) return true;
    if (!contains(listed_, name)) return false;
    throw Error("it lacks '" + name_ + "/" + name + "'.");
  }
  template <class Number>
  Number only(const char* name, const std::vector<Number>& values) const {
    if (values.size() != 1) throw Error("its '" + at(name) + "' must be one number.");
    return values[0];
  }
  [[nodiscard]] std::string at(const char* name) const { return name_ + "/" + name; }

  RecordingSource& source_;
  std::string name_;
  std::vector<std::string> listed_, asked_;
};

/// Writes or reads a field as data sets.
/// @param name  name with prefix: "spindle_speed"
template <class Archive, class Value>
void visit_value(Archive& archive, const std::string& name, const char* unit, Value& value) {
  using Plain = std::remove_const_t<Value>;
  if constexpr (std::is_same_v<Plain, double> || std::is_same_v<Plain, std::optional<double>>) {
    archive(name.c_str(), unit, value);
  } else if constexpr (std::is_same_v<Plain, AngularSpeed>) {
    double number = value;
    archive(name.c_str(), unit, number);
    if constexpr (!std::is_const_v<Value>) value = AngularSpeed::in_rad_per_s(number);
  } else if constexpr (std::is_same_v<Plain, Vec3>) {
    archive((name + "_x").c_str(), unit, value.x());
    archive((name + "_y").c_str(), unit, value.y());
    archive((name + "_z").c_str(), unit, value.z());
  } else {
    archive(name.c_str(), value);
  }
}

/// Marks a field that `visit_fields` leaves to its caller.
template <class... Types>
struct Except {};

/// Visits all fields of a struct in order.
/// @param prefix  prefix of their names: "spindle_"
/// @param except  types of fields that are stored in another way
template <class Archive, class S, class... Excepted>
void visit_fields(Archive& archive, const std::string& prefix, S& s, Except<Excepted...> /*except*/ = Except<>{}) {
  for_each_field<std::remove_const_t<S>>([&](const auto& field) {
    using Type = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (!(std::is_same_v<Type, Excepted> || ...))
      visit_value(archive, prefix + field.name, field.unit, s.*field.member);
  });
}

/// The settings in a group of a file.
/// @throws Error when the group is missing
inline SettingsReader settings_of(RecordingSource& source, const char* name) {
  if (!source.exists(name)) throw Error(std::string("it lacks the group '") + name + "'.");
  return {source, name};
}

}  // namespace hapticut
