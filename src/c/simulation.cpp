// SPDX-License-Identifier: Apache-2.0
// Scenes: their creation and their properties.
#include <string>
#include <utility>

#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/settings/scene.hpp"
#include "loop/hand_map.hpp"
#include "settings/settings_file.hpp"
#include "settings/tool_settings.hpp"

namespace hapticut::c {
namespace {

/// @param source  text or path of the scene
/// @param name    of that argument, for errors
template <class MakeScene>
int make(const char* source, const char* name, const MakeScene& make_scene, const hapticut_simulation_options* options,
         hapticut_simulation* to) {
  return guarded([&]() -> int {
    require_argument(source, name);
    require_argument(to, "simulation");
    hapticut_simulation_options own;
    if (const int code = read_struct_if_given(options, "options", own); code != HAPTICUT_OK) return code;
    settings::Scene scene = make_scene();
    if (own.for_coupling > 1)
      throw Refusal(HAPTICUT_ERROR_ARGUMENT,
                    "for_coupling = " + std::to_string(own.for_coupling) + "; it must be 0 or 1.");
    if (own.for_coupling == 1) scene.config.contact_time = ContactTime::end;
    Simulation simulation(std::move(scene.workpiece), std::move(scene.tool), std::move(scene.config));
    if (own.undo_blocks > 0) simulation.history().reserve(own.undo_blocks);
    *to = add_object(Kind::simulation, std::make_shared<SimulationObject>(std::move(simulation), std::move(scene)));
    return HAPTICUT_OK;
  });
}

}  // namespace

SimulationObject::SimulationObject(Simulation a_simulation, settings::Scene&& scene)
    : simulation(std::move(a_simulation)),
      motion(std::move(scene.motion)),
      heat(std::move(scene.heat)),
      first_tool(simulation.tool()),
      removal(simulation.config().removal),
      box(box_of_workpiece(simulation.workpiece())),
      bounds(simulation.workpiece().bounds()),
      rate(simulation.config().update_rate) {
  if (!scene.remove_loose_pieces) return;
  watch_of_scene = std::make_unique<IslandWatch>(simulation);
  watch.store(watch_of_scene.get());
}

int SimulationObject::require_idle() const noexcept {
  if (!driven.load(std::memory_order_acquire)) return HAPTICUT_OK;
  return fail(HAPTICUT_ERROR_BUSY, "A loop drives this simulation; call hapticut_loop_stop first.");
}

void SimulationObject::retire(std::shared_ptr<void> observer) {
  {
    const std::lock_guard lock(mutex_);
    retired_.push_back(std::move(observer));
  }
  if (const IdleStay stay(*this); stay) sweep();
}

void SimulationObject::sweep() {
  std::vector<std::shared_ptr<void>> ended;
  {
    const std::lock_guard lock(mutex_);
    ended.swap(retired_);
  }
}

void require_material(const Workpiece& workpiece, std::uint32_t id) {
  const int materials = workpiece.materials().size();
  if (id < 1 || id > std::uint32_t(materials))
    throw Refusal(HAPTICUT_ERROR_ARGUMENT, "id = " + std::to_string(id) +
                                               "; the materials of this scene have the ids 1 to " +
                                               std::to_string(materials) + ".");
}

Tool tool_from_toml(const char* text, const Tool& before) {
  settings::ToolSettings settings;
  (void)settings::read_settings(text, "tool", settings_of(settings));
  if (settings.sharpness)
    throw Error("tool.sharpness"_name + " = " + std::string(name_or_null(*settings.sharpness)) +
                " was given, but the materials of this scene keep their constants. Leave it out, or make another "
                "scene.");
  Tool tool = make_tool(settings);
  const CutterKind kind = before.cutter().kind;
  if (!settings.cutter && tool.cutter().kind == CutterKind::carbide_bur) {  // the default
    settings.cutter = kind;
    tool = make_tool(settings);
  }
  if (tool.cutter().kind != kind)
    throw Error("tool.cutter"_name + " = " + std::string(name_or_null(tool.cutter().kind)) +
                "; but the materials of this scene have the constants of " + std::string(name_or_null(kind)) +
                ", so the forces would be wrong. Keep the cutter, or make another scene.");
  return tool;
}

}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_simulation_from_toml(const char* text, const hapticut_simulation_options* options,
                                  hapticut_simulation* simulation) {
  return make(
      text, "text", [&] { return settings::from_toml(text); }, options, simulation);
}

int hapticut_simulation_from_file(const char* path, const hapticut_simulation_options* options,
                                  hapticut_simulation* simulation) {
  return make(
      path, "path", [&] { return settings::from_file(path); }, options, simulation);
}

int hapticut_scene(hapticut_simulation simulation, hapticut_scene_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(Use<SimulationObject>(simulation), [&](const auto& use) {
    // Frame and number of materials never change. The tool is that of the scene.
    const Workpiece& workpiece = use->simulation.workpiece();
    const Tool& tool = use->first_tool;
    hapticut_scene_info own{};
    own.materials = std::uint32_t(workpiece.materials().size());
    own.rate = use->rate;
    own.voxel_size = workpiece.voxel_size();
    put(use->box.min, own.box_min);
    put(use->box.max, own.box_max);
    put(workpiece.frame().X_WV, own.X_WV);
    put(tool.X_HT(), own.X_HT);
    put(tool.head().bounding_box().min, own.head_min);
    put(tool.head().bounding_box().max, own.head_max);
    own.spindle_speed = tool.spindle().speed;
    own.path_duration = use->motion ? use->motion->duration() : 0;
    own.flutes = std::uint32_t(tool.cutter().lips);
    write_struct(own, info);
  });
}

int hapticut_material(hapticut_simulation simulation, uint32_t id, hapticut_material_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(IdleSimulation(simulation), [&](const auto& use) {
    const Workpiece& workpiece = use->simulation.workpiece();
    require_material(workpiece, id);
    hapticut_material_info own{};
    own.removed_volume = use->simulation.totals().removed_volume[id];
    own.volume = workpiece.amounts().at(id - 1).volume;
    own.detached_volume = use->simulation.totals().detached_volume[id];
    copy_text(workpiece.materials()[MaterialId(id)].name, own.name, sizeof own.name);
    write_struct(own, info);
  });
}

int hapticut_path_pose(hapticut_simulation simulation, double time, hapticut_pose* X_WH) {
  return within(Use<SimulationObject>(simulation), [&](const auto& use) -> int {
    require_argument(X_WH, "X_WH");
    if (!use->motion) return HAPTICUT_NOTHING;
    if (!std::isfinite(time)) throw Refusal(HAPTICUT_ERROR_ARGUMENT, "time is not finite; it must be a finite number.");
    put(use->motion->pose_at(time) * use->first_tool.X_HT().inverse(), *X_WH);
    return HAPTICUT_OK;
  });
}

int hapticut_set_tool(hapticut_simulation simulation, const char* text) {
  return within(IdleSimulation(simulation), [&](const auto& use) {
    require_argument(text, "text");
    use->simulation.set(tool_from_toml(text, use->first_tool));
    use->tool_exchanges.fetch_add(1);
  });
}

int hapticut_save_workpiece(hapticut_simulation simulation, const char* path) {
  return within(IdleSimulation(simulation), [&](const auto& use) {
    require_argument(path, "path");
    if (!std::string_view(path).ends_with(".vdb"))
      throw Refusal(HAPTICUT_ERROR_ARGUMENT, "path = '" + std::string(path) + "'; it must end with .vdb.");
    save_vdb(use->simulation.workpiece(), path);
  });
}

}  // extern "C"
