// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>

/// @file
/// Marks files that grow for a long time, so that no second writer takes them.
namespace hapticut {

/// The mark of a writer on its file: a lock of the operating system. It ends with its process, however that ends, so a
/// killed program leaves no mark. It is on the file, whatever name or link leads there, and goes with it when it is
/// renamed. Reading is not affected. File systems of a network (NFS, SMB) have no such mark.
class WriterLock {
 public:
  WriterLock() = default;
  /// @param path  of a new file, which nobody else writes
  /// @throws Error when it cannot be opened
  explicit WriterLock(const std::filesystem::path& path);
  ~WriterLock() { release(); }
  WriterLock(WriterLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  WriterLock& operator=(WriterLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  void release() noexcept;

 private:
  int file_ = -1;
};

/// Whether a WriterLock of this or another process is on a file; false when there is no file.
[[nodiscard]] bool has_writer_lock(const std::filesystem::path& path) noexcept;

/// Removes a file that a killed writer has left, if there is one.
/// @return false: a WriterLock of this or another process is on the file, which stays
[[nodiscard]] bool remove_left_file(const std::filesystem::path& path) noexcept;

/// @param what  text before the file name: "the recording "
/// @throws Error  always
[[noreturn]] void refuse_second_writer(const std::filesystem::path& path, const std::string& what = "");

}  // namespace hapticut
