// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>

#include "io/child_process.hpp"
#include "io/recording/recording_source.hpp"

namespace hapticut {

/// Reads a recording through the program `hapticut-recording-reader`, so a malicious file can crash only that program.
/// The program runs as long as this object, unless the file crashes it; then all functions throw. Several threads may
/// call the functions; the calls run one after the other.
class RecordingProcess final : public RecordingSource {
 public:
  static constexpr std::chrono::seconds kMaxReplyTime{20};

  /// Opens a file.
  /// @param time_limit  maximum time of one reply
  /// @throws hdf5::Failure when HDF5 refuses the file, or the file crashes the program
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
