// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"

/// @file
/// Errors for missing settings and for settings that do not apply. The program says the flag of a key, other front ends
/// the key.
namespace hapticut::settings {

/// @param key    key of the setting, "tool.radius_mm"
/// @param owner  what needs the setting: "a sphere"
[[noreturn]] inline void fail_missing(const Name& key, const Sentence& owner) {
  throw Error(key + " is missing; " + owner + " needs it. Set " + key + ".");
}

/// @throws Error when there is no value
inline double required(const std::optional<double>& value, const Name& key, const Sentence& owner) {
  if (!value) fail_missing(key, owner);
  return *value;
}

/// Value of a setting in a message: " = 3", " = 1 2 3", or " is set" for a choice.
template <class Value>
std::string equals(const Value& value) {
  if constexpr (std::is_convertible_v<Value, double> && !std::is_enum_v<Value>)
    return " = " + format_number(double(value));
  else if constexpr (std::is_same_v<Value, Vec3>)
    return " = " + format_number(value.x()) + " " + format_number(value.y()) + " " + format_number(value.z());
  else if constexpr (std::is_same_v<Value, std::string>)
    return " = \"" + value + "\"";
  else
    return " is set";
}

/// @param owner   what does not have the setting: "a sphere"
/// @param instead  completes "Leave it out, or ...": "choose a cone"
/// @throws Error when there is a value
template <class Value>
void refuse(const std::optional<Value>& value, const Name& key, const Sentence& owner, const Sentence& instead) {
  if (value)
    throw Error(key + equals(*value) + "; must be left out, because " + owner + " has none. Leave it out, or " +
                instead + ".");
}

/// @throws Error that names both settings, when one exceeds the other
inline void require_at_most(double value, const Name& key, double limit, const Name& limit_key) {
  if (value > limit)
    throw Error(key + " = " + format_number(value, limit) + "; must be at most " + limit_key + " = " +
                format_number(limit, value) + ". Lower it, or raise " + limit_key + ".");
}

}  // namespace hapticut::settings
