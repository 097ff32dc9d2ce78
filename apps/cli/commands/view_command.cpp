// SPDX-License-Identifier: Apache-2.0
// hapticut view: a scene to drill in a browser, next to the real-time loop.
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
#include "reports/fail_without.hpp"
#ifdef HAPTICUT_HAS_VIEW
#include <sys/wait.h>
#include <unistd.h>

#include "import/mesh/mesh_extensions.hpp"
#include "page/session/page_folder.hpp"
#include "page/session/viewer.hpp"
#ifdef HAPTICUT_HAS_IO
#include "page/session/replay_page.hpp"
#endif
#endif

namespace hapticut::apps {

using namespace settings;

namespace {

struct ViewSettings {
  std::string scene = "molar";
  std::string device, page;
  std::size_t port = 0;
  bool no_browser = false, heat = false, remove_loose_pieces = false;
};

#ifdef HAPTICUT_HAS_VIEW
constexpr auto kViewFrame = std::chrono::microseconds(16'667);

/// Opens a browser if there is a screen. The process is detached, so nothing waits for it.
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
/// A recording needs no loop: its page plays without one.
void show_recording(const ViewSettings& s, view::ViewServerOptions options) {
  const Recording recording = read_recording(s.scene);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hapticut-view-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  write_replay_folder(recording, options.page, folder);
  options.page = folder;
  const StopSignals signals;
  const view::ViewServer server({}, options);
  std::filesystem::remove_all(folder);  // the server has already read the folder
  announce(server.address(), s.no_browser);
  while (StopSignals::came() == 0) std::this_thread::sleep_for(kViewFrame);
}
#endif

void run_view(const ViewSettings& s) {
  view::ViewServerOptions options;
  options.page = find_page(s.page);
  options.port = int(s.port);
  if (extension_in_lower_case(s.scene) == ".h5") {
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
  Viewer viewer(s.scene, options, device.get(), [&s](const std::string& name) {
    ViewScene scene = make_view_scene(name);
    scene.shows_heat = scene.shows_heat || s.heat;
    scene.removes_loose_pieces = scene.removes_loose_pieces || s.remove_loose_pieces;
    return scene;
  });
  announce(viewer.server().address(), s.no_browser);
  while (StopSignals::came() == 0) {
    const auto next = std::chrono::steady_clock::now() + kViewFrame;
    viewer.frame();
    std::this_thread::sleep_until(next);
  }
  if (!viewer.is_loading()) return;
  viewer.end();
  device.reset();
  std::_Exit(0);  // does not wait for a scene that is still loading
}
#else
void run_view(const ViewSettings&) { fail_without("view", "there is no page to show"); }
#endif

}  // namespace

Command view_command() {
  auto settings = std::make_shared<ViewSettings>();
  return {
      "view",
      "Drill a scene in a browser, with the real-time loop",
      {path("view.scene", "SCENE", settings->scene,
            "scene: clay, molar, skull, a settings file (.toml), a workpiece (.vdb), or a recording (.h5) to replay "
            "[molar]",
            {"clay", "molar", "skull"}),
       text("view.device", "--device", settings->device,
            "device that moves the tool: openhaptics, ... [the pointer of the page]"),
       integer("view.port", "--port", settings->port, 0, 65535, "TCP port of the server; 0: any free port [0]"),
       path("view.page", "--page", settings->page, "folder of the built page [next to the program]"),
       boolean("view.no_browser", "--no_browser", settings->no_browser, "does not open a browser"),
       boolean("view.heat", "--heat", settings->heat, "shows the temperatures of every scene [as the scene says]"),
       boolean("view.remove_loose_pieces", "--remove_loose_pieces", settings->remove_loose_pieces,
               "removes pieces that the tool has cut loose, in every scene [as the scene says]")},
      [settings] { run_view(*settings); }};
}

}  // namespace hapticut::apps
