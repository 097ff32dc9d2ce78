// SPDX-License-Identifier: Apache-2.0
// hapticut view: a scene to be drilled in a browser, beside the loop.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <thread>

#include "cli/commands/command.hpp"
#include "cli/commands/devices.hpp"
#include "cli/commands/stop_signals.hpp"
#include "hapticut/core/errors.hpp"
#ifdef HAPTICUT_HAS_VIEW
#include <sys/wait.h>
#include <unistd.h>

#include "cli/view/page_folder.hpp"
#include "cli/view/view_session.hpp"
#ifdef HAPTICUT_HAS_IO
#include "cli/view/replay_page.hpp"
#endif
#endif

namespace hapticut::cli {

using namespace settings;

namespace {

struct ViewSettings {
  std::string scene = "molar";
  std::string device, page;
  double port = 0;
  bool no_browser = false;
};

#ifdef HAPTICUT_HAS_VIEW
using FrameClock = std::chrono::steady_clock;
constexpr auto kViewFrame = std::chrono::microseconds(16'667);

/// Opens a browser in a process of its own, where there is a screen. @return whether it was begun
bool open_browser(const std::string& address) {
  const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) return false;
  const pid_t child = ::fork();
  if (child == 0) {
    ::execlp("xdg-open", "xdg-open", address.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Shows scenes, one after the other, until it is stopped.
class Viewer {
 public:
  Viewer(ViewScene scene, const view::ViewServerOptions& options, Device* device)
      : device_(device), server_(shown_scene(scene.workpiece), options) {
    session_ = std::make_unique<ViewSession>(std::move(scene), server_, device_);
  }

  [[nodiscard]] std::string address() const { return server_.address(); }

  void run() {
    auto last = FrameClock::now();
    while (StopSignals::came() == 0) {
      const auto now = FrameClock::now();
      while (const auto command = server_.receive()) obey(*command);
      session_->frame(std::chrono::duration<double>(now - std::exchange(last, now)).count());
      if (session_->wants_restart()) load(session_->name());
      std::this_thread::sleep_until(now + kViewFrame);
    }
  }

 private:
  void obey(const view::ViewCommand& command) {
    if (const auto* wanted = std::get_if<view::Load>(&command)) return load(wanted->name);
    session_->obey(command);
  }

  void load(const std::string& name) {
    server_.send_notice(view::Severity::tells, "Loading " + name + " ...");
    try {
      ViewScene scene = make_view_scene(name);
      session_.reset();  // before the next uses its device
      server_.show(shown_scene(scene.workpiece));
      session_ = std::make_unique<ViewSession>(std::move(scene), server_, device_);
      server_.send_notice(view::Severity::tells, name + " is ready.");
    } catch (const Error& error) {
      server_.send_notice(view::Severity::failed, error.what());
      if (session_ == nullptr) throw;
    }
  }

  Device* device_;
  view::ViewServer server_;
  std::unique_ptr<ViewSession> session_;
};

void announce(const std::string& address, bool no_browser) {
  std::printf("hapticut view: %s\nopen it in a browser of this machine; Ctrl-C ends it\n", address.c_str());
  std::fflush(stdout);
  if (!no_browser) open_browser(address);
}

#ifdef HAPTICUT_HAS_IO
/// A recording is a page that needs no loop: it plays by itself.
void show_recording(const ViewSettings& s, view::ViewServerOptions options) {
  const Recording recording = read_recording(s.scene);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hapticut-view-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  write_replay_folder(recording, options.page, folder);
  options.page = folder;
  const StopSignals signals;
  const view::ViewServer server({}, options);
  std::filesystem::remove_all(folder);  // the server has read it
  announce(server.address(), s.no_browser);
  while (StopSignals::came() == 0) std::this_thread::sleep_for(kViewFrame);
}
#endif

void run_view(const ViewSettings& s) {
  view::ViewServerOptions options;
  options.page = find_page(s.page);
  options.port = int(s.port);
  if (s.scene.ends_with(".h5")) {
#ifdef HAPTICUT_HAS_IO
    return show_recording(s, options);
#else
    throw Error("'" + s.scene +
                "' cannot be read, because this program was built without its io component. Build it "
                "with HAPTICUT_WITH_IO=ON.");
#endif
  }
  use_all_devices();
  std::unique_ptr<Device> device;
  if (!s.device.empty()) device = open_device(s.device);
  const StopSignals signals;
  Viewer viewer(make_view_scene(s.scene), options, device.get());
  announce(viewer.address(), s.no_browser);
  viewer.run();
}
#else
void run_view(const ViewSettings&) {
  throw Error("this program was built without its view component. Build it with HAPTICUT_WITH_VIEW=ON.");
}
#endif

}  // namespace

Command view_command() {
  auto settings = std::make_shared<ViewSettings>();
  return {
      "view",
      "Drill a scene in a browser, beside the real-time loop",
      {text("view.scene", "SCENE", settings->scene,
            "clay, molar, skull, a settings file (.toml), a workpiece, or a recording (.h5) to be replayed [molar]"),
       text("view.device", "--device", settings->device,
            "name of the device that leads: openhaptics, ... [the pointer of the page]"),
       number("view.port", "--port", settings->port, Range::between(0, 65535),
              "of this machine to listen at; 0: any that is free [0]"),
       text("view.page", "--page", settings->page, "folder of the built page [beside the program]"),
       boolean("view.no_browser", "--no_browser", settings->no_browser, "opens no browser")},
      [settings] { run_view(*settings); }};
}

}  // namespace hapticut::cli
