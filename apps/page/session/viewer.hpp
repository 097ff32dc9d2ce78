// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include "page/session/view_session.hpp"

namespace hapticut::apps {

/// Forwards urgent commands from a page to the motors without waiting: Stop, and the loss of the page that moves the
/// tool. For any thread.
class StopLine {
 public:
  /// @param device  null: no device can run
  void set_device(Device* device);
  void handle(const view::ViewCommand& command);

 private:
  std::mutex mutex_;
  Device* device_ = nullptr;
  bool stopped_ = false;  // a stop arrived while there was no device
};

/// Shows one scene after another. A scene loads in a separate thread; meanwhile the hand is released and the previous
/// scene stays visible.
class Viewer {
 public:
  using MakeScene = std::function<ViewScene(const std::string& name)>;

  /// @param device  null: the pointer of the page
  /// @throws Error when the first scene cannot be made, or the page cannot be served
  Viewer(const std::string& scene, view::ViewServerOptions options, Device* device,
         MakeScene make_scene = make_view_scene);

  /// Releases the hand, then waits for a scene that is loading.
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Executes the commands of pages and sends them all changes; called sixty times per second.
  void frame();

  [[nodiscard]] bool is_loading() const { return loading_.valid(); }
  [[nodiscard]] const view::ViewServer& server() const { return server_; }
  [[nodiscard]] Device& device() { return session_->device(); }  ///< device that moves the tool in the present scene

  /// Ends the session; a scene that is loading continues.
  void end() { replace(nullptr); }

 private:
  void apply(const view::ViewCommand& command);
  void load(const std::string& name);
  void finish_loading();
  void replace(std::unique_ptr<ViewSession> next);

  MakeScene make_scene_;
  Device* device_;
  StopLine stop_line_;
  view::ViewServer server_;
  std::unique_ptr<ViewSession> session_;
  std::string loaded_;      // name of the loading scene
  bool has_writer_ = true;  // a page has had control since loading began
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::future<std::unique_ptr<ViewSession>> loading_;  // its destructor waits
};

}  // namespace hapticut::apps
