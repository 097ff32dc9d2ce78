// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_process.hpp"

#include <cstring>
#include <new>

namespace hapticut {

RecordingProcess::RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                                   std::chrono::nanoseconds patience)
    : RecordingSource(file_size), patience_(patience), process_(kRecordingReader) {
  process_.start();
  (void)ask_short(Ask::open, std::filesystem::absolute(path).string());
}

void RecordingProcess::die() {
  process_.stop();
  throw hdf5::Failure(
      "it is a damaged HDF5 file: the program that reads it came to an end over it, or needed too long; get a complete "
      "copy");
}

void RecordingProcess::receive(char* bytes, std::size_t count) {
  if (!process_.receive(bytes, count, left_)) die();
}

std::uint64_t RecordingProcess::ask(const Question& question, const std::string& place, const std::string& name) {
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
  if (answer.result == Answer::Result::done) return answer.bytes;
  if (answer.result == Answer::Result::no_memory) throw std::bad_alloc();
  if (answer.result != Answer::Result::refused || answer.bytes > kLongestAnswer) die();
  std::string sentence(answer.bytes, '\0');
  receive(sentence.data(), sentence.size());
  throw hdf5::Failure(sentence.substr(0, kLongestSentence));
}

std::string RecordingProcess::ask_short(Ask what, const std::string& place, const std::string& name) {
  const std::lock_guard lock(one_question_);
  Question question;
  question.ask = what;
  const std::uint64_t length = ask(question, place, name);
  if (length > kLongestAnswer) die();
  std::string content(length, '\0');
  receive(content.data(), content.size());
  return content;
}

bool RecordingProcess::ask_whether(Ask what, const std::string& place, const std::string& name) {
  const std::string content = ask_short(what, place, name);
  if (content.size() != 1) die();
  return content[0] != 0;
}

bool RecordingProcess::exists(const std::string& place) { return ask_whether(Ask::exists, place); }
bool RecordingProcess::has_attribute(const std::string& place, const std::string& name) {
  return ask_whether(Ask::has_attribute, place, name);
}
std::string RecordingProcess::text_attribute(const std::string& place, const std::string& name) {
  return ask_short(Ask::text_attribute, place, name);
}
std::string RecordingProcess::text(const std::string& place) { return ask_short(Ask::text, place); }

std::uint64_t RecordingProcess::number_attribute(const std::string& place, const std::string& name) {
  const std::string content = ask_short(Ask::number_attribute, place, name);
  std::uint64_t number = 0;
  if (content.size() != sizeof number) die();
  std::memcpy(&number, content.data(), sizeof number);
  return number;
}

DataSetLayout RecordingProcess::layout(const std::string& place) {
  const std::string content = ask_short(Ask::layout, place);
  std::vector<std::uint64_t> numbers(content.size() / sizeof(std::uint64_t));
  if (numbers.empty() || numbers.size() > 1 + kMostDimensions || content.size() % sizeof(std::uint64_t) != 0) die();
  std::memcpy(numbers.data(), content.data(), content.size());
  return {numbers[0] != 0, {numbers.begin() + 1, numbers.end()}};
}

void RecordingProcess::block(const std::string& place, ColumnKind kind, std::uint64_t numbers, std::uint64_t first,
                             std::uint64_t count, std::byte* bytes) {
  const std::lock_guard lock(one_question_);
  Question question;
  question.ask = Ask::block;
  question.kind = std::uint32_t(kind);
  question.numbers = numbers;
  question.first = first;
  question.count = count;
  const std::uint64_t expected = numbers * count * bytes_of(kind);
  if (ask(question, place, "") != expected) die();
  receive(reinterpret_cast<char*>(bytes), expected);
}

}  // namespace hapticut
