// SPDX-License-Identifier: Apache-2.0
#include "import/volume/slice_names.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>
#include <vector>

#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPlaceholder = ".icloud";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The name with `#` for each number, in lower case.
std::string pattern_of(const std::string& name) {
  std::string pattern;
  for (const char c : lower_case(name))
    if (!is_digit(c))
      pattern += c;
    else if (!pattern.ends_with('#'))
      pattern += '#';
  return pattern;
}

/// The extension in lower case; empty if it is a number, as at the end of a UID.
std::string extension_of(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  return extension.size() > 1 && !std::all_of(extension.begin() + 1, extension.end(), is_digit) ? extension : "";
}

/// The name without the extension.
std::string stem_of(const std::filesystem::path& file) {
  return (extension_of(file).empty() ? file.filename() : file.stem()).string();
}

bool is_placeholder(const std::string& name) {
  return name.size() > kPlaceholder.size() + 1 && name.starts_with('.') && name.ends_with(kPlaceholder);
}

/// The name of a file, also when iCloud has not downloaded it: "s06.dcm" of ".s06.dcm.icloud".
fs::path name_of(const fs::path& file) {
  const std::string name = file.filename().string();
  return is_placeholder(name) ? name.substr(1, name.size() - 1 - kPlaceholder.size()) : name;
}

}  // namespace

void SliceNames::add(const std::filesystem::path& slice) {
  const std::string name = slice.filename().string(), stem = stem_of(slice);
  names_.insert(name);
  patterns_.insert(pattern_of(name));
  extensions_.insert(extension_of(slice));
  stems_.insert(stem);
  stem_patterns_.insert(pattern_of(stem));
}

bool SliceNames::is_name_of_slice(const std::filesystem::path& file) const {
  const auto is_one = [&](const std::filesystem::path& name) {
    const std::string extension = extension_of(name);
    return patterns_.contains(pattern_of(name.string())) || (!extension.empty() && extensions_.contains(extension));
  };
  const std::filesystem::path name = name_of(file);
  std::error_code code;
  if (fs::is_directory(file, code)) return !extension_of(name).empty() && is_one(name);
  return is_one(name) || (is_one(name.stem()) && !names_.contains(name.stem().string()));
}

bool SliceNames::is_slice_of_other_format(const std::filesystem::path& file) const {
  static const std::set<std::string> kPictures = {".bmp", ".jpg",  ".jpeg", ".jp2",  ".gif", ".pgm",
                                                  ".png", ".webp", ".tif",  ".tiff", ".dcm", ".ima"};
  const fs::path name = name_of(file);
  const std::string stem = stem_of(name);
  return kPictures.contains(extension_of(name)) && stem_patterns_.contains(pattern_of(stem)) && !stems_.contains(stem);
}

bool may_be_lost_slice(const fs::path& file) {
  const std::string name = file.filename().string();
  return !name.starts_with('.') || is_placeholder(name);
}

NoSlice what_is_no_slice(const fs::path& file, const std::string& format) {
  std::error_code code;
  const fs::file_status status = fs::status(file, code);
  if (!fs::exists(status))
    return {"it is a link to a file that is not there",
            "Get that file (in a repository of git-annex or DataLad by 'git annex get')."};
  if (fs::is_directory(status)) return {"it is a folder", "Name it without the extension of a slice."};
  if (!fs::is_regular_file(status)) return {"it is a pipe or a device", "Put a copy of the slice in its place."};
  if (is_placeholder(file.filename().string()))
    return {"it is not downloaded yet from iCloud", "Download it in the Finder."};
  if (fs::file_size(file, code) == 0 && !code) return {"it is empty", "Get a complete copy of it."};
  if (!std::ifstream(file, std::ios::binary)) return {"it cannot be opened", "Check its permissions."};
  const std::string head = first_bytes(file, 200);
  if (std::string archive = archive_instead(head); !archive.empty()) return {std::move(archive), "Unpack it."};
  if (std::string other = not_the_file(head); !other.empty()) {
    other.pop_back();  // the full stop
    return {std::move(other), ""};
  }
  return {"it is no " + format, ""};
}

std::string remark_on_subfolders(const fs::path& folder, const std::string& slices,
                                 const std::function<bool(const fs::path&)>& is_slice) {
  std::vector<std::string> names;
  std::error_code code, ignored;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') || !entry.is_directory(ignored)) continue;
    for (const auto& file : fs::directory_iterator(entry.path(), ignored))
      if (std::error_code unknown; file.is_regular_file(unknown) && is_slice(file.path())) {
        names.push_back(name);
        break;
      }
  }
  if (names.empty()) return "";
  std::sort(names.begin(), names.end());
  return "'" + folder.string() + "' has " +
         (names.size() == 1
              ? "a folder with " + slices + " that is not read, '"
              : std::to_string(names.size()) + " folders with " + slices + " that are not read, the first is '") +
         names.front() + "'.";
}

}  // namespace hapticut
