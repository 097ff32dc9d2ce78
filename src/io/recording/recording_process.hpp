// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>

#include "io/child_process.hpp"
#include "io/recording/recording_messages.hpp"
#include "io/recording/recording_source.hpp"

namespace hapticut {

/// A recording that the program `hapticut-recording-reader` reads: what HDF5 does to a file that was made to hurt, it
/// does to that program. The program runs as long as this object lives, or until it dies of the file; then all
/// functions throw. It may be asked from several threads, one after the other.
class RecordingProcess final : public RecordingSource {
 public:
  static constexpr std::chrono::seconds kPatience{20};

  /// Opens a file.
  /// @param patience  how long it may take over one answer
  /// @throws hdf5::Failure when HDF5 refuses it, or the program dies of it
  /// @throws Error when the program is missing
  RecordingProcess(const std::filesystem::path& path, std::uint64_t file_size,
                   std::chrono::nanoseconds patience = kPatience);

  [[nodiscard]] bool exists(const std::string& place) override;
  [[nodiscard]] bool has_attribute(const std::string& place, const std::string& name) override;
  [[nodiscard]] std::string text_attribute(const std::string& place, const std::string& name) override;
  [[nodiscard]] std::uint64_t number_attribute(const std::string& place, const std::string& name) override;
  [[nodiscard]] std::string text(const std::string& place) override;
  [[nodiscard]] DataSetLayout layout(const std::string& place) override;

 private:
  void block(const std::string& place, ColumnKind kind, std::uint64_t numbers, std::uint64_t first, std::uint64_t count,
             std::byte* bytes) override;

  /// @return the length of the content, which is to be received
  std::uint64_t ask(const Question& question, const std::string& place, const std::string& name);
  [[nodiscard]] std::string ask_short(Ask what, const std::string& place, const std::string& name = "");
  [[nodiscard]] bool ask_whether(Ask what, const std::string& place, const std::string& name = "");
  void receive(char* bytes, std::size_t count);
  [[noreturn]] void die();

  std::chrono::nanoseconds patience_, left_{0};
  ChildProcess process_;
  std::mutex one_question_;
};

}  // namespace hapticut
