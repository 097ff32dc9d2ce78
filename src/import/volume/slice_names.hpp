// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

namespace hapticut {

/// The names of the slices of a folder. They tell which other files were meant to be slices: the empty or cut ones of a
/// copy that ended early, the unfinished ones of a download, links to files that were not fetched, slices in another
/// format.
class SliceNames {
 public:
  void add(const std::filesystem::path& slice);

  /// Whether a file has the name of a slice: the same name with another number, or the same extension; also with a
  /// further extension, unless that slice is there (s06.dcm.part is one, s00.dcm.json is not), or when iCloud has not
  /// downloaded it (.s06.dcm.icloud). A folder without extension is none: it is rather a folder of slices.
  [[nodiscard]] bool is_name_of_slice(const std::filesystem::path& file) const;

  /// Whether a picture in another format has the name of a missing slice: s06.bmp beside s05.png, but not s05.jpg.
  [[nodiscard]] bool is_slice_of_other_format(const std::filesystem::path& file) const;

  /// Whether the slices have no extension.
  [[nodiscard]] bool have_no_extension() const { return extensions_.contains(""); }

 private:
  std::set<std::string> names_, patterns_, extensions_, stems_, stem_patterns_;
};

/// Whether an entry of a folder may be a slice that was lost. Hidden files may not, but for the placeholders that
/// iCloud has in place of files: .s06.dcm.icloud.
[[nodiscard]] bool may_be_lost_slice(const std::filesystem::path& file);

/// An entry of a folder that should be a slice and is none.
struct NoSlice {
  std::string what;  ///< "it is empty", "it is a link to a file that is not there", "it is no " and a format
  std::string cure;  ///< a sentence; empty: the cure of the format
};

[[nodiscard]] NoSlice what_is_no_slice(const std::filesystem::path& file, const std::string& format);

/// A remark about folders in a folder of slices that have slices too, which are not read. Empty when there is none.
/// @param slices  what they contain: "DICOM files"
[[nodiscard]] std::string remark_on_subfolders(const std::filesystem::path& folder, const std::string& slices,
                                               const std::function<bool(const std::filesystem::path&)>& is_slice);

}  // namespace hapticut
