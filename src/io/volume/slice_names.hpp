// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace hapticut {

/// The names of the slices of a folder. They tell which other files were meant to be slices: the empty or cut ones of a
/// copy that ended early, the unfinished ones of a download, slices in another format.
class SliceNames {
 public:
  void add(const std::filesystem::path& slice);

  /// Whether a file has the name of a slice: the same name with another number, or the same extension; also with a
  /// further extension, unless that slice is there (s06.dcm.part is one, s00.dcm.json is not).
  [[nodiscard]] bool is_name_of_slice(const std::filesystem::path& file) const;

  /// Whether a picture in another format has the name of a missing slice: s06.bmp beside s05.png, but not s05.jpg.
  [[nodiscard]] bool is_slice_of_other_format(const std::filesystem::path& file) const;

  /// Whether the slices have no extension.
  [[nodiscard]] bool have_no_extension() const { return extensions_.contains(""); }

 private:
  std::set<std::string> names_, patterns_, extensions_, stems_, stem_patterns_;
};

/// What a file is that should be a slice: "it is empty", "it is compressed by gzip" or "it is no " and a format.
[[nodiscard]] std::string what_is_no_slice(const std::filesystem::path& file, const std::string& format);

}  // namespace hapticut
