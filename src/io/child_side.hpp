// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "io/child_messages.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAPTICUT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAPTICUT_SANITIZED
#endif
#endif

/// @file
/// The child's side of a ChildProcess.
namespace hapticut::child {

/// Reads or writes all bytes at standard input, the socket of the connection.
/// @param transfer  ::read or ::write
/// @return false when the library's process has ended
template <class Transfer, class Byte>
bool transfer_all(Transfer transfer, Byte* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t moved = transfer(STDIN_FILENO, bytes, count);
    if (moved <= 0) return false;
    bytes += moved;
    count -= std::size_t(moved);
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

/// Replies to requests until the library's process ends, then ends this program. A malicious file may end it earlier in
/// any way: the library then reports a damaged file.
/// @param answer     from the content of a request to the content of its reply; an exception refuses the request
/// @param reason_of  from that exception to Reply::reason
template <class Answer, class ReasonOf>
[[noreturn]] void serve(const Answer& answer, const ReasonOf& reason_of) {
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXCPU, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  std::uint64_t memory = 0;
  for (Request request; transfer_all(::read, reinterpret_cast<char*>(&request), sizeof request);) {
    memory = std::max(memory, request.memory);
#if !defined(HAPTICUT_SANITIZED)  // sanitizers reserve more address space than any limit
    limit(RLIMIT_AS, memory);
#endif
    limit(RLIMIT_CPU, request.seconds);
    std::string content(request.bytes, '\0');
    if (!transfer_all(::read, content.data(), content.size())) break;
    Reply reply;
    try {
      content = answer(content);
    } catch (const std::bad_alloc&) {
      reply.result = Reply::Result::no_memory;
      content.clear();
    } catch (const std::exception& error) {
      reply.result = Reply::Result::refused;
      reply.reason = std::uint64_t(reason_of(error));
      content = error.what();
    }
    reply.bytes = content.size();
    if (!transfer_all(::write, reinterpret_cast<const char*>(&reply), sizeof reply) ||
        !transfer_all(::write, content.data(), content.size()))
      break;
  }
  ::_exit(0);  // without exit functions: that of HDF5 may hang on a damaged file
}

}  // namespace hapticut::child
