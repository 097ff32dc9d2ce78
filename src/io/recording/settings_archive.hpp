// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/recording/hdf5.hpp"

/// @file
/// Settings as data sets of a group: a name, a unit and a value. Writer and reader take the same calls, so that one
/// list of them serves both.
namespace hapticut {

/// The values of an enumeration by the words that stand for them.
template <class Enum>
using Names = std::vector<std::pair<Enum, const char*>>;

/// Writes settings into a group.
class SettingsWriter {
 public:
  explicit SettingsWriter(hid_t group) : group_(group) {}

  void operator()(const char* name, const char* unit, const double& value) { write(name, unit, &value, 1); }
  void operator()(const char* name, const char* unit, const std::vector<double>& values) {
    write(name, unit, values.data(), values.size());
  }
  void operator()(const char* name, const std::size_t& value) {
    const auto number = std::uint64_t(value);
    hdf5::write_attribute(hdf5::write_array(group_, name, &number, {1}).get(), "unit", "1");
  }
  void operator()(const char* name, const int& value) { (*this)(name, std::size_t(value)); }
  void operator()(const char* name, const bool& value) { (*this)(name, std::size_t(value)); }
  void operator()(const char* name, const std::string& text) { hdf5::write_text(group_, name, text); }
  template <class Enum>
  void operator()(const char* name, const Enum& value, const Names<Enum>& names) {
    for (const auto& [known, word] : names)
      if (known == value) hdf5::write_text(group_, name, word);
  }

 private:
  void write(const char* name, const char* unit, const double* values, std::size_t count) {
    hdf5::write_attribute(hdf5::write_array(group_, name, values, {count}).get(), "unit", unit);
  }
  hid_t group_;
};

/// Reads them back, by the same calls.
class SettingsReader {
 public:
  SettingsReader(hid_t group, std::string name) : group_(group), name_(std::move(name)) {}

  void operator()(const char* name, const char* /*unit*/, double& value) const { value = only<double>(name); }
  void operator()(const char* name, const char* /*unit*/, std::vector<double>& values) const {
    require(name);
    values = hdf5::read_array<double>(group_, name);
  }
  void operator()(const char* name, std::size_t& value) const { value = std::size_t(only<std::uint64_t>(name)); }
  void operator()(const char* name, int& value) const { value = int(only<std::uint64_t>(name)); }
  void operator()(const char* name, bool& value) const { value = only<std::uint64_t>(name) != 0; }
  void operator()(const char* name, std::string& text) const {
    require(name);
    text = hdf5::read_text(group_, name);
  }
  template <class Enum>
  void operator()(const char* name, Enum& value, const Names<Enum>& names) const {
    std::string found, allowed;
    (*this)(name, found);
    for (const auto& [known, word] : names) {
      if (found == word) {
        value = known;
        return;
      }
      if (!allowed.empty()) allowed += ", ";
      allowed += word;
    }
    throw Error("its '" + name_ + "/" + name + "' is \"" + found + "\", but must be one of " + allowed);
  }

 private:
  void require(const char* name) const {
    if (!hdf5::exists(group_, name)) throw Error("it lacks '" + name_ + "/" + name + "'");
  }
  template <class Number>
  Number only(const char* name) const {
    require(name);
    const std::vector<Number> values = hdf5::read_array<Number>(group_, name);
    if (values.size() != 1) throw Error("its '" + name_ + "/" + name + "' must be one number");
    return values[0];
  }
  hid_t group_;
  std::string name_;
};

/// The settings of a group of a file.
/// @param group  kept open by the caller
/// @throws Error when it is missing
inline SettingsReader settings_of(hid_t file, hdf5::Group& group, const char* name) {
  if (!hdf5::exists(file, name)) throw Error(std::string("it lacks the group '") + name + "'");
  group = hdf5::open_group(file, name);
  return {group.get(), name};
}

}  // namespace hapticut
