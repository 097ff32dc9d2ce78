// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_process.hpp"

#include <algorithm>
#include <new>

namespace hapticut {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t(1) << 30U;  // [bytes] memory in addition to kMemoryPerByte
constexpr std::uint64_t kMemoryPerByte = 4;                 // [bytes] per byte of the file
constexpr std::uint64_t kReadingSeconds = 15;               // [s] processor time, plus time for long replies
constexpr std::uint64_t kBytesPerSecond = 4 << 20;          // [bytes/s] that define the time for long replies
constexpr std::uint64_t kMaxReply = 1 << 20;                // [bytes] size of a reply other than a block
constexpr std::size_t kMaxSentence = 1000;                  // [bytes] size of a message shown to users

}  // namespace

RecordingProcess::RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                                   std::chrono::nanoseconds time_limit)
    : RecordingSource(file_size),
      process_(kRecordingReader, time_limit),
      memory_(kMemory + kMemoryPerByte * file_size) {
  process_.start();
  (void)RecordingProcess::reply_to({.place = std::filesystem::absolute(path).string()});
}

std::string RecordingProcess::reply_to(const Query& query) {
  const std::lock_guard lock(query_mutex_);
  const std::uint64_t block = query.numbers * query.count * size_of(query.value_type);  // 0: no block
  std::optional<ChildProcess::Answer> answer = process_.ask(
      bytes_of(query), {memory_, kReadingSeconds + received_ / kBytesPerSecond}, std::max(block, kMaxReply));
  if (!answer) fail_in_reader();
  if (answer->result == Reply::Result::no_memory) throw std::bad_alloc();
  if (answer->result == Reply::Result::refused) {
    const bool is_known = answer->reason <= std::uint64_t(Fault::not_hdf5);
    throw hdf5::Failure(answer->content.substr(0, kMaxSentence), is_known ? Fault(answer->reason) : Fault::part);
  }
  received_ += answer->content.size();
  return std::move(answer->content);
}

}  // namespace hapticut
