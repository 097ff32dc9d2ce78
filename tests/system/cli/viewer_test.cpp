// SPDX-License-Identifier: Apache-2.0
// `hapticut view` without a browser: release of the hand, also while a scene loads, and the end of the program.
#include "page/session/viewer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/settings/scene.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/temporary_folder.hpp"
#include "system/cli/small_scene.hpp"
#include "unit/view/command_bytes.hpp"
#include "unit/view/view_client.hpp"

namespace hapticut::viewer_test {
namespace {

using namespace std::chrono_literals;
using apps::ViewScene;
using test::small_scene;
using view_test::Bytes;
using view_test::CommandKind;
using view_test::Page;
using view_test::soon;
using Clock = std::chrono::steady_clock;

constexpr auto kAtOnce = 100ms;  // maximum time of a stop
constexpr int kTries = 20;       // number of tries; the best counts, because the machine may be busy

/// Makes scenes. On request, a scene waits for a signal, and some scenes cannot be made.
class Maker {
 public:
  apps::Viewer::MakeScene function() {
    return [this](const std::string& name) {
      ++made;
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !slow_; });
      if (name == "none") throw Error("there is no scene 'none'.");
      if (broken) throw Error("the file is gone.");
      return small_scene(name);
    };
  }
  void set_slow(bool slow) {
    const std::lock_guard lock(mutex_);
    slow_ = slow;
    changed_.notify_all();
  }
  std::atomic<int> made{0};
  std::atomic<bool> broken{false};

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool slow_ = false;
};

