// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_source.hpp"

#include <algorithm>
#include <cstring>

namespace hapticut {
namespace {

constexpr std::uint64_t kBlock = 8 << 20;  // [bytes] that are asked for at once

template <class Number>
std::vector<Number> numbers_of(const std::vector<std::byte>& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

}  // namespace

std::size_t bytes_of(ColumnKind kind) noexcept {
  return with_number_of(kind, [](auto number) { return sizeof number; });
}

std::string name_at(const std::string& place) { return place.substr(place.rfind('/') + 1); }

void require_room(double bytes, std::uint64_t file_size, const std::string& name) {
  constexpr double kBestOfDeflate = 1032;  // times smaller
  if (bytes > kBestOfDeflate * double(file_size))
    throw hdf5::Failure("its '" + name + "' claims " + format_number(bytes) + " bytes, more than the file can hold");
}

void RecordingSource::rows(const std::string& place, ColumnKind kind, std::uint64_t numbers, std::uint64_t first,
                           std::uint64_t count, std::vector<std::byte>& bytes) {
  const std::uint64_t row = numbers * bytes_of(kind);
  require_room(double(numbers) * double(bytes_of(kind)) * double(count), file_size_, name_at(place));
  bytes.resize(count * row);
  if (bytes.empty()) return;
  const std::uint64_t at_once = std::max<std::uint64_t>(1, kBlock / row);
  for (std::uint64_t done = 0; done < count; done += at_once)
    block(place, kind, numbers, first + done, std::min(at_once, count - done), bytes.data() + done * row);
}

std::vector<std::byte> RecordingSource::all(const std::string& place, ColumnKind kind) {
  const std::vector<std::uint64_t> shape = layout(place).shape;
  double total = 1;  // whose product does not run over
  for (const std::uint64_t length : shape) total *= double(length);
  require_room(total * double(bytes_of(kind)), file_size_, name_at(place));
  std::uint64_t numbers = 1;
  for (std::size_t n = 1; n < shape.size(); ++n) numbers *= shape[n];
  std::vector<std::byte> result;
  if (total > 0) rows(place, kind, numbers, 0, shape.empty() ? 1 : shape[0], result);
  return result;
}

std::vector<double> RecordingSource::reals(const std::string& place) {
  return numbers_of<double>(all(place, ColumnKind::real));
}
std::vector<std::uint64_t> RecordingSource::whole_numbers(const std::string& place) {
  return numbers_of<std::uint64_t>(all(place, ColumnKind::uint64));
}
std::vector<std::byte> RecordingSource::bytes(const std::string& place) { return all(place, ColumnKind::flag); }

}  // namespace hapticut
