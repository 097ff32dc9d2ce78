// SPDX-License-Identifier: Apache-2.0
#include "io/file_errors.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>
#include <utility>

namespace hapticut {

std::string not_the_file(std::string_view head) {
  if (head.starts_with(kGitLfsPointer))
    return "it is a Git LFS pointer, a text in place of the file; run 'git lfs pull' in its repository, or download "
           "the file itself.";
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  const auto begins_with = [&](std::string_view tag) {
    return head.size() > tag.size() && std::equal(tag.begin(), tag.end(), head.begin(), [](char of_tag, char c) {
             return of_tag == std::tolower(static_cast<unsigned char>(c));
           });
  };
  if (begins_with("<!doctype html") || begins_with("<html") || begins_with("<head"))
    return "it is a web page in place of the file: a download went wrong, so download the file itself.";
  return "";
}

std::string archive_instead(std::string_view head) {
  constexpr std::pair<std::string_view, std::string_view> kArchives[] = {{"\x1f\x8b", "a gzip"},
                                                                         {"PK\x03\x04", "a ZIP"},
                                                                         {"BZh", "a bzip2"},
                                                                         {"\xfd\x37zXZ", "an xz"},
                                                                         {"\x28\xb5\x2f\xfd", "a Zstandard"},
                                                                         {"7z\xbc\xaf\x27\x1c", "a 7-Zip"},
                                                                         {"Rar!", "a RAR"}};
  for (const auto& [begin, name] : kArchives)
    if (head.starts_with(begin)) return "it is " + std::string(name) + " archive";
  return "";
}

bool is_missing(const std::filesystem::path& path) {
  std::error_code code;
  return std::filesystem::status(path, code).type() == std::filesystem::file_type::not_found;
}

std::string unreachable(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::status(path, code).type() != std::filesystem::file_type::none) return "";
  if (code == std::errc::permission_denied)
    return "a folder on the way to it cannot be entered; check the permissions of its folders.";
  if (code == std::errc::too_many_symbolic_link_levels)
    return "it is a symbolic link that leads back to itself; name the file.";
  return code.message() + ".";
}

std::uint64_t readable_size(const std::filesystem::path& path) {
  if (const std::string reason = unreachable(path); !reason.empty()) cannot_read(path, reason);
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) cannot_read(path, "there is no such file.");
  if (std::filesystem::is_directory(status)) cannot_read(path, "it is a folder; name a file.");
  if (!std::filesystem::is_regular_file(status)) cannot_read(path, "it is not a regular file.");
  constexpr std::size_t kHead = 200;  // [bytes]
  if (const std::string other = not_the_file(first_bytes(path, kHead)); !other.empty()) cannot_read(path, other);
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
