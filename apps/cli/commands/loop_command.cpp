// SPDX-License-Identifier: Apache-2.0
// hapticut loop: a device moves the tool in real time.
#include <chrono>
#include <memory>
#include <thread>

#include "cli/commands/command.hpp"
#include "cli/commands/devices.hpp"
#include "cli/commands/stop_signals.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "page/session/hand_map.hpp"
#include "reports/beside_steps.hpp"
#include "reports/delivery.hpp"
#include "reports/json_file.hpp"
#include "reports/loop_report.hpp"
#include "reports/progress.hpp"
#include "reports/recording_source.hpp"
#include "reports/report.hpp"
#include "settings/heat_settings.hpp"
#include "settings/simulation_settings.hpp"
#include "settings/tool_settings.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

enum class Coupling { virtual_tool, none };

constexpr std::size_t kReservedBlocks = 16384;  // the loop has no time to refill them between steps

struct LoopSettings {
  std::string device;
  double seconds = 0;
  bool simulated_time = false;
  std::optional<Vec3> origin_mm;
  std::optional<Up> up;
  double scale = 1;
  std::optional<Coupling> coupling;
  std::string record, json;
  WorkpieceSettings workpiece;
  ToolSettings tool;
  SimulationSettings simulation;
  HeatSettings heat;
};

constexpr std::string_view kReplay = "replay:";

/// The recording that a device plays; empty for another device.
std::string played_file(const std::string& device) {
  return device.starts_with(kReplay) ? device.substr(kReplay.size()) : "";
}

std::vector<Setting> settings_of(LoopSettings& s) {
  std::vector<Setting> all = {
      text("loop.device", "DEVICE", s.device, "name of the device: mock:spiral, replay:FILE, openhaptics, ..."),
      number("loop.seconds", "--seconds", s.seconds, Range::not_negative(), "duration of the run; 0: until Ctrl-C [0]"),
      boolean("loop.simulated_time", "--simulated_time", s.simulated_time,
              "simulated devices: run as fast as possible, with exact periods"),
      vector("loop.origin_mm", "--origin_mm", s.origin_mm, Range::any(),
             "position of the device's base in the world [the tool touches the centre of the workpiece's top]"),
      choice("loop.up", "--up", s.up, {{"y", Up::y}, {"z", Up::z}},
             "axis of the device's base that points up, along z of the world [z for mock and replay, else y]"),
      number("loop.scale", "--scale", s.scale, range_of(&WorkspaceMapOptions::scale),
             "motion in the world per motion of the hand [1]"),
      choice(
          "loop.coupling", "--coupling", s.coupling, {{"virtual", Coupling::virtual_tool}, {"none", Coupling::none}},
          "connection of hand and tool: a virtual coupling or none [virtual if the device has a specified stiffness]"),
      path("output.record", "--record", s.record, "recording of every step, for replay and export"),
      json_setting(s.json),
  };
  all.front().in_folder = [](const std::string& device, const std::filesystem::path& folder) {
    const std::string played = played_file(device);
    return played.empty() ? device : std::string(kReplay) + (folder / played).string();
  };
  all.front().files = [&s] {
    const std::string played = played_file(s.device);
    return played.empty() ? std::vector<std::filesystem::path>{} : std::vector<std::filesystem::path>{played};
  };
  return together(
      {std::move(all), settings_of(s.workpiece), settings_of(s.tool), settings_of(s.simulation), settings_of(s.heat)});
}

/// Default scene: a block of bone and a ball.
void complete(LoopSettings& s) {
  if (s.workpiece.source.empty()) {
    s.workpiece.source = "block";
    if (!s.workpiece.size_mm) s.workpiece.size_mm = Vec3(30, 30, 15);
    if (s.workpiece.material.empty()) s.workpiece.material = "cortical_bone";
  }
  if (!s.tool.head) s.tool.set_sphere(s.tool.dimension("radius").value_or(1.5));
  if (!s.tool.spindle_rpm) s.tool.spindle_rpm = 30000;
}

bool is_scripted(const std::string& device) { return device.starts_with("mock:") || device.starts_with("replay:"); }

WorkspaceMapOptions map_of(const LoopSettings& s, const DeviceCapabilities& capabilities, const Box& box,
                           const Tool& tool) {
  const Up up = s.up.value_or(is_scripted(s.device) ? Up::z : Up::y);
  WorkspaceMapOptions map = map_above(capabilities, box, tool, up, s.scale);
  if (s.origin_mm) map.X_WB.translation = *s.origin_mm * units::mm;
  return map;
}

