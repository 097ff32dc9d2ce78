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
#include "cli/view/viewer.hpp"
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
constexpr auto kViewFrame = std::chrono::microseconds(16'667);

/// Opens a browser, where there is a screen. It is nobody's child, so that nobody waits for it.
void open_browser(const std::string& address) {
  const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) return;
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    if (::fork() == 0) ::execlp("xdg-open", "xdg-open", address.c_str(), static_cast<char*>(nullptr));
    ::_exit(0);
  }
  if (child > 0) ::waitpid(child, nullptr, 0);
}

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
    fail_without("io", "'" + s.scene + "' cannot be read");
#endif
  }
  use_all_devices();
  std::unique_ptr<Device> device;
  if (!s.device.empty()) device = open_device(s.device);
  const StopSignals signals;
  Viewer viewer(s.scene, options, device.get());
  announce(viewer.server().address(), s.no_browser);
  while (StopSignals::came() == 0) {
    const auto next = std::chrono::steady_clock::now() + kViewFrame;
    viewer.frame();
    std::this_thread::sleep_until(next);
  }
  if (!viewer.is_loading()) return;
  viewer.end();
  device.reset();
  std::_Exit(0);  // nobody waits for a scene that nobody will see
}
#else
void run_view(const ViewSettings&) { fail_without("view", "there is no page to show"); }
#endif

}  // namespace

Command view_command() {
  auto settings = std::make_shared<ViewSettings>();
  return {"view",
          "Drill a scene in a browser, beside the real-time loop",
          {path("view.scene", "SCENE", settings->scene,
                "clay, molar, skull, a settings file (.toml), a workpiece, or a recording (.h5) to be replayed [molar]",
                {"clay", "molar", "skull"}),
           text("view.device", "--device", settings->device,
                "name of the device that leads: openhaptics, ... [the pointer of the page]"),
           number("view.port", "--port", settings->port, Range::between(0, 65535),
                  "of this machine to listen at; 0: any that is free [0]"),
           path("view.page", "--page", settings->page, "folder of the built page [beside the program]"),
           boolean("view.no_browser", "--no_browser", settings->no_browser, "opens no browser")},
          [settings] { run_view(*settings); }};
}

}  // namespace hapticut::cli
