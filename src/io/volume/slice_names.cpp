// SPDX-License-Identifier: Apache-2.0
#include "io/volume/slice_names.hpp"

#include <algorithm>
#include <cctype>

#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

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

}  // namespace

void SliceNames::add(const std::filesystem::path& slice) {
  const std::string name = slice.filename().string(), stem = slice.stem().string();
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
  const std::filesystem::path name = file.filename();
  return is_one(name) || (is_one(name.stem()) && !names_.contains(name.stem().string()));
}

bool SliceNames::is_slice_of_other_format(const std::filesystem::path& file) const {
  static const std::set<std::string> kPictures = {".bmp", ".jpg", ".jpeg", ".jp2", ".gif", ".pgm", ".webp", ".dcm"};
  const std::string stem = file.stem().string();
  return kPictures.contains(extension_of(file)) && stem_patterns_.contains(pattern_of(stem)) && !stems_.contains(stem);
}

std::string what_is_no_slice(const std::filesystem::path& file, const std::string& format) {
  std::error_code code;
  if (std::filesystem::file_size(file, code) == 0 && !code) return "it is empty";
  if (first_bytes(file, 2) == "\x1f\x8b") return "it is compressed by gzip";
  return "it is no " + format;
}

}  // namespace hapticut
