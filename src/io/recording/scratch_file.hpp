// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut {

/// A file of our own in the folder for temporary files, removed afterwards.
class ScratchFile {
 public:
  /// @param extension  ".vdb"
  /// @throws Error when it cannot be made
  explicit ScratchFile(const std::string& extension) {
    std::string pattern = (std::filesystem::temp_directory_path() / ("hapticut-XXXXXX" + extension)).string();
    const int file = ::mkstemps(pattern.data(), int(extension.size()));
    if (file < 0) throw Error("cannot make the temporary file '" + pattern + "'; set TMPDIR to a folder with room.");
    ::close(file);
    path_ = pattern;
  }
  ~ScratchFile() { ::unlink(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hapticut
