// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "hapticut/core/errors.hpp"

/// @file
/// Descriptions of public structs and enumerations. Each struct has a list of its fields next to it, each enumeration a
/// list of its names:
///
///     struct Ball {
///       double radius = 1e-3;  ///< [m] radius of the cutting surface
///     };
///
///     constexpr auto fields_of(Of<Ball>) {
///       return std::tuple{field("radius", &Ball::radius, "m", Range::positive(), "radius of the cutting surface")};
///     }
///
/// Validation, settings files and their help, recordings, .vdb files, and Python with its docstrings read this list;
/// tests compare the tables of the pages with it. A new field is one member, with its default and its
/// comment, and one line.
namespace hapticut {

/// The numbers that a field may have.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;         ///< `low` itself is not allowed
  bool allows_infinity = false;  ///< infinity is allowed and means no limit

  [[nodiscard]] static constexpr Range any() { return {}; }
  [[nodiscard]] static constexpr Range positive() { return above(0); }
  [[nodiscard]] static constexpr Range not_negative() {
    return {0, std::numeric_limits<double>::infinity(), false, false};
  }
  [[nodiscard]] static constexpr Range above(double low) {
    return {low, std::numeric_limits<double>::infinity(), true, false};
  }
  [[nodiscard]] static constexpr Range between(double low, double high) { return {low, high, false, false}; }
  /// Positive, or infinity, which means no limit.
  [[nodiscard]] static constexpr Range limit() { return {0, std::numeric_limits<double>::infinity(), true, true}; }

  [[nodiscard]] bool contains(double value) const {
    if (std::isinf(value) && value > 0) return allows_infinity;
    return std::isfinite(value) && value <= high && (low_open ? value > low : value >= low);
  }

  /// Completes "must be": "a number > 0".
  [[nodiscard]] std::string text() const { return "a number" + limits(); }
  /// Completes "a number": " > 0", " > 0 and <= 20", " from 0 to 1"; "" when every number is allowed.
  [[nodiscard]] std::string limits() const {
    if (!std::isfinite(low)) return "";
    if (std::isfinite(high) && !low_open) return " from " + format_number(low) + " to " + format_number(high);
    const std::string least = std::string(low_open ? " > " : " >= ") + format_number(low);
    return std::isfinite(high) ? least + " and <= " + format_number(high) : least;
  }

  /// For documentation: "> 0", "> 0, <= 20", "0 ... 1e+06"; "" when every number is allowed.
  [[nodiscard]] std::string short_text() const {
    if (!std::isfinite(low)) return "";
    if (std::isfinite(high) && !low_open) return format_number(low) + " ... " + format_number(high);
    const std::string least = (low_open ? "> " : ">= ") + format_number(low);
    return std::isfinite(high) ? least + ", <= " + format_number(high) : least;
  }
};

/// @param what  the value with its unit: "SphereHead::radius [m]"
/// @throws Error if the value is not within the range
inline void require_within(double value, const Range& range, const Subject& what) {
  if (range.contains(value)) return;
  const Sentence given =
      what + " = " + format_number(value, value > range.high ? range.high : range.low) + "; must be ";
  const std::string low = format_number(range.low, value), high = format_number(range.high, value);
  if (range.allows_infinity) throw Error(given + "> " + low + ". Leave it at infinity for no limit.");
  if (std::isfinite(range.low) && std::isfinite(range.high))
    throw Error(given + (range.low_open ? "> " + low + " and <= " + high : "between " + low + " and " + high) + ".");
  if (std::isfinite(range.low)) throw Error(given + "a finite number " + (range.low_open ? "> " : ">= ") + low + ".");
  throw Error(given + "a finite number.");
}

/// A tag for a type, for overloads that need only the type.
template <class T>
struct Of {};

/// One field of struct S.
template <class S, class T>
struct Field {
  using Struct = S;
  using Type = T;

  const char* name;  ///< as in C++
  T S::*member;
  const char* unit;  ///< "N/m"; "1" for a number without unit; "" if the field is not a number
  Range range;       ///< allowed numbers
  const char* text;  ///< description
};

/// A field with one number, or several with the same unit.
template <class S, class T>
[[nodiscard]] constexpr Field<S, T> field(const char* name, T S::*member, const char* unit, Range range,
                                          const char* text) {
  return {name, member, unit, range, text};
}

/// A field with a number of any value, such as a computed result.
template <class S, class T>
[[nodiscard]] constexpr Field<S, T> field(const char* name, T S::*member, const char* unit, const char* text) {
  return {name, member, unit, Range::any(), text};
}

/// A field that is not a number: a text, a switch, a choice, a struct.
template <class S, class T>
[[nodiscard]] constexpr Field<S, T> field(const char* name, T S::*member, const char* text) {
  return {name, member, "", Range::any(), text};
}