/// Acts like a screen: reads snapshots and changed blocks sixty times per second.
LoopWatch watch(RealtimeLoop& loop, Device& device) {
  constexpr auto kFrame = std::chrono::microseconds(16667);
  LoopWatch seen;
  ChangedBlock block;
  const auto look = [&] {
    seen.max_blocks_waiting = std::max(seen.max_blocks_waiting, loop.latest().blocks_waiting);
    while (loop.receive(block)) ++seen.blocks;
    ++seen.frames;
  };
  while (loop.is_running()) {
    look();
    if (StopSignals::came() != 0) device.stop();
    std::this_thread::sleep_for(kFrame);
  }
  look();
  seen.last = loop.latest();
  return seen;
}

/// @throws Error when the device or a signal has ended the run
void require_whole(const LoopSettings& s, const LoopReport& report) {
  if (report.run.fault != DeviceFault::none)
    throw Error("the run ended because of the device: " + describe(report.run.fault) + ".");
  if (s.seconds > 0 && StopSignals::came() != 0)
    throw Error("the run was ended by signal " + std::to_string(StopSignals::came()) + " before " +
                format_number(s.seconds) + " s were over; the report covers the run until then.");
}

void run_loop(LoopSettings s) {
  if (s.device.empty()) throw UsageError("the device is missing. Use: hapticut loop mock:spiral --seconds 60.");
  require_replayable(s.record, s.simulation.remove_loose_pieces);
  Delivery delivery({s.json}, {s.record});
  complete(s);
  use_all_devices();
  const std::unique_ptr<Device> device = open_device(s.device);
  const bool coupled =
      s.coupling.value_or(device->capabilities().stiffness > 0 ? Coupling::virtual_tool : Coupling::none) ==
      Coupling::virtual_tool;
  const Tool tool = make_tool(s.tool);
  Workpiece workpiece =
      with_bar(s.workpiece.source, [&] { return make_workpiece(s.workpiece, tool.cutter().kind, s.tool.sharpness); });
  const WorkpieceSummary summary = summarize(s.workpiece.source, workpiece);
  const std::optional<HeatConfig> heat = make_heat(s.heat, workpiece.materials(), s.workpiece.materials);
  s.simulation.texture_by_default = true;
  SimulationConfig config = make_config(s.simulation);
  if (coupled)
    config.contact_time = ContactTime::end;
  else
    config.device_stiffness = device->capabilities().stiffness / s.scale;
  if (!s.record.empty()) config.list_removed_voxels = true;  // a recording counts them
  Simulation simulation(std::move(workpiece), tool, std::move(config));
  const StopSignals signals;  // a signal ends the run, and the report covers the time until then
  const auto recorder =
      start_recording(delivery, s.record, simulation, s.simulated_time ? Pace::own : Pace::of_a_hand, device.get());
  SimulationModelOptions model_options;
  model_options.map = map_of(s, device->capabilities(), summary.box, tool);
  if (coupled) model_options.coupling = coupling_gains(device->capabilities());
  SimulationModel model(simulation, *device, model_options);
  RealtimeLoopOptions options;
  options.run.seconds = s.seconds;
  options.run.simulated_time = s.simulated_time;
  options.run.stop_on_crash = true;  // this process may end on a crash
  options.run.guard.period = 1 / s.simulation.rate_Hz;
  options.region = model.region();

  LoopReport report{summary, *device, simulation, coupled, {}, {}, 0};
  BesideLoop beside(model, heat, s.simulation.remove_loose_pieces, s.simulated_time);
  {
    RealtimeLoop loop(*device, beside.model(), options);
    loop.start();
    report.seen = watch(loop, *device);
    report.run = loop.wait();
  }
  report.beside = beside.finish();
  report.steps_lost = recorder->close();
  report.recording_failure = recorder->failure();
  write_json(delivery, s.json, to_json(report));
  delivery.print(to_table(report));
  delivery.attempt([&] { recorder->require_complete(); });
  delivery.attempt([&] { require_whole(s, report); });
  delivery.finish();
}

}  // namespace

Command loop_command() {
  auto settings = std::make_shared<LoopSettings>();
  tell_on_stderr(settings->workpiece);
  settings->simulation.config.reserved_blocks = kReservedBlocks;
  settings->simulation.config.list_removed_voxels = false;
  return {"loop",
          "Cut with a device, real or simulated, in real time",
          settings_of(*settings),
          [settings] { run_loop(*settings); },
          {"path"}};
}

}  // namespace hapticut::apps
