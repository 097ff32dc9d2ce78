// SPDX-License-Identifier: Apache-2.0
#include "c/words_of_c.hpp"

#include <map>
#include <regex>
#include <string_view>
#include <utility>

#include "settings/scene_settings.hpp"

namespace hapticut::c {
namespace {

/// [characters] A longer sentence quotes the caller's text. It would exhaust the stack, because std::regex uses a stack
/// frame for each character of a word.
constexpr std::size_t kMaxLength = 1000;

/// C++ words in messages of the library, and the corresponding words of C; longer phrases first.
constexpr std::pair<std::string_view, std::string_view> kPhrases[] = {
    {"SimulationConfig::contact_time = ContactTime::end", "hapticut_simulation_options.for_coupling = 1"},
    {"SimulationModelOptions::coupling with contact_time = end",
     "hapticut_loop_options.coupling, with hapticut_simulation_options.for_coupling = 1"},
    {"DeviceCapabilities::stiffness, or set CouplingGains", "hapticut_loop_options.stiffness"},
    {"CouplingGains::stiffness = ", "hapticut_loop_options.stiffness = "},
    {", or what coupling_gains chooses for the device", ", or 0 for what the device promises"},
    {"RunOptions::realtime.", "hapticut_loop_options."},
    {"GuardOptions::period", "simulation.rate_Hz of the scene, as a period"},
    {"SetScale::scale", "value of HAPTICUT_COMMAND_SET_SCALE"},
    {"Spindle::speed", "the spindle's speed"},
    {"units::rpm", "HAPTICUT_RPM"},
    {"CouplingGains::", "hapticut_coupling_gains."},
    {"RunOptions::", "hapticut_loop_options."},
    {"WorkspaceMapOptions::", "hapticut_loop_options."},
    {"SoundOptions::", "hapticut_sound_options."},
    {"the settings file", "the scene"},
};

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

/// The keys of a scene by the flags of the program: "tool.radius_mm" by "--radius_mm".
std::map<std::string, std::string> keys_by_flag() {
  settings::SceneSettings scene;
  std::map<std::string, std::string> keys;
  for (const settings::Setting& setting : settings_of(scene))
    if (!setting.flag.empty()) keys[setting.flag] = setting.key;
  return keys;
}

/// Replaces flags by keys: "Set --radius_mm" becomes "Set tool.radius_mm".
std::string with_keys(const std::string& sentence) {
  static const std::map<std::string, std::string> keys = keys_by_flag();
  static const std::regex flag("--[A-Za-z]\\w*");
  std::string text;
  auto rest = sentence.begin();
  for (std::sregex_iterator it(sentence.begin(), sentence.end(), flag), end; it != end; ++it) {
    const auto key = keys.find(it->str());
    const auto at = sentence.begin() + it->position();
    if (key == keys.end() || (at != sentence.begin() && *(at - 1) != ' ')) continue;  // part of a file's name
    text.append(rest, at) += key->second;
    rest = at + it->length();
  }
  return text.append(rest, sentence.end());
}

}  // namespace

std::string in_words_of_c(std::string sentence) {
  if (sentence.size() > kMaxLength) return sentence;
  static const std::regex both_ways("--\\S+([^.]*), or (\\w+) under \\[(\\w+)\\] in the settings file");
  static const std::regex announcing(",? (and|link hapticut::\\w+ and) call hapticut::use_\\w+\\(\\)");
  static const std::regex list(
      "(--\\w+) [A-Z_]+=[A-Z_:,.]*[A-Z_]");  // a value such as MATERIAL=THICKNESS_MM belongs to a flag only
  static const std::regex config("SimulationConfig::"), scope("(^|[ (])[A-Z]\\w*::");
  sentence = std::regex_replace(sentence, both_ways, "$3.$2$1 in the scene");
  sentence = std::regex_replace(sentence, announcing, "");
  for (const auto& [of_cpp, of_c] : kPhrases) replace_all(sentence, of_cpp, of_c);
  sentence = with_keys(std::regex_replace(sentence, list, "$1"));
  return std::regex_replace(std::regex_replace(sentence, config, "simulation."), scope, "$1");
}

}  // namespace hapticut::c
