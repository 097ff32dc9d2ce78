// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "io/byte_reader.hpp"
#include "io/value_types.hpp"

/// @file
/// Queries of the library to its HDF5 reader program; a query is the content of a Request.
namespace hapticut {

enum class QueryKind : std::uint8_t {
  open,              ///< place: path of the file; content: nothing
  exists,            ///< content: one byte, 0 or 1
  has_attribute,     ///< content: one byte, 0 or 1
  text_attribute,    ///< content: the text
  number_attribute,  ///< content: a std::uint64_t
  text,              ///< content: the text
  layout,            ///< content: std::uint64_t numbers: 1 for real numbers, else 0, then the lengths
  block              ///< content: the rows
};

struct Query {
  QueryKind kind = QueryKind::open;
  std::string place = {};
  std::string name = {};                      ///< of an attribute
  ValueType value_type = ValueType::float64;  ///< of a block
  std::uint64_t numbers = 0;                  ///< numbers per row of a block
  std::uint64_t first = 0;                    ///< first row of a block
  std::uint64_t count = 0;                    ///< number of rows of a block
};

/// What a refusal is about.
enum class Fault : std::uint64_t {
  part,      ///< a part of the file is not as it was written
  damaged,   ///< the file cannot be read at all
  not_hdf5,  ///< it is another file
};

/// Calls `use` with each number of a query, in the order of the message.
template <class AQuery, class Use>
void for_each_number_of(AQuery& query, const Use& use) {
  use(query.kind);
  use(query.value_type);
  use(query.numbers);
  use(query.first);
  use(query.count);
}

[[nodiscard]] inline std::string bytes_of(const Query& query) {
  std::string bytes;
  for_each_number_of(query, [&](const auto& number) { append_bytes_of(bytes, number); });
  append_bytes_of(bytes, std::uint64_t(query.place.size()));
  return bytes + query.place + query.name;
}

[[nodiscard]] inline Query query_in(std::string_view bytes) {
  ByteReader in(bytes);
  Query query;
  for_each_number_of(query, [&]<class Number>(Number& number) { number = in.read<Number>(); });
  query.place = in.read(in.read<std::uint64_t>());
  query.name = in.read(in.left());
  return query;
}

}  // namespace hapticut
