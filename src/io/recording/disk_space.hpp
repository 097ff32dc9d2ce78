// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "hapticut/core/errors.hpp"

namespace hapticut {

/// Asks for the disk space of a growing file before it is needed, for writers that cannot recover from a full disk.
/// What was asked for beyond the end of the file is given back at the end.
class DiskSpace {
 public:
  /// There is no room, or the file cannot be opened; in the words of the system.
  class Shortage : public Error {
   public:
    using Error::Error;
  };

  /// @throws Shortage
  explicit DiskSpace(const std::filesystem::path& path);
  ~DiskSpace();
  DiskSpace(const DiskSpace&) = delete;
  DiskSpace& operator=(const DiskSpace&) = delete;

  /// Makes sure that the file can become so long.
  /// @throws Shortage
  void require(std::uint64_t length);

 private:
  int file_;
  std::uint64_t safe_ = 0;  // [bytes] length
};

}  // namespace hapticut