/// A struct with a list of its fields.
template <class S>
concept Described = requires {
  fields_of(Of<S>{});
};

/// Calls `visit(field)` for each field of S, in their order.
template <Described S, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... fields) { (visit(fields), ...); }, fields_of(Of<S>{}));
}

template <Described S>
inline constexpr std::size_t kFieldsOf = std::tuple_size_v<decltype(fields_of(Of<S>{}))>;

/// Whether a type is a number: double, int, AngularSpeed.
template <class T>
inline constexpr bool kIsNumber = std::is_convertible_v<T, double> && !std::is_same_v<T, bool>;

/// Calls `visit(field)` for each field of S that is a number, in their order.
template <Described S, class Visit>
constexpr void for_each_number(Visit&& visit) {
  for_each_field<S>([&](const auto& field) {
    if constexpr (kIsNumber<typename std::remove_cvref_t<decltype(field)>::Type>) visit(field);
  });
}

template <Described S>
inline constexpr std::size_t kNumbersOf = [] {
  std::size_t count = 0;
  for_each_number<S>([&](const auto&) { ++count; });
  return count;
}();

/// The allowed numbers of a field, found by its member: `range_of(&Spindle::droop)`.
template <class S, class T>
[[nodiscard]] constexpr Range range_of(T S::*member) {
  Range range;
  for_each_field<S>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), T S::*>)
      if (field.member == member) range = field.range;
  });
  return range;
}

/// One value of an enumeration and the word for it in files, on the command line and in Python.
template <class E>
struct Named {
  E value;
  const char* name;
  const char* words = nullptr;  ///< text for people, if it differs from the name
};
template <class E>
Named(E, const char*) -> Named<E>;
template <class E>
Named(E, const char*, const char*) -> Named<E>;

/// An enumeration with a list of its names, `names_of(Of<E>)`.
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires {
  names_of(Of<E>{});
};

/// Name of a value.  @return null when the enumeration has no such value
template <NamedEnum E>
[[nodiscard]] constexpr const char* name_or_null(E value) {
  for (const Named<E>& one : names_of(Of<E>{}))
    if (one.value == value) return one.name;
  return nullptr;
}

/// The value with a name, or nothing when there is no such name.
template <NamedEnum E>
[[nodiscard]] constexpr std::optional<E> value_named(std::string_view name) {
  for (const Named<E>& one : names_of(Of<E>{}))
    if (one.name == name) return one.value;
  return std::nullopt;
}

/// The names of an enumeration: "none, middle, end".
template <NamedEnum E>
[[nodiscard]] std::string list_of_names() {
  std::string list;
  for (const Named<E>& one : names_of(Of<E>{})) list += (list.empty() ? "" : ", ") + std::string(one.name);
  return list;
}

/// Checks every number of a struct against its range, and every choice against the names of its enumeration.
/// @param prefix  text before the field's name in messages: "Spindle::"
/// @throws Error naming the field, its unit, its value and what is allowed
/// @realtime no allocation if every field is as allowed
template <Described S>
void require_fields_within(const S& s, std::string_view prefix) {
  for_each_field<S>([&](const auto& field) {
    using T = typename std::remove_cvref_t<decltype(field)>::Type;
    const auto check = [&](double number) {
      if (!field.range.contains(number))
        require_within(number, field.range,
                       {Name(std::string(prefix) + field.name), " [" + std::string(field.unit) + "]"});
    };
    if constexpr (kIsNumber<T>) {
      check(double(s.*field.member));
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      if (s.*field.member) check(*(s.*field.member));
    } else if constexpr (requires(const T& vector) { vector.x() + vector.y() + vector.z(); }) {
      for (const double number : {(s.*field.member).x(), (s.*field.member).y(), (s.*field.member).z()}) check(number);
    } else if constexpr (NamedEnum<T>) {
      if (name_or_null(s.*field.member) == nullptr)
        throw Error(Name(std::string(prefix) + field.name) + " = " + std::to_string(int(s.*field.member)) +
                    "; must be one of: " + list_of_names<T>() + ".");
    }
  });
}

/// Calls `visit(bit, name)` for each bit of an enumeration of bits.
template <NamedEnum E, class Visit>
constexpr void for_each_bit(Visit&& visit) {
  for (const Named<E>& one : names_of(Of<E>{}))
    if (one.value != E{}) visit(one.value, one.name);
}

/// The suffix that a unit gives to a name: "N_per_m4" for "N/m^4"; "" for "1".
[[nodiscard]] inline std::string unit_in_names(std::string_view unit) {
  std::string name;
  if (unit == "1") return name;
  for (const char letter : unit) {
    if (letter == '/')
      name += "_per_";
    else if (letter != '^' && letter != ' ' && letter != '(' && letter != ')')
      name += letter;
  }
  return name;
}

}  // namespace hapticut
