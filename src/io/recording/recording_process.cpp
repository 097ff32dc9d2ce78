// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_process.hpp"

#include <new>

namespace hapticut {

RecordingProcess::RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                                   std::chrono::nanoseconds patience)
    : RecordingSource(file_size), patience_(patience), process_(kRecordingReader) {
  process_.start();
  (void)RecordingProcess::answer({}, std::filesystem::absolute(path).string(), "");
}

void RecordingProcess::die() {
  process_.stop();
  fail_of_reader();
}

void RecordingProcess::receive(char* bytes, std::size_t count) {
  if (!process_.receive(bytes, count, left_)) die();
}

std::string RecordingProcess::answer(const Question& question, const std::string& place, const std::string& name) {
  const std::lock_guard lock(one_question_);
  if (!process_.runs()) die();
  Question head = question;
  head.place_bytes = std::uint32_t(place.size());
  head.name_bytes = std::uint32_t(name.size());
  std::string message(reinterpret_cast<const char*>(&head), sizeof head);
  message += place + name;
  left_ = patience_;
  Answer answer;
  if (!process_.send(message)) die();
  receive(reinterpret_cast<char*>(&answer), sizeof answer);
  if (answer.result == Answer::Result::no_memory) throw std::bad_alloc();
  const bool done = answer.result == Answer::Result::done;
  const std::uint64_t most =
      done && head.ask == Ask::block ? head.numbers * head.count * size_of(ValueType(head.kind)) : kMaxAnswer;
  if ((!done && answer.result != Answer::Result::refused) || answer.bytes > most) die();
  std::string content(answer.bytes, '\0');
  receive(content.data(), content.size());
  if (!done) throw hdf5::Failure(content.substr(0, kMaxSentence));
  return content;
}

}  // namespace hapticut
