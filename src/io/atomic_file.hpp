// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

#include "hapticut/core/errors.hpp"

/// @file
/// Writes files atomically: under a temporary name in the same folder, then renamed. No file is ever half-written.
namespace hapticut {

/// @throws Error that names the file and the reason
/// @param what  text before the file name: "the recording "
[[noreturn]] void cannot_write(const std::filesystem::path& path, const Sentence& reason, const std::string& what = "");

/// The file behind a symbolic link: the link stays, and its target is replaced, or made if it is missing.
[[nodiscard]] std::filesystem::path place_behind_links(const std::filesystem::path& path);

/// A file being written. Write to `temporary_path()`; `commit()` moves it to `path`. Without a commit, the destructor
/// removes the temporary file and an existing file at `path` stays. A killed program leaves its temporary file; the
/// next write into the same folder removes it.
class AtomicFile {
 public:
  /// @throws Error when the folder does not exist or is not writable, when `path` exists and is not a regular file (a
  ///         folder, a device), or when a recorder is still writing to it
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The path to write to: same folder and extension as the final path.
  [[nodiscard]] const std::filesystem::path& temporary_path() const { return temporary_path_; }

  /// Flushes the data to the disk and renames the file.
  /// @throws Error when either fails, or a recorder has begun to write to the file at `path`
  void commit();

  /// As `commit`, but an existing file is not replaced.
  /// @throws Error when there is one, as well
  void commit_new();

 private:
  void flush() const;
  std::filesystem::path path_;
  std::filesystem::path temporary_path_;
  bool committed_ = false;
};

/// Writes a whole file through a checked stream. A failed write throws an Error with the file name and the reason, and
/// an existing file at `path` stays.
/// @param write  receives a binary stream that throws std::ios_base::failure when writing fails
void write_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
/// Writes bytes in memory as a whole file.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace hapticut
