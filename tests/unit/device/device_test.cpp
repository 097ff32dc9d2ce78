// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/device.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "hapticut/bench/closed_loop.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"

namespace hapticut::device_test {
namespace {

/// Exact periods, no wall clock.
RunOptions simulated(double seconds) {
  RunOptions options;
  options.seconds = seconds;
  options.simulated_time = true;
  return options;
}

/// A real clock without what needs privileges, and quickly armed.
RunOptions real(double seconds) {
  RunOptions options;
  options.seconds = seconds;
  options.realtime.priority = 0;
  options.realtime.lock_memory = false;
  options.guard.arming.ramp = 0.02;
  return options;
}

DeviceCommand wall(const DeviceState& state) {
  DeviceCommand command;
  command.wrench.force.z() = std::max(0.0, -300 * state.X_BS.translation.z());
  return command;
}

/// Remembers what was written, and can be told to misbehave.
class WrittenDevice : public PolledDevice {
 public:
  WrittenDevice() : PolledDevice("written", capabilities_of_a_touch()) {}
  std::vector<Vec3> forces;
  std::function<bool(DeviceState&)> next = [](DeviceState&) { return true; };
  std::function<void(const Vec3&)> on_write = [](const Vec3&) {};
  std::atomic<double> share{1};

 protected:
  static DeviceCapabilities capabilities_of_a_touch() { return hapticut::capabilities(device_model("touch")); }
  bool read(DeviceState& state) noexcept override {
    ++state.sequence;
    state.time = double(state.sequence) * 1e-3;
    return next(state);
  }
  Wrench write(const Wrench& wrench) noexcept override {
    forces.push_back(wrench.force);
    on_write(wrench.force);
    return wrench;
  }
  void scale_output(double s) noexcept override { share.store(s); }
  [[nodiscard]] bool is_simulated() const override { return true; }
};

/// No force at first, so that the guard lets go, and 1 N from then on.
DeviceCallback pushing(double from = 0.1) {
  return [=](const DeviceState& state) {
    DeviceCommand command;
    if (state.time > from) command.wrench.force.x() = 1;
    return command;
  };
}

TEST(OpenDevice, SaysWhatWasAskedWhatThereIsAndWhatToInstall) {
  try {
    (void)open_device("falcon:1");
    FAIL();
  } catch (const Error& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("falcon:1"), std::string::npos) << text;
    EXPECT_NE(text.find("mock:PATH"), std::string::npos) << text;
    EXPECT_NE(text.find("openhaptics[:NAME]"), std::string::npos) << text;
  }
  try {
    (void)open_device("mock:figure-of-eight");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("spiral"), std::string::npos) << e.what();
  }
  EXPECT_THROW((void)open_device("mock:spiral,hand=robot"), Error);
  EXPECT_THROW((void)open_device("mock:spiral,speed=3"), Error);
  EXPECT_THROW((void)open_device("mock:spiral,seconds=-1"), Error);
}

TEST(OpenDevice, FindsDriversThatOthersRegister) {
  register_device_driver(
      {"written", "written", "", [](const std::string&) { return std::make_unique<WrittenDevice>(); }});
  EXPECT_EQ(open_device("written")->name(), "written");
  register_device_driver({"written", "written", "the moon", nullptr});
  try {
    (void)open_device("written");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("install the moon"), std::string::npos) << e.what();
  }
}

TEST(MockDevice, FollowsItsPathExactlyWhenRigid) {
  const auto device = open_device("mock:spiral");
  const ScriptedPath path = scripted_path("spiral");
  long ticks = 0;
  const RunReport report = device->run(
      [&](const DeviceState& state) {
        EXPECT_EQ(state.X_BS.translation, path(double(ticks++) * 1e-3).translation);
        return wall(state);
      },
      simulated(5));
  EXPECT_EQ(report.ticks, 5001U);
  EXPECT_EQ(report.guard, ArmingState::on);
  EXPECT_EQ(report.missed, 0U);
}

