// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

/// @file
/// The other side of a ChildProcess: what the programs that read for the library do with the socket that is their
/// input, and what they limit themselves to.
namespace hapticut::child {

/// @return false when the library has ended
inline bool take(char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = ::read(STDIN_FILENO, bytes, count);
    if (got <= 0) return false;
    bytes += got;
    count -= std::size_t(got);
  }
  return true;
}

/// @return false when the library has ended
inline bool give(const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::write(STDIN_FILENO, bytes, count);
    if (sent <= 0) return false;
    bytes += sent;
    count -= std::size_t(sent);
  }
  return true;
}

/// @param what  RLIMIT_AS, RLIMIT_CPU ...; it may be raised again
inline void limit(int what, std::uint64_t most) {
  rlimit value{};
  ::getrlimit(what, &value);
  value.rlim_cur = std::min<rlim_t>(most, value.rlim_max);
  ::setrlimit(what, &value);
}

}  // namespace hapticut::child
