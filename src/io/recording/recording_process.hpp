// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>

#include "io/child_process.hpp"
#include "io/recording/recording_source.hpp"

namespace hapticut {

extern const ChildProgram kRecordingReader;

/// Reads a recording through the program `hapticut-recording-reader`, so a malicious file can crash only that program.
/// The program runs as long as this object, unless the file crashes it; then all functions throw. Several threads may
/// call the functions; the calls run one after the other.
class RecordingProcess final : public RecordingSource {
 public:
  /// Opens a file.
  /// @param time_limit  maximum time of one reply
  /// @throws hdf5::Failure when HDF5 refuses the file, or the file crashes the program
  /// @throws Error when the program is missing
  RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                   std::chrono::nanoseconds time_limit = ChildProcess::kMaxReplyTime);

 private:
  std::string reply_to(const Query& query) override;

  ChildProcess process_;
  std::uint64_t memory_;        // [bytes] that the program may use
  std::uint64_t received_ = 0;  // [bytes] size of all replies
  std::mutex query_mutex_;
};

}  // namespace hapticut
