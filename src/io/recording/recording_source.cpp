// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_source.hpp"

#include <algorithm>
#include <cstring>

namespace hapticut {
namespace {

constexpr std::uint64_t kBlock = 8 << 20;   // [bytes] per block query
constexpr std::size_t kMaxDimensions = 32;  // of a data set

template <class Number>
std::vector<Number> numbers_of(const void* bytes, std::size_t size) {
  std::vector<Number> numbers(size / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes, numbers.size() * sizeof(Number));
  return numbers;
}

template <class Number>
Number only_number(const std::string& content) {
  if (content.size() != sizeof(Number)) fail_in_reader();
  return number_in<Number>(content);
}

}  // namespace

std::string name_at(const std::string& place) { return place.substr(place.rfind('/') + 1); }

void require_size_in_file(double bytes, std::uint64_t file_size, const std::string& name) {
  constexpr double kMaxDeflateRatio = 1032;  // times smaller
  if (bytes > kMaxDeflateRatio * double(file_size))
    throw hdf5::Failure("its '" + name + "' claims " + format_number(bytes) + " bytes, more than fit in the file");
}

void fail_in_reader() {
  throw hdf5::Failure("it is a damaged HDF5 file: the program that reads it crashed or took too long", Fault::damaged);
}

bool RecordingSource::exists(const std::string& place) {
  return only_number<std::uint8_t>(reply_to({QueryKind::exists, place})) != 0;
}
bool RecordingSource::has_attribute(const std::string& place, const std::string& name) {
  return only_number<std::uint8_t>(reply_to({QueryKind::has_attribute, place, name})) != 0;
}
std::string RecordingSource::text_attribute(const std::string& place, const std::string& name) {
  return reply_to({QueryKind::text_attribute, place, name});
}
std::uint64_t RecordingSource::number_attribute(const std::string& place, const std::string& name) {
  return only_number<std::uint64_t>(reply_to({QueryKind::number_attribute, place, name}));
}
std::string RecordingSource::text(const std::string& place) { return reply_to({QueryKind::text, place}); }

DataSetLayout RecordingSource::layout(const std::string& place) {
  const std::string content = reply_to({QueryKind::layout, place});
  const auto numbers = numbers_of<std::uint64_t>(content.data(), content.size());
  if (numbers.empty() || numbers.size() > 1 + kMaxDimensions || content.size() % sizeof(std::uint64_t) != 0)
    fail_in_reader();
  return {numbers[0] != 0, {numbers.begin() + 1, numbers.end()}};
}

void RecordingSource::rows(const std::string& place, ValueType kind, std::uint64_t numbers, std::uint64_t first,
                           std::uint64_t count, std::vector<std::byte>& bytes) {
  const std::uint64_t row = numbers * size_of(kind);
  require_size_in_file(double(numbers) * double(size_of(kind)) * double(count), file_size_, name_at(place));
  bytes.resize(count * row);
  if (bytes.empty()) return;
  const std::uint64_t at_once = std::max<std::uint64_t>(1, kBlock / row);
  for (std::uint64_t done = 0; done < count; done += at_once) {
    const std::uint64_t now = std::min(at_once, count - done);
    const std::string block = reply_to({QueryKind::block, place, "", kind, numbers, first + done, now});
    if (block.size() != now * row) fail_in_reader();
    std::memcpy(bytes.data() + done * row, block.data(), block.size());
  }
}

template <class Number>
std::vector<Number> RecordingSource::all(const std::string& place) {
  const std::vector<std::uint64_t> shape = layout(place).shape;
  double total = 1;  // double, so the product cannot overflow
  for (const std::uint64_t length : shape) total *= double(length);
  require_size_in_file(total * double(sizeof(Number)), file_size_, name_at(place));
  std::uint64_t numbers = 1;
  for (std::size_t n = 1; n < shape.size(); ++n) numbers *= shape[n];
  std::vector<std::byte> result;
  if (total > 0) rows(place, value_type_of<Number>(), numbers, 0, shape.empty() ? 1 : shape[0], result);
  return numbers_of<Number>(result.data(), result.size());
}

std::vector<double> RecordingSource::reals(const std::string& place) { return all<double>(place); }
std::vector<std::uint64_t> RecordingSource::whole_numbers(const std::string& place) {
  return all<std::uint64_t>(place);
}
std::vector<std::byte> RecordingSource::bytes(const std::string& place) { return all<std::byte>(place); }

}  // namespace hapticut
