// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

#include "hapticut/core/errors.hpp"

namespace hapticut::view {

/// A file of the page, as read at the start of the server.
struct PageFile {
  static constexpr const char* kData = "application/octet-stream";
  const char* type = kData;
  std::string content;

  /// Whether it is data that the page shows, rather than a part of the page.
  [[nodiscard]] bool is_data() const { return type == kData; }
};

inline constexpr std::uintmax_t kMaxPageBytes = 64U << 20U;

inline const char* type_of_file(const std::filesystem::path& path) {
  static constexpr std::pair<const char*, const char*> kTypes[] = {{".html", "text/html; charset=utf-8"},
                                                                   {".js", "text/javascript; charset=utf-8"},
                                                                   {".css", "text/css; charset=utf-8"},
                                                                   {".json", "application/json"},
                                                                   {".svg", "image/svg+xml"},
                                                                   {".png", "image/png"},
                                                                   {".wasm", "application/wasm"},
                                                                   {".ico", "image/x-icon"}};
  for (const auto& [extension, type] : kTypes)
    if (path.extension() == extension) return type;
  return PageFile::kData;
}

/// Reads all files of a folder, by the path of a request. The server serves only these files, so no request can leave
/// the folder. Links are not followed.
/// @throws Error when the folder has no index.html, cannot be read, or is larger than kMaxPageBytes
inline std::map<std::string, PageFile, std::less<>> read_page_files(const std::filesystem::path& folder) {
  std::map<std::string, PageFile, std::less<>> files;
  if (folder.empty()) return files;
  const auto refuse = [&](const std::string& why) {
    throw Error("the page in '" + folder.string() + "' cannot be served: " + why);
  };
  std::error_code error;
  std::uintmax_t bytes = 0;
  std::filesystem::recursive_directory_iterator entry(folder, error), end;
  if (error) refuse(error.message() + ". Give the folder of the built page.");
  for (; entry != end; entry.increment(error)) {
    if (error) refuse(error.message() + ".");
    if (entry->is_symlink() || !entry->is_regular_file()) continue;
    bytes += entry->file_size();
    if (bytes > kMaxPageBytes) refuse("it has more than 64 MB. Give a folder that has only the page.");
    std::ifstream stream(entry->path(), std::ios::binary);
    PageFile file{type_of_file(entry->path()), std::string(std::istreambuf_iterator<char>(stream), {})};
    if (!stream) refuse("'" + entry->path().string() + "' cannot be read.");
    files["/" + std::filesystem::relative(entry->path(), folder).generic_string()] = std::move(file);
  }
  const auto index = files.find("/index.html");
  if (index == files.end()) refuse("it has no index.html. Build the page, or give the folder of the built page.");
  files["/"] = index->second;
  return files;
}

}  // namespace hapticut::view
