// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "io/recording/hdf5.hpp"
#include "io/recording/recording_source.hpp"

namespace hapticut {

/// Reads a recording with HDF5 in this process, which a damaged file can crash. Part of the reader program, not of the
/// library: see RecordingProcess.
class Hdf5Source final : public RecordingSource {
 public:
  Hdf5Source(hdf5::File file, std::uint64_t file_size) : RecordingSource(file_size), file_(std::move(file)) {}
  ~Hdf5Source() override;

  std::string reply_to(const Query& query) override;

 private:
  /// A group inside the file; throws where HDF5 would follow a link.
  hdf5::Group group_at(const std::string& place) const;
  /// The group that contains a place.
  hdf5::Group parent_group_of(const std::string& place) const;
  /// A group, a data set or the file.
  hdf5::Object object_at(const std::string& place) const;
  hid_t data_set_at(const std::string& place);
  [[nodiscard]] std::string layout_at(const std::string& place);
  [[nodiscard]] std::string block_of(const Query& query);

  hdf5::File file_;
  std::map<std::string, hdf5::DataSet> data_sets_;  ///< open data sets
};

/// @throws hdf5::Failure when the file is not a recording or cannot be opened
[[nodiscard]] std::unique_ptr<Hdf5Source> open_hdf5_file(const std::filesystem::path& path);

}  // namespace hapticut
