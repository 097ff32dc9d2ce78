// SPDX-License-Identifier: Apache-2.0
// Program that reads recordings for the library. It replies to queries about one HDF5 file over the socket at standard
// input. A malicious file may end it in any way; the library then reports a damaged file.
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <new>
#include <string>

#include "io/child_side.hpp"
#include "io/recording/hdf5_source.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAPTICUT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAPTICUT_SANITIZED
#endif
#endif

namespace hapticut::recording_reader {
namespace {

using child::limit;
using child::read_all;
using child::write_all;

constexpr std::uint64_t kMemory = std::uint64_t(1) << 30U;  // [bytes] memory in addition to kMemoryPerByte
constexpr std::uint64_t kMemoryPerByte = 4;

void limit_memory(const std::string& path) {
#if !defined(HAPTICUT_SANITIZED)
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  limit(RLIMIT_AS, kMemory + (code ? 0 : kMemoryPerByte * size));
#else
  (void)path;  // sanitizers reserve more address space than any limit
#endif
}

void reply_to_all() {
  std::unique_ptr<Hdf5Source> source;
  std::uint64_t given = 0;
  for (Query q; read_all(reinterpret_cast<char*>(&q), sizeof q);) {
    if (q.place_bytes > kMaxPlace || q.name_bytes > kMaxPlace) return;
    std::string place(q.place_bytes, '\0'), name(q.name_bytes, '\0'), content;
    if (!read_all(place.data(), place.size()) || !read_all(name.data(), name.size())) return;
    limit(RLIMIT_CPU, kMaxReadingSeconds + given / kBytesPerSecond);
    Reply reply;
    try {
      if (q.kind == QueryKind::open) {
        limit_memory(place);
        source = open_hdf5_file(place);
      } else if (source == nullptr) {
        throw hdf5::Failure("no file is open");
      } else {
        content = source->reply_to(q, place, name);
      }
    } catch (const std::bad_alloc&) {
      reply.result = Reply::Result::no_memory;
    } catch (const hdf5::Failure& failure) {
      reply.result = Reply::Result::refused;
      reply.fault = failure.fault();
      content = failure.what();
    } catch (const std::exception& error) {
      reply.result = Reply::Result::refused;
      content = error.what();
    }
    reply.bytes = content.size();
    given += content.size();
    if (!write_all(reinterpret_cast<const char*>(&reply), sizeof reply) || !write_all(content.data(), content.size()))
      return;
  }
}

}  // namespace
}  // namespace hapticut::recording_reader

int main() {
  using namespace hapticut::recording_reader;
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXCPU, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  reply_to_all();
  // Skips HDF5's exit function, which may hang on a damaged file.
  ::_exit(0);
}