TEST(MockDevice, IsMovedByTheForceWhenAHandHoldsIt) {
  const auto deepest = [](const char* name) {
    double z = 0;
    open_device(name)->run(
        [&](const DeviceState& state) {
          z = state.X_BS.translation.z();
          return wall(state);
        },
        simulated(6));
    return z;
  };
  EXPECT_NEAR(deepest("mock:press"), -5e-3, 1e-9);
  // The set point is 5 mm deep; hand and wall of 300 N/m each share the way, give or take dry friction and encoder.
  EXPECT_NEAR(deepest("mock:press,hand=nominal"), -2.5e-3, 0.3e-3);
  EXPECT_LT(deepest("mock:press,hand=firm"), deepest("mock:press,hand=light"));
}

TEST(MockDevice, GivesTheSameReadingsOnEveryRun) {
  const auto run = [] {
    std::vector<Vec3> positions;
    open_device("mock:circle,hand=nominal-pad,device=premium6dof")
        ->run(
            [&](const DeviceState& state) {
              positions.push_back(state.X_BS.translation);
              return wall(state);
            },
            simulated(4));
    return positions;
  };
  EXPECT_EQ(run(), run());
}

TEST(MockDevice, EndsWhenItsScriptEnds) {
  const RunReport report = open_device("mock:line,seconds=0.5")->run(wall, simulated(0));
  EXPECT_EQ(report.ticks, 500U);
  EXPECT_EQ(report.end, "the device has nothing more to tell");
}

TEST(Device, ReachesEveryStateOfItsRunFromOtherThreads) {
  const auto device = open_device("mock:press");
  std::thread observer;
  std::atomic<bool> seen{false}, begun{false};
  observer = std::thread([&] {
    while (!begun.load()) std::this_thread::yield();
    while (device->is_running()) {
      const DeviceOutput output = device->output();
      const DeviceState state = device->state();
      if (output.applied.force.z() > 0.1 && state.sequence > 0 && device->arming() == ArmingState::on) {
        seen.store(true);
        device->stop();
      }
    }
  });
  const RunReport report = device->run(
      [&](const DeviceState& state) {
        begun.store(true);
        return wall(state);
      },
      simulated(0));
  observer.join();
  EXPECT_TRUE(seen.load());
  EXPECT_EQ(report.end, "stopped");
  EXPECT_GT(report.events[std::size_t(SafetyEvent::engaged)], 0U);
}

TEST(Device, FadesTheForceOutBeforeARunEnds) {
  WrittenDevice device;
  RunOptions options = simulated(3);
  device.run(pushing(), options);
  ASSERT_GT(device.forces.size(), 40U);
  EXPECT_TRUE(device.forces.back().isZero(0));
  const std::size_t end = device.forces.size();
  for (std::size_t n = end - 20; n < end; ++n) {
    EXPECT_LT(device.forces[n].x(), device.forces[n - 1].x());
    EXPECT_NEAR(device.forces[n - 1].x() - device.forces[n].x(), 1.0 / 20, 1e-9);
  }
}

TEST(Device, GivesNoForceAfterTheCallbackThrewAndPassesTheExceptionOn) {
  WrittenDevice device;
  const DeviceCallback push = pushing();
  const auto throwing = [&](const DeviceState& state) {
    if (state.time > 2.5) throw std::runtime_error("tool broke");
    return push(state);
  };
  EXPECT_THROW(device.run(throwing, simulated(3)), std::runtime_error);
  EXPECT_TRUE(device.forces.back().isZero(0));
  EXPECT_TRUE(device.forces[device.forces.size() - 2].isZero(0));  // of the very tick that threw
  EXPECT_EQ(device.forces[device.forces.size() - 3].x(), 1);
  EXPECT_FALSE(device.is_running());
  EXPECT_EQ(device.count(SafetyEvent::exception), 1U);
}

