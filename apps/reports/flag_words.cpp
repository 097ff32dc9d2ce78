// SPDX-License-Identifier: Apache-2.0
#include "reports/flag_words.hpp"

#include <cctype>
#include <string_view>

namespace hapticut::cli {
namespace {

struct FlagWords {
  std::string_view library, program;
};

// A longer text must precede its own prefix.
constexpr FlagWords kFlagWords[] = {
    {"Give ProfileHead a larger tolerance, or the profile fewer small edges", "Give the profile fewer small edges"},
    {"GuardOptions::period", "the period of --rate"},
    {"MeshImport::large, VolumeBuildOptions::large", "--large"},
    {"MeshImport::voxel_size", "--voxel-mm"},
    {"PictureOptions::view_direction and up must be finite, not zero and not parallel",
     "--picture_view must be finite, not zero and not along z"},
    {"ProfileEdge::kind", "the column kind"},
    {"RawLayout::dims", "--raw_dims"},
    {"RawLayout::skip", "--raw_skip_bytes"},
    {"RawLayout::type", "--raw_type"},
    {"ReplayOptions::law", "--law"},
    {"a file cannot store a law; pass the same law to the replay",
     "a file cannot store a law; name the same law: hapticut replay FILE --law NAME"},
    {"SetScale::scale", "--scale"},
    {"Shank::neck_diameter", "--shank-neck-mm"},
    {"SimulationConfig::quadrature", "--quadrature"},
    {"SimulationConfig::voxel_budget", "--voxel-budget"},
    {"SimulationModelOptions::coupling with contact_time = end", "--coupling virtual"},
    {"UnclaimedLabels::leave_out", "--unclaimed_labels leave_out"},
    {"VdbImport::grid", "--grid"},
    {"VdbImport::kind", "--grid-kind"},
    {"VdbImport::material", "--material"},
    {"VolumeBuildOptions::crop", "--crop_mm"},
    {"VolumeReadOptions::dicom_series", "--dicom_series"},
    {"VolumeReadOptions::spacing", "--spacing_mm"},
    {"WorkspaceMapOptions::scale", "--scale"},
    {"large = true", "--large"},
    {"leave RunOptions::simulated_time false", "leave --simulated-time out"},
    {"so no coupling can be chosen for it; set CouplingGains", "so choose --coupling none"},
    {"; open a part of it with open_playback and a PlaybackRange", "; record a shorter one"},
    {"use read_recording", "use hapticut replay"},
    {"unit (unit_mm of read_mesh)", "unit (--unit-mm)"},
    {"unit (unit_mm)", "unit (--unit-mm)"},
    {"unit_mm =", "--unit-mm"},
    {"voxels by voxel_mm", "voxels by --voxel-mm"},
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
