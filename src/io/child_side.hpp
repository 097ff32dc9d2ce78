// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

/// @file
/// The child's side of a ChildProcess: input and output over the socket at standard input, and resource limits.
namespace hapticut::child {

/// @return false when the library's process has ended
inline bool read_all(char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = ::read(STDIN_FILENO, bytes, count);
    if (got <= 0) return false;
    bytes += got;
    count -= std::size_t(got);
  }
  return true;
}

/// @return false when the library's process has ended
inline bool write_all(const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::write(STDIN_FILENO, bytes, count);
    if (sent <= 0) return false;
    bytes += sent;
    count -= std::size_t(sent);
  }
  return true;
}

/// @param what  RLIMIT_AS, RLIMIT_CPU ...; sets only the soft limit, so it can be raised again
inline void limit(int what, std::uint64_t max) {
  rlimit value{};
  ::getrlimit(what, &value);
  value.rlim_cur = std::min<rlim_t>(max, value.rlim_max);
  ::setrlimit(what, &value);
}

}  // namespace hapticut::child
