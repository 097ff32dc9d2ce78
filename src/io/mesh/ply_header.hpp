// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/io/volume/value_type.hpp"

/// @file
/// The header of a PLY file: a text that says of which elements the file is made, and of which properties each element.
namespace hapticut {

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  std::optional<ValueType> length;  ///< of a list: how its length is written
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
  std::size_t size = 0;   ///< [bytes] of the header; the values follow
  std::size_t lines = 0;  ///< of the header
};

/// @throws Error that names the line that does not belong into a header
[[nodiscard]] PlyHeader parse_ply_header(std::string_view file);

}  // namespace hapticut
