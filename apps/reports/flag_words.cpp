// SPDX-License-Identifier: Apache-2.0
#include "reports/flag_words.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "hapticut/core/errors.hpp"
#include "settings/names.hpp"

namespace hapticut::apps {
namespace {

struct Word {
  std::string_view name, program;  // program is empty if users of the program do not have it
};

/// Names without a setting of scenes, and settings whose flag needs a hint at its text.
constexpr Word kWords[] = {
    {"ContactTime::end", ""},
    {"CouplingGains", "--coupling none"},
    {"DeviceCapabilities::output_degrees_of_freedom", ""},
    {"DeviceCapabilities::peak_force", ""},
    {"DeviceCapabilities::stiffness", ""},
    {"GuardOptions::period", "the period of --rate"},
    {"OutputLimits", ""},
    {"PictureOptions::up", "z"},
    {"PictureOptions::view_direction", "--picture_view"},
    {"PlaybackRange", ""},
    {"ProfileEdge::kind", "the column kind"},
    {"ReplayOptions::law", "--law"},
    {"RunOptions::simulated_time", "--simulated_time"},
    {"SetScale::scale", "--scale"},
    {"SimulationConfig::contact_time", ""},
    {"SimulationModelOptions::coupling", "--coupling virtual"},
    {"SimulationModelOptions::coupling.angular_stiffness", "the angular stiffness of the coupling"},
    {"SimulationModelOptions::coupling.stiffness", "the stiffness of the coupling"},
    {"UnclaimedLabels::leave_out", "--unclaimed_labels leave_out"},
    {"VolumeBuildOptions::crop_samples", ""},
    {"VolumeBuildOptions::warn", ""},
    {"WorkspaceMapOptions::scale", "--scale"},
    {"coupling_gains", ""},
    {"loop.origin_mm", "--origin_mm"},
    {"output.record", "--record"},
    {"read_color_slices", ""},
    {"read_recording", "hapticut replay"},
    {"units::rpm", ""},
    {"workpiece.layers", "--layer MATERIAL=THICKNESS_MM"},
    {"workpiece.shells", "--shell MATERIAL=OBJECT"},
};

std::optional<std::string> word_for(const Name& name) {
  if (const auto* const word = std::ranges::find(kWords, name.text(), &Word::name); word != std::end(kWords))
    return word->program.empty() ? std::nullopt : std::optional(std::string(word->program));
  const std::optional<std::string_view> key = settings::key_of(name);
  return key ? settings::flag_of(*key) : std::nullopt;
}

}  // namespace

std::string in_words_of_flags(const Sentence& sentence) { return sentence.written(word_for); }

std::string in_words_of_flags(const std::exception& error) {
  const auto* const of_library = dynamic_cast<const Error*>(&error);
  return of_library == nullptr ? error.what() : in_words_of_flags(of_library->sentence());
}

}  // namespace hapticut::apps