TEST(Device, EndsWithoutForceWhenItIsUnplugged) {
  WrittenDevice device;
  device.next = [](DeviceState& state) {
    if (state.time > 2.5) {
      state.fault = DeviceFault::disconnected;
      state.valid = false;
    }
    return true;
  };
  const RunReport report = device.run(pushing(), simulated(0));
  EXPECT_EQ(report.fault, DeviceFault::disconnected);
  EXPECT_NE(report.end.find("cable"), std::string::npos) << report.end;
  EXPECT_TRUE(device.forces.back().isZero(0));
  EXPECT_TRUE(device.forces[device.forces.size() - 2].isZero(0));
}

TEST(Device, CanRunAgain) {
  WrittenDevice device;
  for (int n = 0; n < 3; ++n) {
    device.forces.clear();
    EXPECT_EQ(device.run(pushing(), simulated(2)).guard, ArmingState::on);
    EXPECT_TRUE(device.forces.front().isZero(0));
    EXPECT_TRUE(device.forces.back().isZero(0));
  }
}

TEST(Device, RefusesToRunTwiceAtOnceAndWithoutACallback) {
  WrittenDevice device;
  EXPECT_THROW(device.run(nullptr), Error);
  device.run(
      [&](const DeviceState&) {
        EXPECT_THROW(device.run(pushing(), simulated(1)), Error);
        return DeviceCommand{{}, true};
      },
      simulated(1));
}

TEST(Device, EmergencyStopLastsUntilReset) {
  WrittenDevice device;
  const DeviceCallback push = pushing();
  const RunReport report = device.run(
      [&](const DeviceState& state) {
        if (std::abs(state.time - 2.5) < 1e-9) device.emergency_stop();
        if (std::abs(state.time - 3.0) < 1e-9) device.reset_fault();
        DeviceCommand command = push(state);
        if (state.time > 3 && state.time < 3.2) command.wrench = {};
        return command;
      },
      simulated(5.5));
  EXPECT_EQ(device.forces[2490].x(), 1);
  for (std::size_t n = 2501; n < 3190; ++n) EXPECT_TRUE(device.forces[n].isZero(0)) << n;
  EXPECT_EQ(device.forces[5400].x(), 1);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::fault)], 1U);
}

TEST(Device, AWatchdogFadesTheForceOfADeviceWhoseLoopHangs) {
  for (const bool latch : {false, true}) {
    WrittenDevice device;
    device.next = [](DeviceState& state) {
      state.time = monotonic_time();
      return true;
    };
    double least = 1;
    bool hung = false;
    RunOptions options = real(0);
    options.guard.watchdog.latch = latch;
    const RunReport report = device.run(
        [&](const DeviceState& state) {
          if (state.sequence == 20 && !std::exchange(hung, true))
            while (least = device.share.load(), device.count(SafetyEvent::watchdog_fault) == 0)
              std::this_thread::sleep_for(std::chrono::milliseconds(1));
          return DeviceCommand{{Vec3(0, 0, state.sequence > 20 ? 1 : 0), Vec3::Zero()}, state.sequence > 60};
        },
        options);
    EXPECT_EQ(least, 0);
    // The other thread has said so, in the order of what it saw; on a busy machine it may have woken up too late for
    // some.
    EXPECT_TRUE(std::any_of(report.log.begin(), report.log.end(), [](const SafetyLogEntry& entry) {
      return entry.event == SafetyEvent::watchdog_fault && entry.value == 0;
    }));
    // The loop that comes back late gives no force: it waits until the tool is free, or fails where it is told to.
    EXPECT_GE(report.events[std::size_t(SafetyEvent::paused)], 1U);
    EXPECT_EQ(report.guard, latch ? ArmingState::fault : ArmingState::wait_free);
    EXPECT_TRUE(device.forces.back().isZero(0));
  }
}

