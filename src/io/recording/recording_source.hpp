// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "io/recording/recording_messages.hpp"

namespace hapticut {

namespace hdf5 {

/// A failure of HDF5, with its message.
class Failure : public Error {
 public:
  explicit Failure(Sentence sentence, Fault fault = Fault::part) : Error(std::move(sentence)), fault_(fault) {}
  [[nodiscard]] Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

}  // namespace hdf5

/// Type and shape of a data set.
struct DataSetLayout {
  bool is_real = false;              ///< true: real numbers, false: whole numbers
  std::vector<std::uint64_t> shape;  ///< lengths along its dimensions; empty: one number
};

/// Access to the content of an HDF5 file for the reader of recordings. The file may be malicious, so all content is
/// queried by its place ("" for the file itself, "steps/dt" for a data set) and returned as plain data.
///
/// All functions throw hdf5::Failure, without the file name, when the content is missing or of another kind.
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
  [[nodiscard]] std::string text(const std::string& place);      ///< content of a text data set
  [[nodiscard]] DataSetLayout layout(const std::string& place);  ///< layout of a data set of numbers

  /// Reads rows of a data set.
  /// @param kind     type of the returned numbers
  /// @param numbers  numbers per row
  void rows(const std::string& place, ValueType kind, std::uint64_t numbers, std::uint64_t first, std::uint64_t count,
            std::vector<std::byte>& bytes);

  /// All numbers of a data set.
  [[nodiscard]] std::vector<double> reals(const std::string& place);
  [[nodiscard]] std::vector<std::uint64_t> whole_numbers(const std::string& place);
  [[nodiscard]] std::vector<std::byte> bytes(const std::string& place);

 protected:
  /// @return the content that `QueryKind` describes
  virtual std::string reply_to(const Query& query) = 0;

 private:
  template <class Number>
  [[nodiscard]] std::vector<Number> all(const std::string& place);

  std::uint64_t file_size_;
};

/// The last part of a place, used in messages.
[[nodiscard]] std::string name_at(const std::string& place);

/// @throws hdf5::Failure when a file of this size cannot contain so many bytes
void require_size_in_file(double bytes, std::uint64_t file_size, const std::string& name);

/// @throws hdf5::Failure that says: the reader program crashed, hung or sent an invalid reply
[[noreturn]] void fail_in_reader();

}  // namespace hapticut
