// SPDX-License-Identifier: Apache-2.0
#include "hapticut/settings/scene.hpp"

#include <set>
#include <string>
#include <utility>

#include "settings/scene_settings.hpp"
#include "settings/settings_file.hpp"

namespace hapticut::settings {
namespace {

const std::set<std::string> kProgramTables = {"output", "loop"};

}  // namespace

std::vector<Setting> settings_of(SceneSettings& s) {
  return together({settings_of(s.workpiece), settings_of(s.tool), settings_of(s.path), settings_of(s.simulation),
                   settings_of(s.heat)});
}

Scene make_scene(const SceneSettings& s, bool with_motion) {
  Tool tool = make_tool(s.tool);
  std::optional<Motion> motion;
  if (with_motion) motion = make_motion(s.path, tool);
  SimulationConfig config = make_config(s.simulation);
  WorkpieceSettings source = s.workpiece;
  std::vector<std::string> warnings;
  source.warn = [&](const std::string& warning) { warnings.push_back(warning); };
  Workpiece workpiece = make_workpiece(std::move(source), tool.cutter().kind, s.tool.sharpness);
  std::optional<HeatConfig> heat = make_heat(s.heat, workpiece.materials(), s.workpiece.materials);
  return {std::move(workpiece),
          std::move(tool),
          std::move(config),
          std::move(motion),
          std::move(warnings),
          std::move(heat),
          s.simulation.remove_loose_pieces};
}

Scene from_toml(std::string_view text, const std::filesystem::path& folder) {
  SceneSettings settings;
  const std::set<std::string> tables = read_settings(text, "scene", settings_of(settings), kProgramTables, folder);
  return make_scene(settings, tables.contains("path"));
}

Scene from_file(const std::filesystem::path& path) {
  SceneSettings settings;
  const std::set<std::string> tables = read_settings_file(path, settings_of(settings), kProgramTables);
  return make_scene(settings, tables.contains("path"));
}

}  // namespace hapticut::settings