/// What a child process leaves behind of the last force it wrote.
struct SharedForce {
  SharedForce()
      : value(static_cast<std::atomic<double>*>(
            mmap(nullptr, sizeof(std::atomic<double>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {
    value->store(-1);
  }
  ~SharedForce() { munmap(value, sizeof(std::atomic<double>)); }
  std::atomic<double>* value;
};

/// The thread sanitizer cannot follow threads that a forked process begins.
#if defined(__SANITIZE_THREAD__)
constexpr bool kForksMayHaveThreads = false;
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
constexpr bool kForksMayHaveThreads = false;
#else
constexpr bool kForksMayHaveThreads = true;
#endif
#else
constexpr bool kForksMayHaveThreads = true;
#endif
constexpr const char* kNoForks = "the thread sanitizer cannot follow a process that was forked";

/// Runs `child` in a process of its own, sends it a signal once it renders a force, and returns how it ended.
int end_of_child(SharedForce& last, const std::function<void(WrittenDevice&)>& child, int signal) {
  const pid_t pid = fork();
  if (pid == 0) {
    WrittenDevice device;
    device.on_write = [&](const Vec3& force) { last.value->store(force.x()); };
    try {
      child(device);
    } catch (...) {
      _exit(98);
    }
    _exit(99);
  }
  for (int n = 0; n < 20000 && last.value->load() < 0.5; ++n) usleep(1000);
  if (signal != 0) kill(pid, signal);
  int status = 0;
  waitpid(pid, &status, 0);
  return status;
}

TEST(Device, LeavesNoForceWhenASignalEndsTheProcess) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    SharedForce last;
    const int status = end_of_child(
        last, [](WrittenDevice& device) { device.run(pushing(), real(0)); }, signal);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(last.value->load(), 0);
  }
}

TEST(Device, DoesNotMindASignalThatTheProcessIgnores) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  SharedForce last;
  const int status = end_of_child(
      last,
      [](WrittenDevice& device) {
        std::signal(SIGHUP, SIG_IGN);  // as nohup does
        if (device.run(pushing(), real(1)).ticks < 900) throw std::runtime_error("ended early");
      },
      SIGHUP);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 99) << status;
}

/// Runs a device whose force another thread ends, with the whole process, by `end`.
[[noreturn]] void run_until_another_thread(WrittenDevice& device, const std::atomic<double>& last,
                                           const std::function<void()>& end, bool stop_on_crash = false) {
  std::thread([&last, end] {
    while (last.load() < 0.5) usleep(1000);
    end();
  }).detach();
  RunOptions options = real(0);
  options.stop_on_crash = stop_on_crash;
  device.run(pushing(), options);
  for (;;) usleep(1000);
}

/// Reads from a page that nobody may read.
void touch_nothing() {
  volatile int* nothing = static_cast<int*>(mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  (void)*nothing;
}

/// The sanitizers have handlers of their own, which end the process by themselves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCrashesAreOurs = false;
#else
constexpr bool kCrashesAreOurs = true;
#endif

TEST(Device, LeavesNoForceWhenAnotherThreadCrashes) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  if (!kCrashesAreOurs) GTEST_SKIP() << "the sanitizer handles crashes";
  const std::pair<int, std::function<void()>> crashes[] = {
      {SIGABRT, [] { std::abort(); }}, {SIGSEGV, touch_nothing}, {SIGFPE, [] { raise(SIGFPE); }}};
  for (const auto& [signal, crash] : crashes) {
    SharedForce last;
    const int status = end_of_child(
        last, [&](WrittenDevice& device) { run_until_another_thread(device, *last.value, crash, true); }, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(last.value->load(), 0);
  }
}

TEST(Device, LeavesCrashesAloneUnlessItIsAskedTo) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  SharedForce last;
  const int status = end_of_child(
      last,
      [&](WrittenDevice& device) {
        RunOptions options = real(0.2);
        struct sigaction before {
        }, during{};
        sigaction(SIGSEGV, nullptr, &before);
        device.run(
            [&](const DeviceState& state) {
              sigaction(SIGSEGV, nullptr, &during);
              return pushing()(state);
            },
            options);
        if (before.sa_flags != during.sa_flags || before.sa_sigaction != during.sa_sigaction)
          throw std::runtime_error("somebody installed a handler");
      },
      0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 99) << status;
}

