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

#include "cli/view/view_session.hpp"
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

/// The built page: beside the program in a build tree and in an installed one.
std::filesystem::path find_page(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {"../../web/page", "../share/hapticut/web"})
    if (std::filesystem::exists(program / place / "index.html", error))
      return std::filesystem::weakly_canonical(program / place);
  throw Error(
      "the page is not beside this program, for it was built without npm. Install npm, configure and build "
      "again, or name the folder of a built page by --page.");
}

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
      : device_(device), server_(shown_scene(scene), options) {
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
      server_.show(shown_scene(scene));
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

void run_view(const ViewSettings& s) {
  view::ViewServerOptions options;
  options.page = find_page(s.page);
  options.port = int(s.port);
  use_all_devices();
  std::unique_ptr<Device> device;
  if (!s.device.empty()) device = open_device(s.device);
  const StopSignals signals;
  Viewer viewer(make_view_scene(s.scene), options, device.get());
  std::printf("hapticut view: %s\nopen it in a browser of this machine; Ctrl-C ends it\n", viewer.address().c_str());
  std::fflush(stdout);
  if (!s.no_browser) open_browser(viewer.address());
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
  return {"view",
          "Drill a scene in a browser, beside the real-time loop",
          {text("view.scene", "SCENE", settings->scene,
                "clay, molar, skull, a settings file (.toml), or a file that is a workpiece [molar]"),
           text("view.device", "--device", settings->device,
                "name of the device that leads: openhaptics, ... [the pointer of the page]"),
           number("view.port", "--port", settings->port, Range::between(0, 65535),
                  "of this machine to listen at; 0: any that is free [0]"),
           text("view.page", "--page", settings->page, "folder of the built page [beside the program]"),
           boolean("view.no_browser", "--no_browser", settings->no_browser, "opens no browser")},
          [settings] { run_view(*settings); }};
}

}  // namespace hapticut::cli
