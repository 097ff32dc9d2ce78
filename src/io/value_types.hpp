// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hapticut/io/value_type.hpp"

/// @file
/// Converts between value types of files and C++ types, for volumes, meshes and the columns of recordings.
namespace hapticut {

/// Calls `use(Type{})` with the C++ type of the values.
/// @return the result of `use`
template <class Use>
auto with_value_type(ValueType type, const Use& use) {
  switch (type) {
    case ValueType::uint8:
      return use(std::uint8_t{});
    case ValueType::int8:
      return use(std::int8_t{});
    case ValueType::uint16:
      return use(std::uint16_t{});
    case ValueType::int16:
      return use(std::int16_t{});
    case ValueType::uint32:
      return use(std::uint32_t{});
    case ValueType::int32:
      return use(std::int32_t{});
    case ValueType::uint64:
      return use(std::uint64_t{});
    case ValueType::int64:
      return use(std::int64_t{});
    case ValueType::float32:
      return use(float{});
    case ValueType::float64:
      break;
  }
  return use(double{});
}

/// [bytes] Size of one value.
[[nodiscard]] inline std::size_t size_of(ValueType type) {
  return with_value_type(type, [](auto zero) { return sizeof zero; });
}

/// The value type of a C++ type. ValueType lists types of the same size next to each other.
template <class Value>
[[nodiscard]] constexpr ValueType value_type_of() {
  const int size = std::countr_zero(sizeof(Value));
  return ValueType(std::is_floating_point_v<Value> ? 6 + size : 2 * size + (std::is_signed_v<Value> ? 1 : 0));
}
static_assert(value_type_of<std::uint8_t>() == ValueType::uint8 && value_type_of<std::int64_t>() == ValueType::int64 &&
              value_type_of<float>() == ValueType::float32 && value_type_of<double>() == ValueType::float64);

}  // namespace hapticut
