// SPDX-License-Identifier: Apache-2.0
#include "io/file_errors.hpp"

#include <algorithm>
#include <fstream>

namespace hapticut {

std::uint64_t readable_size(const std::filesystem::path& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) cannot_read(path, "there is no such file.");
  if (std::filesystem::is_directory(status)) cannot_read(path, "it is a folder; name a file.");
  if (!std::filesystem::is_regular_file(status)) cannot_read(path, "it is not a regular file.");
  if (first_bytes(path, kGitLfsPointer.size()) == kGitLfsPointer)
    cannot_read(
        path,
        "it is a Git LFS pointer, a text in place of the file; run 'git lfs pull' in its repository, or download "
        "the file itself.");
  if (!std::ifstream(path, std::ios::binary)) cannot_read(path, "it cannot be opened; check its permissions.");
  const auto size = std::filesystem::file_size(path, code);
  if (code) cannot_read(path, code.message() + ".");
  if (size == 0) cannot_read(path, "it is empty. Get a complete copy.");
  return size;
}

std::string first_bytes(const std::filesystem::path& path, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(count, '\0');
  file.read(bytes.data(), std::streamsize(count));
  bytes.resize(std::size_t(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

std::string bytes_of_file(const std::filesystem::path& path) {
  const auto size = std::size_t(readable_size(path));
  std::string bytes = first_bytes(path, size);
  if (bytes.size() != size) cannot_read(path, "reading failed before its end; check the disk.");
  return bytes;
}

}  // namespace hapticut
