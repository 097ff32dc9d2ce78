// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>

#include "io/child_process.hpp"
#include "io/recording/recording_source.hpp"

namespace hapticut {

/// A recording that the program `hapticut-recording-reader` reads: what HDF5 does to a file that was made to hurt, it
/// does to that program. The program runs as long as this object lives, or until it dies of the file; then all
/// functions throw. It may be asked from several threads, one after the other.
class RecordingProcess final : public RecordingSource {
 public:
  static constexpr std::chrono::seconds kMaxReplyTime{20};

  /// Opens a file.
  /// @param time_limit  how long it may take over one reply
  /// @throws hdf5::Failure when HDF5 refuses it, or the program dies of it
  /// @throws Error when the program is missing
  RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                   std::chrono::nanoseconds time_limit = kMaxReplyTime);

 private:
  std::string reply_to(const Query& query, const std::string& place, const std::string& name) override;
  void receive(char* bytes, std::size_t count);
  [[noreturn]] void die();

  std::chrono::nanoseconds time_limit_, time_left_{0};
  ChildProcess process_;
  std::mutex query_mutex_;
};

}  // namespace hapticut
