// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_process.hpp"

#include <new>

namespace hapticut {

RecordingProcess::RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                                   std::chrono::nanoseconds time_limit)
    : RecordingSource(file_size), time_limit_(time_limit), process_(kRecordingReader) {
  process_.start();
  (void)RecordingProcess::reply_to({}, std::filesystem::absolute(path).string(), "");
}

void RecordingProcess::die() {
  process_.stop();
  fail_in_reader();
}

void RecordingProcess::receive(char* bytes, std::size_t count) {
  if (!process_.receive(bytes, count, time_left_)) die();
}

std::string RecordingProcess::reply_to(const Query& query, const std::string& place, const std::string& name) {
  const std::lock_guard lock(query_mutex_);
  if (!process_.runs()) die();
  Query head = query;
  head.place_bytes = std::uint32_t(place.size());
  head.name_bytes = std::uint32_t(name.size());
  std::string message(reinterpret_cast<const char*>(&head), sizeof head);
  message += place + name;
  time_left_ = time_limit_;
  Reply reply;
  if (!process_.send(message)) die();
  receive(reinterpret_cast<char*>(&reply), sizeof reply);
  if (reply.result == Reply::Result::no_memory) throw std::bad_alloc();
  const bool done = reply.result == Reply::Result::done;
  const std::uint64_t max_bytes = done && head.kind == QueryKind::block
                                      ? head.numbers * head.count * size_of(ValueType(head.value_type))
                                      : kMaxReply;
  if ((!done && reply.result != Reply::Result::refused) || reply.bytes > max_bytes) die();
  std::string content(reply.bytes, '\0');
  receive(content.data(), content.size());
  if (!done) throw hdf5::Failure(content.substr(0, kMaxSentence), reply.fault);
  return content;
}

}  // namespace hapticut
