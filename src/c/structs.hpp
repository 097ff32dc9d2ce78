// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

#include "c/failure.hpp"
#include "hapticut/c/hapticut.h"
#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/workpiece/material_set.hpp"

/// @file
/// Conversion of the structs of the interface: from and to older or newer callers, and from and to C++.
namespace hapticut::c {

inline constexpr std::uint32_t kMinStruct = 8, kMaxStruct = 4096;

/// Checks the size of a caller's struct.
/// @param name  of the argument, for the error
/// @realtime no allocation, no lock, if the size is valid
template <class S>
[[nodiscard]] int check_size(const S* given, const char* name) noexcept {
  static_assert(std::is_trivially_copyable_v<S> && offsetof(S, struct_size) == 0 && sizeof(S) % 8 == 0);
  char text[160];
  if (given == nullptr) {
    std::snprintf(text, sizeof text, "%s is a null pointer; it must not be null.", name);
    return fail(HAPTICUT_ERROR_ARGUMENT, text);
  }
  const std::uint32_t size = given->struct_size;
  if (size >= kMinStruct && size <= kMaxStruct && size % 8 == 0) return HAPTICUT_OK;
  std::snprintf(text, sizeof text, "%s->struct_size = %u; set it to sizeof(*%s), which is %zu here.", name,
                unsigned(size), name, sizeof(S));
  return fail(HAPTICUT_ERROR_STRUCT_SIZE, text);
}

/// Checks the size of a struct that may be null.
template <class S>
[[nodiscard]] int check_size_if_given(const S* given, const char* name) noexcept {
  return given == nullptr ? int(HAPTICUT_OK) : check_size(given, name);
}

/// Reads a caller's struct. Fields that the caller lacks become 0.
/// @realtime like check_size
template <class S>
[[nodiscard]] int read_struct(const S* given, const char* name, S& own) noexcept {
  if (const int code = check_size(given, name); code != HAPTICUT_OK) return code;
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  const std::size_t size = given->struct_size;
  if (std::any_of(bytes + std::min(size, sizeof(S)), bytes + size, [](unsigned char byte) { return byte != 0; })) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "%s has %zu bytes and sets fields after the first %zu, which this older library does not "
                  "have; install the library that belongs to the header.",
                  name, size, sizeof(S));
    return fail(HAPTICUT_ERROR_STRUCT_SIZE, text);
  }
  std::memset(static_cast<void*>(&own), 0, sizeof(S));
  std::memcpy(static_cast<void*>(&own), given, std::min(size, sizeof(S)));
  return HAPTICUT_OK;
}

/// Reads a struct that may be null. Then all fields are 0.
template <class S>
[[nodiscard]] int read_struct_if_given(const S* given, const char* name, S& own) noexcept {
  std::memset(static_cast<void*>(&own), 0, sizeof(S));
  return given == nullptr ? int(HAPTICUT_OK) : read_struct(given, name, own);
}

/// Writes a caller's struct, whose size was checked. Fields that the caller lacks are left out.
/// @realtime no allocation, no lock
template <class S>
void write_struct(const S& own, S* to) noexcept {
  const std::size_t size = to->struct_size;
  auto* bytes = reinterpret_cast<unsigned char*>(to);
  constexpr std::size_t kFirst = sizeof(to->struct_size);
  std::memcpy(bytes + kFirst, reinterpret_cast<const unsigned char*>(&own) + kFirst,
              std::min(size, sizeof(S)) - kFirst);
  if (size > sizeof(S)) std::memset(bytes + sizeof(S), 0, size - sizeof(S));
}

inline constexpr std::uint32_t kTooMany = 1'000'000;  // a count that is refused and fits an int

/// Sets a value, where 0 means the default.
template <class Given, class Value>
void set_if_given(Given given, Value& value) noexcept {
  if (given != 0) value = Value(given);
}

[[nodiscard]] inline Vec3 vector_of(const double* values) noexcept { return {values[0], values[1], values[2]}; }

[[nodiscard]] inline Pose pose_of(const hapticut_pose& given) noexcept {
  Pose pose;
  pose.translation = vector_of(given.position);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) pose.rotation(row, column) = given.rotation[3 * row + column];
  return pose;
}

inline void put(const Vec3& vector, double* to) noexcept {
  for (int axis = 0; axis < 3; ++axis) to[axis] = vector[axis];
}

/// A number, a set of bits or a state.
template <class From, class To>
requires((std::is_arithmetic_v<From> || std::is_enum_v<From>)&&std::is_arithmetic_v<To>) void put(From number,
                                                                                                  To& to) noexcept {
  to = To(number);
}

inline void put(const MaterialSet& set, std::uint64_t* to) noexcept {
  std::copy(set.words.begin(), set.words.end(), to);
}

inline void put(const Pose& pose, hapticut_pose& to) noexcept {
  put(pose.translation, to.position);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) to.rotation[3 * row + column] = pose.rotation(row, column);
}

/// The place of a name in the description of S; kFieldsOf<S> if S has no such field.
template <Described S>
[[nodiscard]] consteval std::size_t place_of(std::string_view name) {
  std::size_t place = 0, found = kFieldsOf<S>;
  for_each_field<S>([&](const auto& field) {
    if (field.name == name) found = place;
    ++place;
  });
  return found;
}

/// Puts each field of a C++ struct into the field of the same name of the interface, if the interface has it.
/// @realtime no allocation, no lock
template <Described From, Described To>
void put_fields(const From& from, To& to) noexcept {
  const auto put_one = [&]<std::size_t kOne>(std::integral_constant<std::size_t, kOne>) {
    constexpr auto kField = std::get<kOne>(fields_of(Of<From>{}));
    constexpr std::size_t kPlace = place_of<To>(kField.name);
    if constexpr (kPlace < kFieldsOf<To>) put(from.*kField.member, to.*std::get<kPlace>(fields_of(Of<To>{})).member);
  };
  [&]<std::size_t... kN>(std::index_sequence<kN...>) { (put_one(std::integral_constant<std::size_t, kN>{}), ...); }
  (std::make_index_sequence<kFieldsOf<From>>());
}

/// Whether the interface has a field for each field of a C++ struct.
template <Described From, Described To>
inline constexpr bool kHasEachField = []<std::size_t... kN>(std::index_sequence<kN...>) {
  return ((place_of<To>(std::get<kN>(fields_of(Of<From>{})).name) < kFieldsOf<To>)&&...);
}
(std::make_index_sequence<kFieldsOf<From>>());

/// A field of the interface that is named as in C++, for its `fields_of`.
#define HAPTICUT_C_FIELD(Struct, name) ::hapticut::field(#name, &Struct::name, "as in C++")

}  // namespace hapticut::c
