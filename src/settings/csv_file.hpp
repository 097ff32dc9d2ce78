// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "settings/setting.hpp"

namespace hapticut::settings {

/// The lines of a CSV file that a user wrote: a line of column names, then lines of as many cells. Empty lines and
/// those that begin with # are skipped, as are spaces around a cell and the mark that some programs put before the
/// first line of a file in UTF-8.
class CsvFile {
 public:
  /// @param what  what the file is, and where its name was given: "file of poses", "--poses"
  /// @throws Error when it cannot be read
  CsvFile(const std::filesystem::path& path, const std::string& what, const std::string& flag) : name_(path.string()) {
    std::error_code error;
    auto file = std::make_unique<std::ifstream>();
    // Not opened before: a pipe would be waited for, and a device read for ever.
    if (std::filesystem::is_regular_file(path, error)) file->open(path);
    if (!file->is_open())
      throw Error(name_ + ": this " + what + " cannot be read. Check the name given to " + flag + ".");
    stream_ = std::move(file);
  }

  /// The same of a text.
  /// @param name  in messages, where that of a file would be
  CsvFile(std::string text, std::string name)
      : name_(std::move(name)), stream_(std::make_unique<std::istringstream>(std::move(text))) {}

  /// The cells of the next line; false: there is none.
  /// @throws Error when they are not as many as in the first line
  bool next(std::vector<std::string>& cells) {
    for (std::string line; std::getline(*stream_, line);) {
      if (++line_ == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
      line = trimmed(line);
      if (line.empty() || line.front() == '#') continue;
      cells = split(line, ',');
      std::transform(cells.begin(), cells.end(), cells.begin(), trimmed);
      if (columns_ == 0) columns_ = cells.size();
      if (cells.size() != columns_)
        fail(std::to_string(cells.size()) + " values; there must be " + std::to_string(columns_) +
             ", as in the first line.");
      return true;
    }
    return false;
  }

  /// @throws Error that begins with file and line
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(name_ + ":" + std::to_string(line_) + ": " + message);
  }

 private:
  static constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

  static std::string trimmed(const std::string& text) {
    constexpr const char* kSpace = " \t\r";
    const std::size_t first = text.find_first_not_of(kSpace);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
  }

  std::string name_;
  std::unique_ptr<std::istream> stream_;
  int line_ = 0;
  std::size_t columns_ = 0;
};

}  // namespace hapticut::settings
