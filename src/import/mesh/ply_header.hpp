// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/io/value_type.hpp"

/// @file
/// The header of a PLY file: a text that lists the elements of the file and the properties of each element.
namespace hapticut {

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  std::optional<ValueType> length;  ///< type of the length of a list
  ValueType value;
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;   ///< [bytes] size of the header; the values follow
  std::size_t lines = 0;  ///< number in the header
};

/// @throws Error that names the invalid line
[[nodiscard]] PlyHeader parse_ply_header(std::string_view file);

}  // namespace hapticut
