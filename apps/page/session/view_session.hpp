// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hapticut/islands/island_watch.hpp"
#include "hapticut/sound/loop_listener.hpp"
#include "hapticut/surface/surface_stream.hpp"
#include "hapticut/view/view_server.hpp"
#include "page/session/heat_watch.hpp"
#include "page/session/pointer_hand.hpp"
#include "page/session/view_controls.hpp"
#include "page/session/view_scenes.hpp"
#include "page/session/watched_model.hpp"
#include "reports/recording_source.hpp"

namespace hapticut::apps {

/// An error as a sentence for a page. Messages of the program begin with a small letter.
[[nodiscard]] std::string as_sentence(const std::exception& error);

/// The description of a scene that pages receive first.
[[nodiscard]] view::Scene shown_scene(const Workpiece& workpiece);

/// A scene being drilled and shown. The loop runs in its own thread. Another thread calls `frame` and `apply`, which
/// feed the server and forward commands.
class ViewSession {
 public:
  /// Makes everything that the scene needs, in any thread. Sends nothing to the server.
  /// @param device  null: the pointer of the page
  ViewSession(ViewScene scene, view::ViewServer& server, Device* device);
  ~ViewSession();
  ViewSession(const ViewSession&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;

  /// Shows the scene.
  /// @param runs  true: begins a run; false: the next command begins it
  void begin(bool runs);

  /// Begins a run unless one is in progress.
  void start();

  /// Releases the hand until `start` or the next command. Ends a recording.
  void suspend();

  /// Executes a command of a page. If that fails, sends a notice to the page.
  void apply(const view::ViewCommand& command);

  /// Sends all changes to the server; called sixty times per second.
  /// @param seconds  since the last call
  void frame(double seconds);

  /// Whether a page has requested a restart; resets the request.
  [[nodiscard]] bool consume_restart() { return std::exchange(restart_requested_, false); }
  /// The last tick, including the volume removed by earlier loops.
  [[nodiscard]] LoopSnapshot latest();
  [[nodiscard]] const Tool& tool() const { return tool_; }
  [[nodiscard]] const std::string& name() const { return scene_.name; }
  /// Whether the model has processed all commands and the pages have the result.
  [[nodiscard]] bool is_settled() const { return !controls_outdated_; }
  [[nodiscard]] Device& device() { return device_ != nullptr ? *device_ : pointer_; }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }  ///< @pre no run is in progress

 private:
  void build_loop();
  void renew_heat();
  void renew_islands();
  void connect_islands();
  void beside_runs(const std::function<void()>& make);
  void pause();
  void change(Change change);
  void change_tool();
  void change_heat();
  void record(bool on);
  void begin_recording();
  void end_recording();
  void begin_cut();
  void send(LoopCommand&& command);
  void drain_blocks();
  void send_pages();
  void send_controls();
  void send_sound(const LoopSnapshot& snapshot, double seconds);
  void send_guard_notice();
  void send_heat();
  void send_loose_pieces();
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
  void handle(const commands::Undo& command) {
    removed_at_mark_ = -1;  // the mark is used up
    send(command);
  }
  void handle(const view::Load&) {}  // handled by the Viewer
  void handle(const view::WriterLeft&) { pause(); }

  ViewScene scene_;  // its workpiece was moved into the simulation
  view::ViewServer& server_;
  Device* device_;
  PointerHand pointer_;
  Simulation simulation_;
  ViewControls controls_;
  Tool tool_;
  WorkspaceMapOptions map_;
  SurfaceStream stream_;
  std::unique_ptr<HeatWatch> heat_;       // null: off
  std::unique_ptr<IslandWatch> islands_;  // null: loose pieces stay
  std::unique_ptr<SimulationModel> model_;
  std::unique_ptr<WatchedModel> watched_;
  std::unique_ptr<RealtimeLoop> loop_;
  std::unique_ptr<RunRecorder> recorder_;
  std::string recording_, last_failure_;
  LoopListener listener_;
  DrillSound sound_;
  std::vector<float> samples_;
  double due_samples_ = 0, dissipated_ = 0, power_ = 0;
  double removed_at_mark_ = -1, removed_before_ = 0;  // [m^3] at the last undo mark; by earlier loops
  std::vector<double> forces_;                        // [N] shown mean by material id from 1
  std::uint64_t told_pieces_ = 0;                     // removed pieces of which pages were told
  std::uint64_t sent_ = 0;                            // number of commands sent to this loop
  std::uint64_t tick_before_ = 0;                     // last tick of the previous run
  bool pressed_ = false, touched_ = false, restart_requested_ = false, paused_ = true, begins_ = false,
       controls_outdated_ = false, is_looked_at_ = false;
};

}  // namespace hapticut::apps
