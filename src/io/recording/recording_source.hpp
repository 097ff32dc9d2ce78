// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "io/recording/recording_messages.hpp"
#include "io/value_types.hpp"

namespace hapticut {

namespace hdf5 {

/// Something that HDF5 refused, in its own words.
class Failure : public Error {
 public:
  using Error::Error;
};

}  // namespace hdf5

/// What a data set says of itself.
struct DataSetLayout {
  bool is_real = false;              ///< else its numbers are whole
  std::vector<std::uint64_t> shape;  ///< lengths along its dimensions; empty: one number
};

/// What a reader of recordings asks of an HDF5 file. The file may have been made to hurt, so everything in it is asked
/// for by its place, "" for the file itself, "steps/dt" for a data set, and what comes back is plain.
///
/// All functions throw hdf5::Failure, without the name of the file, when something is missing or of another kind.
class RecordingSource {
 public:
  /// @param file_size  [bytes]
  explicit RecordingSource(std::uint64_t file_size) : file_size_(file_size) {}
  virtual ~RecordingSource() = default;
  RecordingSource(const RecordingSource&) = delete;
  RecordingSource& operator=(const RecordingSource&) = delete;

  [[nodiscard]] bool exists(const std::string& place);
  [[nodiscard]] bool has_attribute(const std::string& place, const std::string& name);
  [[nodiscard]] std::string text_attribute(const std::string& place, const std::string& name);
  [[nodiscard]] std::uint64_t number_attribute(const std::string& place, const std::string& name);
  [[nodiscard]] std::string text(const std::string& place);      ///< a data set that is a text
  [[nodiscard]] DataSetLayout layout(const std::string& place);  ///< of a data set of numbers

  /// Rows of a data set, one after the other.
  /// @param kind     what its numbers become
  /// @param numbers  of one row
  void rows(const std::string& place, ValueType kind, std::uint64_t numbers, std::uint64_t first, std::uint64_t count,
            std::vector<std::byte>& bytes);

  /// All numbers of a data set.
  [[nodiscard]] std::vector<double> reals(const std::string& place);
  [[nodiscard]] std::vector<std::uint64_t> whole_numbers(const std::string& place);
  [[nodiscard]] std::vector<std::byte> bytes(const std::string& place);

 protected:
  /// @return the content that `QueryKind` tells of
  virtual std::string reply_to(const Query& query, const std::string& place, const std::string& name) = 0;

 private:
  [[nodiscard]] std::string ask(QueryKind what, const std::string& place, const std::string& name = "");
  template <class Number>
  [[nodiscard]] std::vector<Number> all(const std::string& place);

  std::uint64_t file_size_;
};

/// The last part of a place: what messages call it.
[[nodiscard]] std::string name_at(const std::string& place);

/// @throws hdf5::Failure when a file of this size cannot hold so much
void require_size_in_file(double bytes, std::uint64_t file_size, const std::string& name);

/// @throws hdf5::Failure that the program that reads the file died of it, hangs or makes no sense
[[noreturn]] void fail_in_reader();

}  // namespace hapticut
