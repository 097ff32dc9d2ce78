// SPDX-License-Identifier: Apache-2.0
// Handles that are 0, stale, of another kind or invented, and null arguments.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "unit/c/scenes.hpp"

namespace hapticut::c_handles_test {
namespace {

using namespace c_test;

struct Arguments {
  hapticut_step_input input = above(0);
  hapticut_step_result result = sized<hapticut_step_result>();
  hapticut_scene_info scene = sized<hapticut_scene_info>();
  hapticut_material_info material = sized<hapticut_material_info>();
  hapticut_probe_result probe = sized<hapticut_probe_result>();
  hapticut_energy_ledger energy = sized<hapticut_energy_ledger>();
  hapticut_device_info device = sized<hapticut_device_info>();
  hapticut_loop_state state = sized<hapticut_loop_state>();
  hapticut_loop_report report = sized<hapticut_loop_report>();
  hapticut_command command = [] {
    auto one = sized<hapticut_command>();
    one.kind = HAPTICUT_COMMAND_SET_UNDO_MARK;
    return one;
  }();
  hapticut_page page = sized<hapticut_page>();
  hapticut_sound_input sound = sized<hapticut_sound_input>();
  hapticut_recording_report recording = sized<hapticut_recording_report>();
  hapticut_heat_structure_info structure = sized<hapticut_heat_structure_info>();
  hapticut_heat_balance_info balance = sized<hapticut_heat_balance_info>();
  hapticut_heat_grid_info grid = sized<hapticut_heat_grid_info>();
  hapticut_island_info island = sized<hapticut_island_info>();
  double number = 0;
  std::uint64_t count = 0;
  hapticut_pose pose = above(0).X_WH;
  std::array<double, 3> point{};
  std::array<float, 16> samples{};
  int flag = 0;
  hapticut_handle made = 0;
};

using Call = std::function<int(hapticut_handle, Arguments&)>;
struct Function {
  const char* name;
  std::string kind;
  Call call;
  bool may_be_refused = false;  // even with a valid handle
};

/// All functions with a handle. Each call has a variable handle and otherwise valid arguments.
std::vector<Function> functions() {
  return {
      {"scene", "simulation", [](auto h, auto& a) { return hapticut_scene(h, &a.scene); }},
      {"material", "simulation", [](auto h, auto& a) { return hapticut_material(h, 1, &a.material); }},
      {"path_pose", "simulation", [](auto h, auto& a) { return hapticut_path_pose(h, 0, &a.pose); }},
      {"step", "simulation", [](auto h, auto& a) { return hapticut_step(h, &a.input, &a.result); }},
      {"probe", "simulation", [](auto h, auto& a) { return hapticut_probe(h, &a.input, &a.probe); }},
      {"touches", "simulation", [](auto h, auto& a) { return hapticut_touches(h, &a.pose, &a.flag); }},
      {"energy", "simulation", [](auto h, auto& a) { return hapticut_energy(h, &a.energy); }},
      {"set_spindle_speed", "simulation", [](auto h, auto&) { return hapticut_set_spindle_speed(h, 1000); }},
      {"set_tool", "simulation", [](auto h, auto&) { return hapticut_set_tool(h, kOtherTool.c_str()); }},
      {"save_workpiece", "simulation", [](auto h, auto&) { return hapticut_save_workpiece(h, "/no/folder/a.vdb"); },
       true},
      {"snapshot_take", "simulation", [](auto h, auto& a) { return hapticut_snapshot_take(h, &a.made); }},
      {"snapshot_restore", "simulation",
       [](auto h, auto&) {
         const Owned simulation(simulation_of());
         Owned snapshot;
         hapticut_snapshot_take(simulation.get(), snapshot.to());
         return hapticut_snapshot_restore(h, snapshot.get());
       },
       true},
      {"snapshot_restore", "snapshot",
       [](auto h, auto&) {
         const Owned simulation(simulation_of());
         return hapticut_snapshot_restore(simulation.get(), h);
       },
       true},
      {"set_undo_mark", "simulation", [](auto h, auto&) { return hapticut_set_undo_mark(h); }, true},
      {"undo", "simulation", [](auto h, auto&) { return hapticut_undo(h); }},
      {"redo", "simulation", [](auto h, auto&) { return hapticut_redo(h); }},
      {"coupling_open", "simulation", [](auto h, auto& a) { return hapticut_coupling_open(h, nullptr, &a.made); }},
      {"coupling_step", "coupling", [](auto h, auto& a) { return hapticut_coupling_step(h, &a.input, &a.result); },
       true},
      {"coupling_reset", "coupling", [](auto h, auto&) { return hapticut_coupling_reset(h); }, true},
      {"device_describe", "device", [](auto h, auto& a) { return hapticut_device_describe(h, &a.device); }},
      {"loop_start", "simulation",
       [](auto h, auto& a) {
         const Owned device(device_of());
         return hapticut_loop_start(h, device.get(), nullptr, &a.made);
       },
       true},
      {"loop_start", "device",
       [](auto h, auto& a) {
         const Owned simulation(simulation_of());
         return hapticut_loop_start(simulation.get(), h, nullptr, &a.made);
       },
       true},
      {"loop_is_running", "loop", [](auto h, auto& a) { return hapticut_loop_is_running(h, &a.flag); }},
      {"loop_latest", "loop", [](auto h, auto& a) { return hapticut_loop_latest(h, &a.state); }},
      {"loop_send", "loop", [](auto h, auto& a) { return hapticut_loop_send(h, &a.command); }, true},
      {"loop_set_tool", "loop", [](auto h, auto&) { return hapticut_loop_set_tool(h, kOtherTool.c_str()); }, true},
      {"loop_emergency_stop", "loop", [](auto h, auto&) { return hapticut_loop_emergency_stop(h); }},
      {"loop_reset_fault", "loop", [](auto h, auto&) { return hapticut_loop_reset_fault(h); }},
      {"loop_stop", "loop", [](auto h, auto& a) { return hapticut_loop_stop(h, &a.report); }},
      {"surface_open", "simulation", [](auto h, auto& a) { return hapticut_surface_open(h, &a.made); }},
      {"surface_poll", "surface", [](auto h, auto& a) { return hapticut_surface_poll(h, &a.page); }},
      {"surface_release_page", "surface",
       [](auto h, auto& a) { return hapticut_surface_release_page(h, a.page.ticket); }},
      {"surface_look_at", "surface", [](auto h, auto& a) { return hapticut_surface_look_at(h, a.point.data()); }},
      {"surface_catch_up", "surface", [](auto h, auto&) { return hapticut_surface_catch_up(h); }},
      {"heat_open", "simulation", [](auto h, auto& a) { return hapticut_heat_open(h, nullptr, nullptr, 0, &a.made); }},
      {"heat_update", "heat field", [](auto h, auto& a) { return hapticut_heat_update(h, &a.number); }},
      {"heat_advance", "heat field", [](auto h, auto&) { return hapticut_heat_advance(h, 0.1); }},
      {"heat_set_irrigation", "heat field", [](auto h, auto&) { return hapticut_heat_set_irrigation(h, 1000); }},
      {"heat_temperature_at", "heat field",
       [](auto h, auto& a) { return hapticut_heat_temperature_at(h, a.point.data(), &a.number); }},
      {"heat_structure", "heat field", [](auto h, auto& a) { return hapticut_heat_structure(h, 1, &a.structure); }},
      {"heat_balance", "heat field", [](auto h, auto& a) { return hapticut_heat_balance(h, &a.balance); }},
      {"heat_grid", "heat field", [](auto h, auto& a) { return hapticut_heat_grid(h, &a.grid); }},
      {"heat_cells", "heat field",
       [](auto h, auto& a) {
         hapticut_heat_grid(h, &a.grid);
         std::vector<float> values(std::size_t(a.grid.dims[0]) * a.grid.dims[1] * a.grid.dims[2] + 1);
         return hapticut_heat_cells(h, HAPTICUT_HEAT_PEAK, values.data(), values.size() - 1);
       }},
      {"islands_open", "simulation", [](auto h, auto& a) { return hapticut_islands_open(h, nullptr, &a.made); }, true},
      {"islands_count", "removal of loose pieces", [](auto h, auto& a) { return hapticut_islands_count(h, &a.count); }},
      {"islands_poll", "removal of loose pieces", [](auto h, auto& a) { return hapticut_islands_poll(h, &a.island); }},
      {"sound_render", "sound",
       [](auto h, auto& a) { return hapticut_sound_render(h, &a.sound, 48000, a.samples.data(), a.samples.size()); }},
      {"recording_start", "simulation",
       [](auto h, auto& a) { return hapticut_recording_start(h, 0, "/no/folder/a.h5", &a.made); }, true},
      {"recording_stop", "recording", [](auto h, auto& a) { return hapticut_recording_stop(h, &a.recording); }, true},
  };
}

/// One handle of each kind.
struct All {
  Owned simulation{simulation_of(kScene, 1)}, device{device_of("mock:rest")}, snapshot, coupling, loop, surface, sound;
  Owned loop_simulation{simulation_of(kScene, 1)}, heat, islands;
  All() {
    EXPECT_EQ(hapticut_snapshot_take(simulation.get(), snapshot.to()), HAPTICUT_OK);
    EXPECT_EQ(hapticut_coupling_open(simulation.get(), nullptr, coupling.to()), HAPTICUT_OK);
    EXPECT_EQ(hapticut_surface_open(simulation.get(), surface.to()), HAPTICUT_OK);
    EXPECT_EQ(hapticut_sound_open(nullptr, sound.to()), HAPTICUT_OK);
    EXPECT_EQ(hapticut_heat_open(simulation.get(), nullptr, nullptr, 0, heat.to()), HAPTICUT_OK);
    EXPECT_EQ(hapticut_islands_open(simulation.get(), nullptr, islands.to()), HAPTICUT_OK);
    auto options = sized<hapticut_loop_options>();
    options.up = HAPTICUT_UP_Z;
    options.ordinary_priority = 1;
    EXPECT_EQ(hapticut_loop_start(loop_simulation.get(), device.get(), &options, loop.to()), HAPTICUT_OK)
        << hapticut_last_error();
  }
  [[nodiscard]] std::vector<std::pair<std::string, hapticut_handle>> handles() const {
    return {{"simulation", simulation.get()}, {"device", device.get()},   {"snapshot", snapshot.get()},
            {"coupling", coupling.get()},     {"loop", loop.get()},       {"surface", surface.get()},
            {"sound", sound.get()},           {"heat field", heat.get()}, {"removal of loose pieces", islands.get()}};
  }
};

TEST(CHandles, NoFunctionTakesNoneAStaleOneOrOneOfAnotherKind) {
  const All all;
  for (const Function& function : functions()) {
    SCOPED_TRACE(function.name);
    Arguments arguments;
    EXPECT_EQ(function.call(0, arguments), HAPTICUT_ERROR_HANDLE);
    EXPECT_NE(std::string(hapticut_last_error()).find("handle is 0; it must be that of a " + function.kind),
              std::string::npos)
        << hapticut_last_error();
    for (const hapticut_handle made_up : {~hapticut_handle(0), hapticut_handle(1), hapticut_handle(0x7f) << 56})
      EXPECT_EQ(function.call(made_up, arguments), HAPTICUT_ERROR_HANDLE);
    for (const auto& [kind, handle] : all.handles()) {
      if (kind == function.kind) continue;
      EXPECT_EQ(function.call(handle, arguments), HAPTICUT_ERROR_HANDLE) << kind;
      EXPECT_NE(
          std::string(hapticut_last_error()).find("is that of a " + kind + "; it must be that of a " + function.kind),
          std::string::npos)
          << hapticut_last_error();
    }
    EXPECT_EQ(arguments.made, 0U) << "nothing was made";
  }
}

TEST(CHandles, AreStaleOnceTheyAreReleased) {
  std::vector<std::pair<std::string, hapticut_handle>> stale;
  {
    const All all;
    stale = all.handles();
  }
  const All others;  // they reuse the slots
  for (const auto& [kind, handle] : stale) {
    EXPECT_EQ(hapticut_release(handle), HAPTICUT_ERROR_HANDLE) << kind;
    EXPECT_NE(std::string(hapticut_last_error()).find(kind + " was already released"), std::string::npos)
        << hapticut_last_error();
  }
  for (const Function& function : functions()) {
    for (const auto& [kind, handle] : stale) {
      Arguments arguments;
      EXPECT_EQ(function.call(handle, arguments), HAPTICUT_ERROR_HANDLE) << function.name << ' ' << kind;
    }
  }
  EXPECT_EQ(hapticut_release(0), HAPTICUT_ERROR_HANDLE);
  Arguments arguments;
  EXPECT_EQ(hapticut_step(others.simulation.get(), &arguments.input, &arguments.result), HAPTICUT_OK)
      << "the new handles in these slots are valid";
}

TEST(CHandles, AreTakenByEveryFunctionWhileTheyLive) {
  const All all;
  for (const Function& function : functions()) {
    for (const auto& [kind, handle] : all.handles()) {
      if (kind != function.kind || std::string(function.name) == "loop_stop") continue;
      Arguments arguments;
      if (std::string(function.name) == "surface_release_page") hapticut_surface_poll(handle, &arguments.page);
      const int code = function.call(handle, arguments);
      EXPECT_TRUE(code >= 0 || function.may_be_refused) << function.name << ": " << hapticut_last_error();
      EXPECT_NE(code, HAPTICUT_ERROR_HANDLE) << function.name << ": " << hapticut_last_error();
      const Owned made(arguments.made);
    }
  }
}

TEST(CHandles, SurviveNumbersThatWereNeverHandles) {
  const All all;
  std::mt19937_64 random(7);
  for (int n = 0; n < 2000; ++n) {
    std::uint64_t handle = random();
    if (n % 2 == 0) handle = all.simulation.get() ^ (std::uint64_t(1) << (random() % 64));
    Arguments arguments;
    EXPECT_EQ(hapticut_step(handle, &arguments.input, &arguments.result), HAPTICUT_ERROR_HANDLE);
    EXPECT_EQ(hapticut_energy(handle, &arguments.energy), HAPTICUT_ERROR_HANDLE);
  }
}

TEST(CHandles, AreRefusedWhereThereAreTooMany) {
  std::vector<hapticut_handle> many;
  hapticut_sound sound = 0;
  int code = HAPTICUT_OK;
  while (many.size() < 5000 && (code = hapticut_sound_open(nullptr, &sound)) == HAPTICUT_OK) many.push_back(sound);
  EXPECT_EQ(code, HAPTICUT_ERROR_FULL);
  EXPECT_LE(many.size(), 4096U);
  for (const hapticut_handle one : many) EXPECT_EQ(hapticut_release(one), HAPTICUT_OK);
  EXPECT_EQ(hapticut_sound_open(nullptr, &sound), HAPTICUT_OK);
  EXPECT_EQ(hapticut_release(sound), HAPTICUT_OK);
}

TEST(CArguments, ThatAreNullAreNamed) {
  const All all;
  const hapticut_handle simulation = all.simulation.get();
  Arguments a;
  const std::vector<std::pair<const char*, std::function<int()>>> calls = {
      {"text", [&] { return hapticut_simulation_from_toml(nullptr, nullptr, &a.made); }},
      {"simulation", [&] { return hapticut_simulation_from_toml(kScene.c_str(), nullptr, nullptr); }},
      {"path", [&] { return hapticut_simulation_from_file(nullptr, nullptr, &a.made); }},
      {"simulation", [&] { return hapticut_simulation_from_file("a.toml", nullptr, nullptr); }},
      {"info", [&] { return hapticut_scene(simulation, nullptr); }},
      {"info", [&] { return hapticut_material(simulation, 1, nullptr); }},
      {"X_WH", [&] { return hapticut_path_pose(simulation, 0, nullptr); }},
      {"input", [&] { return hapticut_step(simulation, nullptr, &a.result); }},
      {"result", [&] { return hapticut_step(simulation, &a.input, nullptr); }},
      {"input", [&] { return hapticut_probe(simulation, nullptr, &a.probe); }},
      {"result", [&] { return hapticut_probe(simulation, &a.input, nullptr); }},
      {"X_WH", [&] { return hapticut_touches(simulation, nullptr, &a.flag); }},
      {"touches", [&] { return hapticut_touches(simulation, &a.pose, nullptr); }},
      {"ledger", [&] { return hapticut_energy(simulation, nullptr); }},
      {"text", [&] { return hapticut_set_tool(simulation, nullptr); }},
      {"path", [&] { return hapticut_save_workpiece(simulation, nullptr); }},
      {"snapshot", [&] { return hapticut_snapshot_take(simulation, nullptr); }},
      {"coupling", [&] { return hapticut_coupling_open(simulation, nullptr, nullptr); }},
      {"input", [&] { return hapticut_coupling_step(all.coupling.get(), nullptr, &a.result); }},
      {"result", [&] { return hapticut_coupling_step(all.coupling.get(), &a.input, nullptr); }},
      {"name", [&] { return hapticut_device_open(nullptr, &a.made); }},
      {"device", [&] { return hapticut_device_open("mock:rest", nullptr); }},
      {"info", [&] { return hapticut_device_describe(all.device.get(), nullptr); }},
      {"loop", [&] { return hapticut_loop_start(simulation, all.device.get(), nullptr, nullptr); }},
      {"running", [&] { return hapticut_loop_is_running(all.loop.get(), nullptr); }},
      {"state", [&] { return hapticut_loop_latest(all.loop.get(), nullptr); }},
      {"command", [&] { return hapticut_loop_send(all.loop.get(), nullptr); }},
      {"text", [&] { return hapticut_loop_set_tool(all.loop.get(), nullptr); }},
      {"surface", [&] { return hapticut_surface_open(simulation, nullptr); }},
      {"page", [&] { return hapticut_surface_poll(all.surface.get(), nullptr); }},
      {"p_WQ", [&] { return hapticut_surface_look_at(all.surface.get(), nullptr); }},
      {"heat", [&] { return hapticut_heat_open(simulation, nullptr, nullptr, 0, nullptr); }},
      {"by_material", [&] { return hapticut_heat_open(simulation, nullptr, nullptr, 1, &a.made); }},
      {"p_WQ", [&] { return hapticut_heat_temperature_at(all.heat.get(), nullptr, &a.number); }},
      {"temperature", [&] { return hapticut_heat_temperature_at(all.heat.get(), a.point.data(), nullptr); }},
      {"info", [&] { return hapticut_heat_structure(all.heat.get(), 1, nullptr); }},
      {"info", [&] { return hapticut_heat_balance(all.heat.get(), nullptr); }},
      {"info", [&] { return hapticut_heat_grid(all.heat.get(), nullptr); }},
      {"values", [&] { return hapticut_heat_cells(all.heat.get(), 0, nullptr, 1); }},
      {"islands", [&] { return hapticut_islands_open(simulation, nullptr, nullptr); }},
      {"count", [&] { return hapticut_islands_count(all.islands.get(), nullptr); }},
      {"info", [&] { return hapticut_islands_poll(all.islands.get(), nullptr); }},
      {"sound", [&] { return hapticut_sound_open(nullptr, nullptr); }},
      {"input", [&] { return hapticut_sound_render(all.sound.get(), nullptr, 48000, a.samples.data(), 1); }},
      {"samples", [&] { return hapticut_sound_render(all.sound.get(), &a.sound, 48000, nullptr, 1); }},
      {"path", [&] { return hapticut_recording_start(simulation, 0, nullptr, &a.made); }},
      {"recording", [&] { return hapticut_recording_start(simulation, 0, "a.h5", nullptr); }},
      {"text", [&] { return hapticut_status_text(0, nullptr, 1); }},
  };
  for (const auto& [name, call] : calls) {
    EXPECT_EQ(call(), HAPTICUT_ERROR_ARGUMENT) << name;
    EXPECT_NE(std::string(hapticut_last_error()).find(name), std::string::npos) << hapticut_last_error();
  }
  EXPECT_EQ(a.made, 0U);
}

}  // namespace
}  // namespace hapticut::c_handles_test
