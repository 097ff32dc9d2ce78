// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// @file
/// Messages between the library and its HDF5 reader program. A query is a Query followed by two texts; a reply is a
/// Reply followed by its content. Both programs run on one machine, so numbers are sent as in memory.
namespace hapticut {

enum class QueryKind : std::uint32_t {
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
  std::uint32_t value_type = 0;   ///< ValueType of a block
  std::uint32_t place_bytes = 0;  ///< length of the text that follows
  std::uint32_t name_bytes = 0;   ///< length of the next text
  std::uint64_t numbers = 0;      ///< numbers per row of a block
  std::uint64_t first = 0;        ///< first row of a block
  std::uint64_t count = 0;        ///< number of rows of a block
};

/// What a refusal is about.
enum class Fault : std::uint64_t {
  part,      ///< a part of the file is not as it was written
  damaged,   ///< the file cannot be read at all
  not_hdf5,  ///< it is another file
};

struct Reply {
  enum class Result : std::uint64_t { done, refused, no_memory };

  Result result = Result::done;
  std::uint64_t bytes = 0;    ///< length of the content; if refused, the content is the message
  Fault fault = Fault::part;  ///< if refused
};

inline constexpr std::uint64_t kMaxPlace = 1 << 16;        // [bytes]
inline constexpr std::uint64_t kMaxReply = 1 << 20;        // [bytes] size of a reply other than a block
inline constexpr std::uint64_t kMaxSentence = 1000;        // [bytes] size of a message shown to users
inline constexpr std::uint64_t kMaxDimensions = 32;        // number for a data set
inline constexpr unsigned kMaxReadingSeconds = 15;         // [s] processor time, plus time for long replies
inline constexpr std::uint64_t kBytesPerSecond = 4 << 20;  // [bytes/s] that define the time for long replies

}  // namespace hapticut
