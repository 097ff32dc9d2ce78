// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "hapticut/core/errors.hpp"

namespace hapticut {

/// Reserves the disk space of a growing file in advance, for writers that cannot recover from a full disk. The
/// destructor frees the space beyond the end of the file.
class DiskSpace {
 public:
  /// The disk is full, or the file cannot be opened; with the system's message.
  class Shortage : public Error {
   public:
    using Error::Error;
  };

  /// @throws Shortage
  explicit DiskSpace(const std::filesystem::path& path);
  ~DiskSpace();
  DiskSpace(const DiskSpace&) = delete;
  DiskSpace& operator=(const DiskSpace&) = delete;

  /// Ensures that the file can grow to a length.
  /// @throws Shortage
  void require(std::uint64_t length);

 private:
  int file_;
  std::uint64_t safe_ = 0;  // [bytes] reserved length
};

}  // namespace hapticut
