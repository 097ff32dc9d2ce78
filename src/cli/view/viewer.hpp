// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include "cli/view/view_session.hpp"

namespace hapticut::cli {

/// The way from a page to the motors that waits for nothing: a Stop, and that nobody leads any more. For any thread.
class StopLine {
 public:
  /// @param device  null: none that could run
  void lead_to(Device* device);
  void hear(const view::ViewCommand& command);

 private:
  std::mutex mutex_;
  Device* device_ = nullptr;
  bool stopped_ = false;  // while it led to none
};

/// Shows scenes, one after the other. A scene is loaded beside the thread that takes commands, while the hand is let go
/// and the scene before is still seen.
class Viewer {
 public:
  using MakeScene = std::function<ViewScene(const std::string& name)>;

  /// @param device  null: the pointer of the page
  /// @throws Error when the first scene cannot be made, or the page not be served
  Viewer(const std::string& scene, view::ViewServerOptions options, Device* device,
         MakeScene make_scene = make_view_scene);

  /// Waits for a scene that is being loaded; the hand is let go before.
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Sixty times a second: obeys what pages have asked for, and tells them what has changed.
  void frame();

  [[nodiscard]] bool is_loading() const { return loading_.valid(); }
  [[nodiscard]] const view::ViewServer& server() const { return server_; }
  [[nodiscard]] Device& device() { return session_->device(); }  ///< that leads; of this scene

  /// Lets go of everything but of a scene that is being loaded.
  void end() { replace(nullptr); }

 private:
  void obey(const view::ViewCommand& command);
  void load(const std::string& name);
  void finish_loading();
  void replace(std::unique_ptr<ViewSession> next);

  MakeScene make_scene_;
  Device* device_;
  StopLine stop_line_;
  view::ViewServer server_;
  std::unique_ptr<ViewSession> session_;
  std::string loaded_;  // name of what is being loaded
  bool is_led_ = true;  // by a page, since loading began
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::future<std::unique_ptr<ViewSession>> loading_;  // waits at its end
};

}  // namespace hapticut::cli