/// Runs frames in a separate thread, like the program.
class Frames {
 public:
  explicit Frames(apps::Viewer& viewer)
      : thread_([this, &viewer] {
          while (!ends_) {
            viewer.frame();
            std::this_thread::sleep_for(10ms);
          }
        }) {}
  ~Frames() {
    ends_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

std::vector<std::uint8_t> load(const std::string& name) {
  Bytes bytes(CommandKind::load);
  for (const char c : name) bytes.add(c);
  return bytes.bytes;
}
const std::vector<std::uint8_t> kStop = Bytes(CommandKind::stop).bytes;
const std::vector<std::uint8_t> kUndo = Bytes(CommandKind::undo).bytes;

/// @return [s] time until the condition held; infinite after ten seconds
template <class Condition>
double seconds_until(const Condition& condition) {
  const auto begin = Clock::now();
  while (!condition()) {
    if (Clock::now() - begin > 10s) return INFINITY;
    std::this_thread::sleep_for(1ms);
  }
  return std::chrono::duration<double>(Clock::now() - begin).count();
}
/// Whether the motors may have a force. Locking memory before the first tick, and unlocking after the last one, take a
/// tenth of a second.
bool has_ticks(const Device& device) { return device.arming() != ArmingState::off; }

constexpr double kSoonEnough = std::chrono::duration<double>(kAtOnce).count();

/// A page that stores the notices it receives.
class Listener {
 public:
  explicit Listener(const view::ViewServer& server)
      : page_(server), thread_([this] {
          while (const auto message = page_.read())
            if (message->at(0) == std::uint8_t(view::MessageKind::notice)) {
              const std::lock_guard lock(mutex_);
              said_.emplace_back(message->begin() + 12, message->end());
            }
        }) {}
  ~Listener() {
    page_.vanish();
    thread_.join();
  }

  int count(const std::string& part) {
    const std::lock_guard lock(mutex_);
    return int(std::count_if(said_.begin(), said_.end(),
                             [&](const std::string& text) { return text.find(part) != std::string::npos; }));
  }

 private:
  Page page_;
  std::mutex mutex_;
  std::vector<std::string> said_;
  std::thread thread_;
};

TEST(Viewer, ReleasesTheHandWhenALoadBeginsAndStopsOnRequestMeanwhile) {
  double released = INFINITY, stopped = INFINITY;  // best case
  for (int n = 0; n < kTries && std::max(released, stopped) >= kSoonEnough; ++n) {
    Maker maker;
    const auto device = open_device("mock:rest");
    apps::Viewer viewer("first", {}, device.get(), maker.function());
    Page page(viewer.server());
    const Frames frames(viewer);
    ASSERT_TRUE(soon([&] { return has_ticks(*device); }));
    maker.set_slow(true);
    page.write(load("second"));
    released = std::min(released, seconds_until([&] { return !has_ticks(*device); }));
    page.write(kUndo);  // a command must not begin a run now
    page.write(kStop);
    stopped = std::min(stopped, seconds_until([&] { return device->requests().emergency(); }));
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(has_ticks(*device));
    maker.set_slow(false);
    ASSERT_TRUE(soon([&] { return device->is_running(); })) << "the next scene";
    EXPECT_TRUE(soon([&] { return device->arming() == ArmingState::fault; })) << "the stop still holds";
    EXPECT_EQ(maker.made, 2);
  }
  EXPECT_LT(released, kSoonEnough);
  EXPECT_LT(stopped, kSoonEnough);
}

TEST(Viewer, StopsOnRequestAndOnTheLossOfThePageInEveryState) {
  for (const bool stop : {true, false}) {
    double at_best = INFINITY;  // best of some tries, because the machine may be busy
    for (int n = 0; n < kTries && at_best >= kSoonEnough; ++n) {
      Maker maker;
      const auto device = open_device("mock:rest");
      apps::Viewer viewer("first", {}, device.get(), maker.function());
      auto page = std::make_unique<Page>(viewer.server());
      ASSERT_TRUE(page->read());
      ASSERT_TRUE(soon([&] { return has_ticks(*device); }));
      // `frame` is not called: the program is busy.
      stop ? page->write(kStop) : page.reset();
      const auto is_gone = [&] { return stop ? device->arming() == ArmingState::fault : !has_ticks(*device); };
      at_best = std::min(at_best, seconds_until(is_gone));
    }
    EXPECT_LT(at_best, kSoonEnough) << stop;
  }
}

TEST(Viewer, AStopOfThePointerHoldsInTheNextScene) {
  Maker maker;
  apps::Viewer viewer("first", {}, nullptr, maker.function());
  Page page(viewer.server());
  const Frames frames(viewer);
  Listener listener(viewer.server());
  maker.set_slow(true);
  page.write(load("second"));
  ASSERT_TRUE(soon([&] { return maker.made == 2; }));
  page.write(kStop);
  std::this_thread::sleep_for(50ms);
  maker.set_slow(false);
  ASSERT_TRUE(soon([&] { return listener.count("second is ready") == 1; }));
  EXPECT_TRUE(soon([&] { return viewer.device().arming() == ArmingState::fault; }));
}

TEST(Viewer, EndsWithoutAnErrorInEveryState) {
  // Each of these sequences once aborted the program.
  {
    Maker maker;
    apps::Viewer viewer("first", {}, nullptr, maker.function());
    {
      Page page(viewer.server());
      ASSERT_TRUE(page.read());
    }
    ASSERT_TRUE(soon([&] { return viewer.server().connections() == 0; }));
    viewer.frame();
  }
  {
    Maker maker;
    apps::Viewer viewer("first", {}, nullptr, maker.function());
    {
      Page page(viewer.server());
      ASSERT_TRUE(page.read());
    }
    ASSERT_TRUE(soon([&] { return viewer.server().connections() == 0; }));
    viewer.frame();
    Page next(viewer.server());
    next.write(load("second"));  // the first command
    ASSERT_TRUE(soon([&] { return viewer.frame(), maker.made == 2 && !viewer.is_loading(); }));
  }
  {
    Maker maker;
    MockOptions options;
    options.end = 0.05;  // then the device disconnects
    MockDevice device(options);
    apps::Viewer viewer("first", {}, &device, maker.function());
    ASSERT_TRUE(soon([&] { return viewer.frame(), !device.is_running(); }));
    viewer.frame();
    Page page(viewer.server());
    page.write(load("second"));
    ASSERT_TRUE(soon([&] { return viewer.frame(), maker.made == 2 && !viewer.is_loading(); }));
  }
}

TEST(Viewer, ASceneThatCannotBeMadeIsReportedOnceAndThePreviousOneContinues) {
  Maker maker;
  const auto device = open_device("mock:rest");
  apps::Viewer viewer("first", {}, device.get(), maker.function());
  Page page(viewer.server());
  {
    const Frames frames(viewer);
    Listener listener(viewer.server());
    page.write(load("none"));
    EXPECT_TRUE(soon([&] { return listener.count("There is no scene 'none'") == 1; }));
    EXPECT_TRUE(soon([&] { return device->is_running(); })) << "the first scene continues";
    maker.broken = true;
    const apps::ViewControls controls(small_scene("").tool, small_scene("").workpiece.materials(), {}, true);
    for (const view::Control& control : controls.all())
      if (control.label == "Restart") page.write(Bytes(CommandKind::set_control).add(control.id).add(1.0).bytes);
    EXPECT_TRUE(soon([&] { return listener.count("The file is gone") == 1; }));
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(listener.count("The file is gone"), 1) << "it is tried once";
    EXPECT_EQ(maker.made, 3);
  }
}

TEST(Viewer, ALoadWhileOneIsUnderWayIsRefusedInASentence) {
  Maker maker;
  apps::Viewer viewer("first", {}, nullptr, maker.function());
  Page page(viewer.server());
  const Frames frames(viewer);
  Listener listener(viewer.server());
  maker.set_slow(true);
  page.write(load("second"));
  page.write(load("third"));
  EXPECT_TRUE(soon([&] { return listener.count("second is still loading") == 1; }));
  maker.set_slow(false);
  EXPECT_TRUE(soon([&] { return listener.count("second is ready") == 1; }));
  EXPECT_EQ(maker.made, 2);
}

TEST(Viewer, ASceneWithoutAWriterStartsNoRun) {
  Maker maker;
  const auto device = open_device("mock:rest");
  apps::Viewer viewer("first", {}, device.get(), maker.function());
  const Frames frames(viewer);
  {
    Page page(viewer.server());
    maker.set_slow(true);
    page.write(load("second"));
    ASSERT_TRUE(soon([&] { return maker.made == 2; }));
  }
  ASSERT_TRUE(soon([&] { return viewer.server().connections() == 0; }));
  std::this_thread::sleep_for(50ms);
  maker.set_slow(false);
  std::this_thread::sleep_for(300ms);
  EXPECT_FALSE(device->is_running());
  Page page(viewer.server());
  page.write(kUndo);
  EXPECT_TRUE(soon([&] { return device->is_running(); })) << "a page has control again";
}

}  // namespace
}  // namespace hapticut::viewer_test
