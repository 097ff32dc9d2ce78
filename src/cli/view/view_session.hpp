// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/recording_source.hpp"
#include "cli/view/pointer_hand.hpp"
#include "cli/view/view_controls.hpp"
#include "cli/view/view_scenes.hpp"
#include "cli/view/watched_model.hpp"
#include "hapticut/sound/loop_listener.hpp"
#include "hapticut/surface/surface_stream.hpp"
#include "hapticut/view/view_server.hpp"

namespace hapticut::cli {

/// What a page is told of an error, which begins with a small letter behind the name of the program.
[[nodiscard]] std::string as_sentence(const std::exception& error);

/// What pages must know of a scene before anything else.
[[nodiscard]] view::Scene shown_scene(const Workpiece& workpiece);

/// A scene that is drilled, and shown: the loop in its thread, and beside it the thread that calls `frame` and `obey`,
/// which feeds the server and hands commands on.
class ViewSession {
 public:
  /// Makes all that the scene needs, in any thread; the server is told nothing yet.
  /// @param device  null: the pointer of the page
  ViewSession(ViewScene scene, view::ViewServer& server, Device* device);
  ~ViewSession();
  ViewSession(const ViewSession&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;

  /// Shows the scene.
  /// @param runs  whether a run begins too, or only with the next command
  void begin(bool runs);

  /// Begins a run, where none is under way.
  void start();

  /// Lets the hand go until `start` or the next command. A recording ends.
  void hold();

  /// What a page asks for. What cannot be is said to it in a sentence.
  void obey(const view::ViewCommand& command);

  /// Sixty times a second: what has changed to the server.
  /// @param seconds  since the last call
  void frame(double seconds);

  /// Whether the scene is wanted anew; once.
  [[nodiscard]] bool take_restart() { return std::exchange(wants_restart_, false); }
  /// The last tick, with what the loops before this one have removed.
  [[nodiscard]] LoopSnapshot latest();
  [[nodiscard]] const Tool& tool() const { return tool_; }
  [[nodiscard]] const std::string& name() const { return scene_.name; }
  /// Whether the model has obeyed all that was asked of it, and pages were told.
  [[nodiscard]] bool is_settled() const { return !owes_controls_; }
  [[nodiscard]] Device& device() { return device_ != nullptr ? *device_ : pointer_; }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }  ///< @pre no run is under way

 private:
  void build_loop();
  void pause();
  void change(Change change);
  void change_tool();
  void record(bool on);
  void begin_recording();
  void end_recording();
  void begin_cut();
  void send(LoopCommand&& command);
  void take_blocks();
  void send_pages();
  void send_controls();
  void send_sound(const LoopSnapshot& snapshot, double seconds);
  void tell_guard();
  [[nodiscard]] view::Instruments instruments(const LoopSnapshot& snapshot, double seconds);

  template <class Command>
  void handle(const Command& command) {
    send(command);
  }
  void handle(const view::MoveHand& command);
  void handle(const view::Stop&) { device().emergency_stop(); }
  void handle(const view::LookAt& command) {
    stream_.look_at(command.p_WQ);
    is_looked_at_ = true;
  }
  void handle(const view::SetControl& command);
  void handle(const view::Load&) {}  // of whoever makes sessions
  void handle(const view::WriterLeft&) { pause(); }

  ViewScene scene_;  // its workpiece has gone into the simulation
  view::ViewServer& server_;
  Device* device_;
  PointerHand pointer_;
  Simulation simulation_;
  ViewControls controls_;
  Tool tool_;
  WorkspaceMapOptions map_;
  SurfaceStream stream_;
  std::unique_ptr<SimulationModel> model_;
  std::unique_ptr<WatchedModel> watched_;
  std::unique_ptr<RealtimeLoop> loop_;
  std::unique_ptr<RunRecorder> recorder_;
  std::string recording_, last_failure_;
  LoopListener listener_;
  DrillSound sound_;
  std::vector<float> samples_;
  double owed_samples_ = 0, dissipated_ = 0, power_ = 0;
  double removed_at_mark_ = -1, removed_before_ = 0;  // [m^3] the second by the loops before this one
  std::uint64_t sent_ = 0;                            // commands to this loop
  std::uint64_t tick_before_ = 0;                     // the last of the run before
  bool pressed_ = false, touched_ = false, wants_restart_ = false, paused_ = true, begins_ = false,
       owes_controls_ = false, is_looked_at_ = false;
};

}  // namespace hapticut::cli
