// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// @file
/// What is said between the library and the program that reads HDF5 for it. A query is a Query and two texts, an
/// reply an Reply and its content: both run on one machine, so numbers go as they are in memory.
namespace hapticut {

enum class QueryKind : std::uint32_t {
  open,              ///< place: path of the file; content: nothing
  exists,            ///< content: one byte, 0 or 1
  has_attribute,     ///< the same
  text_attribute,    ///< content: the text
  number_attribute,  ///< content: a std::uint64_t
  text,              ///< content: the text
  layout,            ///< content: std::uint64_t of 1 for real numbers, else 0, and the lengths
  block              ///< content: the rows
};

struct Query {
  QueryKind kind = QueryKind::open;
  std::uint32_t value_type = 0;         ///< ValueType of a block
  std::uint32_t place_bytes = 0;  ///< that follow
  std::uint32_t name_bytes = 0;   ///< that follow those
  std::uint64_t numbers = 0;      ///< of a row of a block
  std::uint64_t first = 0;        ///< row of a block
  std::uint64_t count = 0;        ///< rows of a block
};

struct Reply {
  enum class Result : std::uint64_t { done, refused, no_memory };

  Result result = Result::done;
  std::uint64_t bytes = 0;  ///< of the content that follows; of what was refused: the sentence
};

inline constexpr std::uint64_t kMaxPlace = 1 << 16;        // [bytes]
inline constexpr std::uint64_t kMaxReply = 1 << 20;       // [bytes] of what is no block
inline constexpr std::uint64_t kMaxSentence = 1000;        // [bytes] of it that are shown
inline constexpr std::uint64_t kMaxDimensions = 32;        // of a data set
inline constexpr unsigned kMaxReadingSeconds = 15;         // of processor time, and more for what is long
inline constexpr std::uint64_t kBytesPerSecond = 4 << 20;  // that it has more for

}  // namespace hapticut
