// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hapticut/core/errors.hpp"

/// @file
/// Settings that one kind of thing needs and another does not have.
namespace hapticut::cli {

/// @param key    of the setting: "tool.radius_mm"; its flag is what follows the point
/// @param owner  what needs it: "a sphere"
[[noreturn]] inline void fail_missing(const std::string& key, const std::string& owner) {
  const std::size_t point = key.find('.');
  const std::string name = key.substr(point + 1);
  throw Error(key + " is missing; " + owner + " needs it. Set --" + name + ", or " + name + " under [" +
              key.substr(0, point) + "] in the settings file.");
}

/// @throws Error when there is no value
inline double required(const std::optional<double>& value, const std::string& key, const std::string& owner) {
  if (!value) fail_missing(key, owner);
  return *value;
}

/// @throws Error when there is a value
template <class Value>
void refuse(const std::optional<Value>& value, const std::string& key, const std::string& owner) {
  if (value) throw Error(key + " is set, but " + owner + " has none. Leave it out, or choose another.");
}

/// @throws Error when a setting exceeds another one; both are named
inline void require_at_most(double value, const std::string& key, double limit, const std::string& limit_key) {
  if (value > limit)
    throw Error(key + " = " + format_number(value) + "; must be at most " + limit_key + " = " + format_number(limit) +
                ". Lower it, or raise " + limit_key + ".");
}

}  // namespace hapticut::cli