/// What a runtime that makes exceptions of crashes does: it has a handler on a stack of its own, looks at what the
/// kernel says, and goes on elsewhere.
namespace runtime {

sigjmp_buf elsewhere;  // NOLINT: of the one thread that crashes
volatile sig_atomic_t handled = 0, told_where = 0, on_its_stack = 0;
void* expected_address = nullptr;
alignas(16) char stack[64 * 1024];

extern "C" void hapticut_test_on_crash(int, siginfo_t* info, void* context) {
  char here = 0;
  handled = handled + 1;
  told_where = info->si_addr == expected_address && context != nullptr ? 1 : 0;
  on_its_stack = &here >= stack && &here < stack + sizeof stack ? 1 : 0;
  siglongjmp(elsewhere, 1);
}

void handle_crashes() {
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  action.sa_sigaction = hapticut_test_on_crash;
  sigaction(SIGSEGV, &action, nullptr);
}

}  // namespace runtime

TEST(Device, HandsACrashOnToARuntimeThatHandlesItAndComesBackAfterAReset) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  if (!kCrashesAreOurs) GTEST_SKIP() << "the sanitizer handles crashes";
  SharedForce last;
  const int status = end_of_child(
      last,
      [&](WrittenDevice& device) {
        runtime::handle_crashes();
        RunOptions options = real(0);
        options.stop_on_crash = true;
        options.guard.arming.short_ramp = 0.02;
        bool lived = false, was_quiet = false, came_back = false;
        std::thread managed([&] {
          const stack_t stack{runtime::stack, 0, sizeof runtime::stack};
          sigaltstack(&stack, nullptr);
          while (last.value->load() < 0.5) usleep(1000);
          runtime::expected_address = mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
          if (sigsetjmp(runtime::elsewhere, 1) == 0) (void)*static_cast<volatile int*>(runtime::expected_address);
          lived = runtime::handled == 1 && runtime::told_where == 1 && runtime::on_its_stack == 1;
          was_quiet = last.value->load() == 0 && device.arming() == ArmingState::fault;
          device.reset_fault();
          for (int n = 0; n < 5000 && !came_back; ++n, usleep(1000)) came_back = last.value->load() > 0.5;
          device.stop();
        });
        device.run(
            [free = 0, push = pushing()](const DeviceState& state) mutable {
              return ++free % 200 < 100 ? DeviceCommand{} : push(state);  // the tool is free now and then
            },
            options);
        managed.join();
        if (!lived) throw std::runtime_error("the runtime did not get its signal as it came");
        if (!was_quiet) throw std::runtime_error("there was a force in a crash");
        if (!came_back) throw std::runtime_error("there was no force after the reset");
        struct sigaction after {};
        sigaction(SIGSEGV, nullptr, &after);
        if (after.sa_sigaction != runtime::hapticut_test_on_crash) throw std::runtime_error("its handler was lost");
      },
      0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 99) << status;
}

std::atomic<double> last_force = -1;

TEST(Device, LeavesNoForceWhenAnotherThreadExits) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process from its start: one that was forked may hang at its exit
  const auto run_and_exit = [] {
    std::atexit([] { std::fprintf(stderr, "the last force was %g.\n", last_force.load()); });
    WrittenDevice device;
    device.on_write = [](const Vec3& force) { last_force.store(force.x()); };
    run_until_another_thread(device, last_force, [] { std::exit(7); });
  };
  EXPECT_EXIT(run_and_exit(), testing::ExitedWithCode(7), "the last force was 0\\.");
}

}  // namespace
}  // namespace hapticut::device_test
