// SPDX-License-Identifier: Apache-2.0
#include "cli/reports/flag_words.hpp"

#include <cctype>
#include <string_view>

namespace hapticut::cli {
namespace {

struct FlagWords {
  std::string_view library, program;
};

// Longer texts stand before those that they begin with.
constexpr FlagWords kFlagWords[] = {
    {"MeshImport::large, VolumeBuildOptions::large", "--large"},
    {"PictureOptions::view_direction", "--picture_view"},
    {"RawLayout::dims", "--raw_dims"},
    {"RawLayout::skip", "--raw_skip_bytes"},
    {"RawLayout::type", "--raw_type"},
    {"UnclaimedLabels::leave_out", "--unclaimed_labels leave_out"},
    {"VolumeBuildOptions::crop", "--crop_mm"},
    {"VolumeReadOptions::dicom_series", "--dicom_series"},
    {"VolumeReadOptions::spacing", "--spacing_mm"},
    {"read_recording, or hapticut replay", "hapticut replay"},
    {", or read labels with read_color_slices", ""},
};

bool goes_on(std::string_view text, std::size_t at) {
  return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
}

}  // namespace

std::string in_words_of_flags(std::string message) {
  for (const FlagWords& words : kFlagWords)
    for (std::size_t at = 0; (at = message.find(words.library, at)) != std::string::npos;) {
      if (goes_on(message, at + words.library.size())) {
        at += words.library.size();
        continue;
      }
      message.replace(at, words.library.size(), words.program);
      at += words.program.size();
    }
  return message;
}

}  // namespace hapticut::cli
