// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

/// @file
/// Writing files so that nothing is ever half-written: under a temporary name in the same folder, then renamed.
namespace hapticut {

/// @throws Error that names the file and the reason
/// @param what  in front of its name: "the recording "
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& reason,
                               const std::string& what = "");

/// Where a file of this name really is: a link stays, and what it names is replaced.
[[nodiscard]] std::filesystem::path place_behind_links(const std::filesystem::path& path);

/// A file being written. Write to `temporary_path()`; `commit()` puts it in place. Without a commit the
/// temporary file is removed and what was at `path` before is still there. A program that is killed leaves it, and the
/// next file that is written into the same folder removes it.
class AtomicFile {
 public:
  /// @throws Error when the folder does not exist or cannot be written to, or when `path` is something else than a
  /// regular file (a folder, a device)
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write: same folder and same extension as the final path.
  [[nodiscard]] const std::filesystem::path& temporary_path() const { return temporary_path_; }

  /// Makes sure that the data is on the disk and renames.
  /// @throws Error when either fails
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_path_;
  bool committed_ = false;
};

/// Writes a whole file through a checked stream: every failed write becomes an Error that names the file and the
/// reason, and leaves what was at `path` before.
/// @param write  is given a binary stream that throws std::ios_base::failure when writing fails
void write_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
/// The same of bytes that are in memory.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace hapticut
