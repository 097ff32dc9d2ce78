// SPDX-License-Identifier: Apache-2.0
#include "page/session/view_session.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "page/session/hand_map.hpp"
#include "reports/flag_words.hpp"

namespace hapticut::apps {
namespace {

constexpr double kReach = 0.06;              // [m] range of the pointer around the workpiece
constexpr std::size_t kUndoBlocks = 16'384;  // 2.7 kB per block
constexpr Color kNoColor = {176, 180, 186};

Color color_of(const std::string& name) {
  for (const std::string_view known : preset_names())
    if (known == name) return preset_color(name);
  return kNoColor;
}

Box grown(const Box& box, double by) { return {box.min - Vec3::Constant(by), box.max + Vec3::Constant(by)}; }

bool same_handle(const Tool& a, const Tool& b) {
  return a.handle().index() == b.handle().index() && a.X_HT().rotation == b.X_HT().rotation &&
         a.X_HT().translation == b.X_HT().translation;
}

/// No hand holds a pointer, so a late tick of a machine busy with drawing must not stop the force until the tool is
/// free.
void forgive(GuardOptions& guard) {
  guard.arming.ramp = 0.3;
  guard.arming.short_ramp = 0.1;
  guard.late = 1;
  guard.pause = 5;
  guard.watchdog.late = guard.watchdog.fade_after = 1;
  guard.watchdog.fault = 5;
}

std::string free_name() {
  for (int n = 1;; ++n) {
    std::string name("session-");
    name.append(std::to_string(n)).append(".h5");
    if (!std::filesystem::exists(name)) return name;
  }
}

}  // namespace

std::string as_sentence(const std::exception& error) {
  std::string text = in_words_of_flags(error);
  // Only a word: the name of a file or of a setting stays.
  const std::string word = text.substr(0, text.find_first_of(", "));
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  if (!word.empty() && std::ranges::all_of(word, is_letter)) text[0] = char(text[0] - 'a' + 'A');
  return text;
}

view::Scene shown_scene(const Workpiece& workpiece) {
  view::Scene shown{workpiece.frame(), {}};
  const MaterialTable& materials = workpiece.materials();
  for (int n = 1; n <= materials.size(); ++n) {
    const std::string& name = materials[MaterialId(n)].name;
    shown.materials.push_back({name, color_of(name)});
  }
  return shown;
}

ViewSession::ViewSession(ViewScene scene, view::ViewServer& server, Device* device)
    : scene_(std::move(scene)),
      server_(server),
      device_(device),
      pointer_(grown(scene_.box, kReach)),
      simulation_(std::move(scene_.workpiece), scene_.tool, scene_.config),
      controls_(scene_.tool, simulation_.workpiece().materials(), simulation_.config(),
#ifdef HAPTICUT_HAS_IO
                true,
#else
                false,
#endif
                {scene_.shows_heat, scene_.heat.irrigation, scene_.removes_loose_pieces}),
      tool_(scene_.tool),
      stream_(simulation_.workpiece()),
      sound_({.flutes = scene_.tool.cutter().lips}) {
  simulation_.history().reserve(kUndoBlocks);
  pointer_.put(start_pose(scene_));
  renew_heat();
  renew_islands();
  build_loop();
}

ViewSession::~ViewSession() {
  loop_.reset();  // ends a running loop before its objects are destroyed
}

void ViewSession::begin(bool runs) {
  server_.show(shown_scene(simulation_.workpiece()));
  server_.send(tool_);
  server_.send(controls_.all());
  if (runs) start();
}

/// Builds model and loop around the present simulation and tool.
void ViewSession::build_loop() {
  if (loop_) removed_before_ = latest().tool.removed_volume;
  loop_.reset(), watched_.reset(), model_.reset();
  SimulationModelOptions options;
  options.undo_blocks = kUndoBlocks;
  if (device_ == nullptr) options.pedal = PointerHand::kPress;  // a hovering pointer passes through the workpiece
  const DeviceCapabilities& c = device().capabilities();
  if (device_ == nullptr) {
    map_ = {};
    map_.X_SH = tool_.X_HT().inverse();  // the stylus of the pointer is the head
  } else {
    map_ = map_above(c, scene_.box, tool_, Up::y, 1);
  }
  options.map = map_;
  if (c.stiffness > 0) options.coupling = coupling_gains(c);
  model_ = std::make_unique<SimulationModel>(simulation_, device(), options);
  RealtimeLoopOptions loop;
  loop.run.guard.period = 1 / simulation_.config().update_rate;
  watched_ = std::make_unique<WatchedModel>(*model_, simulation_, device(), loop.run.guard.period);
  loop.run.stop_on_crash = true;  // this process may end on a crash
  if (device_ == nullptr) forgive(loop.run.guard);
  loop.region = model_->region();
  loop_ = std::make_unique<RealtimeLoop>(device(), *watched_, loop);
  sent_ = 0;
  controls_outdated_ = true;
  connect_islands();
}

/// Makes the heat that the controls ask for, of the present workpiece. It observes the steps, so not during a run.
void ViewSession::renew_heat() {
  heat_.reset();
  const BesideTheStep beside = controls_.beside();
  if (!beside.heat) return;
  HeatConfig config = scene_.heat;
  config.irrigation = beside.irrigation;
  heat_ = std::make_unique<HeatWatch>(simulation_, config);
}

/// Begins or ends the search for loose pieces. Not during a run.
void ViewSession::renew_islands() {
  const bool on = controls_.beside().loose_pieces;
  if (on == (islands_ != nullptr)) return;
  islands_ = on ? std::make_unique<IslandWatch>(simulation_) : nullptr;
  told_pieces_ = 0;
}

/// Lets the loop remove loose pieces, except in a recording, which would end there. Not during a run.
void ViewSession::connect_islands() { watched_->remove_with(recorder_ == nullptr ? islands_.get() : nullptr); }

void ViewSession::start() {
  if (!paused_) return;
  paused_ = false;
  begins_ = true;
  tick_before_ = loop_->latest().tick;
  watched_->begin_run();
  loop_->start();
}

/// Ends the run and fades the force out; everything else stays.
void ViewSession::pause() {
  if (paused_) return;
  paused_ = true;
  std::string failure;
  try {
    if (const DeviceFault fault = loop_->stop().fault; fault != DeviceFault::none)
      failure =
          "The device has stopped: " + describe(fault) + ". Check its cable and power, and move the tool to continue.";
  } catch (const Error& error) {
    failure = as_sentence(error);
  }
  drain_blocks();
  // Each command of a page retries, but the notice is sent once.
  if (!failure.empty() && failure != last_failure_) server_.send_notice(view::Severity::error, failure);
  last_failure_ = std::move(failure);
}

void ViewSession::suspend() {
  pause();
  try {
    end_recording();
  } catch (const Error& error) {
    server_.send_notice(view::Severity::error, as_sentence(error));
  }
  controls_.show_recording(false);
  controls_outdated_ = true;
}

void ViewSession::apply(const view::ViewCommand& command) {
  try {
    if (!std::holds_alternative<view::WriterLeft>(command)) start();
    std::visit([this](const auto& one) { handle(one); }, command);
  } catch (const Error& error) {
    server_.send_notice(view::Severity::error, as_sentence(error));
  }
}

void ViewSession::send(LoopCommand&& command) {
  controls_outdated_ = true;
  if (loop_->send(std::move(command)))
    ++sent_;
  else
    server_.send_notice(view::Severity::warning, "The loop is overloaded: try again.");
}

void ViewSession::handle(const view::MoveHand& command) {
  if (device_ != nullptr || !is_looked_at_)
    return;  // the device moves the tool, or the command belongs to the previous scene
  if (command.pressed && !pressed_) begin_cut();
  pressed_ = command.pressed;
  pointer_.move_to(command.X_WH * tool_.X_HT(), command.pressed);
}

/// Sets an undo mark, unless nothing has changed since the last one.
void ViewSession::begin_cut() {
  const double removed = latest().tool.removed_volume;
  if (removed == removed_at_mark_) return;
  removed_at_mark_ = removed;
  send(commands::SetUndoMark{});
}

void ViewSession::handle(const view::SetControl& command) {
  controls_outdated_ = true;  // a page that asked for a refused value shows the present one again
  const Change what = controls_.set(command);
  if (what == Change::none)
    return server_.send_notice(view::Severity::warning, "That value is out of range, or there is no such control.");
  try {
    change(what);
  } catch (const Error& error) {
    controls_.revert();
    server_.send_notice(view::Severity::error, as_sentence(error));
  }
}

void ViewSession::change(Change what) {
  switch (what) {
    case Change::removal:
      return send(commands::SetRemoval{controls_.removal()});
    case Change::spindle:
      return send(commands::SetSpindleSpeed{controls_.spindle_speed()});
    case Change::tool:
      return change_tool();
    case Change::materials:
      return send(model_->prepare_materials(controls_.materials()));
    case Change::effects:
      return send(commands::SetEffects{controls_.effects()});
    case Change::restart:
      restart_requested_ = true;
      return;
    case Change::reset:
      return device().reset_fault();
    case Change::record:
      return record(controls_.recording());
    case Change::heat:
      return change_heat();
    case Change::loose_pieces:
      return beside_runs([this] {
        watched_->remove_with(nullptr);
        renew_islands();
        connect_islands();
      });
    case Change::haptics:
    case Change::none:
      return;
  }
}

/// A head can change while the spindle turns. Another handle moves the hand, so the run ends first.
void ViewSession::change_tool() {
  Tool tool = controls_.tool();
  if (same_handle(tool, tool_)) {
    send(model_->prepare_tool(tool));
  } else {
    pause();
    simulation_.set(tool);
    tool_ = tool;
    build_loop();
    start();
  }
  tool_ = std::move(tool);
  server_.send(tool_);
}

/// The water changes during a run, the heat itself between two.
void ViewSession::change_heat() {
  const BesideTheStep beside = controls_.beside();
  if (beside.heat == (heat_ != nullptr)) {
    if (heat_ != nullptr) heat_->set_irrigation(beside.irrigation);
    return;
  }
  beside_runs([this] { renew_heat(); });
  server_.send(view::Heat{});
}

/// Makes a change that needs that nothing runs.
void ViewSession::beside_runs(const std::function<void()>& make) {
  pause();
  try {
    make();
  } catch (const Error&) {
    start();
    throw;
  }
  start();
}

void ViewSession::record(bool on) {
  beside_runs([this, on] { on ? begin_recording() : end_recording(); });
}

/// A replay begins with a first step. So the present workpiece becomes the initial one, and the sums restart.
void ViewSession::begin_recording() {
  simulation_.reset(simulation_.workpiece().clone());
  simulation_.set(controls_.removal());
  simulation_.spindle().set_speed(controls_.spindle_speed());
  removed_at_mark_ = -1;
  dissipated_ = 0;
  renew_heat();
  build_loop();
  removed_before_ = 0;
  recording_ = free_name();
  recorder_ = std::make_unique<RunRecorder>(recording_, simulation_, Pace::of_a_hand, &device());
  connect_islands();
  server_.send_notice(view::Severity::info, "Recording to " + recording_ + ".");
}

void ViewSession::end_recording() {
  if (recorder_ == nullptr) return;
  const std::unique_ptr<RunRecorder> recorder = std::move(recorder_);
  connect_islands();
  recorder->close();
  recorder->require_complete();
  server_.send_notice(view::Severity::info, recording_ + " is complete. To show it: hapticut view " + recording_ + ".");
}

}  // namespace hapticut::apps
