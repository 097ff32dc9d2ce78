// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// @file
/// Heads of the messages between the library and a ChildProcess; the content of a message follows its head. Both
/// programs run on one machine, so numbers are sent as in memory.
namespace hapticut {

struct Request {
  std::uint64_t memory = 0;   ///< [bytes] maximum address space of the child
  std::uint64_t seconds = 0;  ///< [s] maximum processor time of the child since its start
  std::uint64_t bytes = 0;    ///< length of the content
};

struct Reply {
  enum class Result : std::uint64_t { done, refused, no_memory };

  Result result = Result::done;
  std::uint64_t reason = 0;  ///< if refused: a number that the two programs agree on
  std::uint64_t bytes = 0;   ///< length of the content; if refused, the content is the message
};

}  // namespace hapticut
