// SPDX-License-Identifier: Apache-2.0
#include "c/words_of_c.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

#include "hapticut/core/description.hpp"
#include "hapticut/loop/commands.hpp"
#include "loop/command_ranges.hpp"
#include "settings/names.hpp"

namespace hapticut::c {
namespace {

struct Word {
  std::string_view name, c;  // c is empty if callers of C do not have it
};

/// Names without a setting of scenes.
constexpr Word kWords[] = {
    {"ContactTime::end", "1"},
    {"CouplingGains", "hapticut_loop_options.stiffness"},
    {"DeviceCapabilities::output_degrees_of_freedom", ""},
    {"DeviceCapabilities::peak_force", ""},
    {"DeviceCapabilities::stiffness", "hapticut_loop_options.stiffness"},
    {"GuardOptions::period", "simulation.rate_Hz of the scene, as a period"},
    {"HeatConfig::by_material.conductivity", "hapticut_thermal_properties.conductivity"},
    {"HeatConfig::by_material.heat_capacity", "hapticut_thermal_properties.heat_capacity"},
    {"HeatConfig::voxels_per_cell", "hapticut_heat_config.voxels_per_cell"},
    {"IslandOptions::fixed", "hapticut_islands_options.fixed_min ... fixed_max"},
    {"OutputLimits", ""},
    {"PictureOptions::up", ""},
    {"PictureOptions::view_direction", ""},
    {"PlaybackRange", ""},
    {"ProfileEdge::kind", "the column kind"},
    {"ReplayOptions::law", ""},
    {"SimulationConfig::contact_time", "hapticut_simulation_options.for_coupling"},
    {"SimulationModelOptions::coupling", "hapticut_loop_options.coupling"},
    {"SimulationModelOptions::coupling.angular_stiffness", "hapticut_loop_options.stiffness, about the axes"},
    {"SimulationModelOptions::coupling.stiffness", "hapticut_loop_options.stiffness"},
    {"Spindle::speed", "the spindle's speed"},
    {"UnclaimedLabels::leave_out", "workpiece.unclaimed_labels = leave_out"},
    {"VolumeBuildOptions::crop_samples", ""},
    {"VolumeBuildOptions::warn", ""},
    {"coupling_gains", "hapticut_loop_options.stiffness = 0"},
    {"read_color_slices", ""},
    {"read_recording", ""},
    {"units::rpm", "HAPTICUT_RPM"},
};

/// Structs whose fields callers of C set by the same names in a struct or in the scene.
constexpr Word kScopes[] = {
    {"CouplingGains", "hapticut_coupling_gains."},
    {"HeatConfig", "hapticut_heat_config."},
    {"IslandOptions", "hapticut_islands_options."},
    {"IslandWatchOptions", "hapticut_islands_options."},
    {"RealtimeOptions", "hapticut_loop_options."},
    {"RunOptions", "hapticut_loop_options."},
    {"SimulationConfig", "simulation."},
    {"SoundOptions", "hapticut_sound_options."},
    {"WorkspaceMapOptions", "hapticut_loop_options."},
};

/// "value of HAPTICUT_COMMAND_SET_SCALE" for the scope "SetScale". Commands of C have one number.
std::optional<std::string> number_of_command(std::string_view scope) {
  const auto is_named = [&]<class Command>(std::size_t, Of<Command>) { return name_of_command<Command>() == scope; };
  if (!find_alternative<LoopCommand>(is_named)) return std::nullopt;
  std::string word = "value of HAPTICUT_COMMAND";
  for (const char c : scope) {
    if ('A' <= c && c <= 'Z') word += '_';
    word += char(std::toupper(static_cast<unsigned char>(c)));
  }
  return word;
}

std::optional<std::string> word_for(const Name& name) {
  if (const auto* const word = std::ranges::find(kWords, name.text(), &Word::name); word != std::end(kWords))
    return word->c.empty() ? std::nullopt : std::optional(std::string(word->c));
  if (const std::optional<std::string_view> key = settings::key_of(name)) return std::string(*key);
  if (std::optional<std::string> number = number_of_command(name.scope())) return number;
  const auto* const scope = std::ranges::find(kScopes, name.scope(), &Word::name);
  return scope == std::end(kScopes) ? std::nullopt : std::optional(std::string(scope->c) + std::string(name.member()));
}

}  // namespace

std::string in_words_of_c(const Error& error) { return error.sentence().written(word_for); }

}  // namespace hapticut::c
