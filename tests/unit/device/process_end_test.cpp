// SPDX-License-Identifier: Apache-2.0
// The last force of a device when its process ends, is asked to end, or crashes; and which handler a crash reaches.
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
#include <new>
#include <stdexcept>
#include <thread>
#include <utility>

#include "support/sanitizers.hpp"
#include "support/written_device.hpp"

namespace hapticut::process_end_test {
namespace {

using test::pushing;
using test::real;
using test::WrittenDevice;

/// The last force that a child process has written, in shared memory.
struct SharedForce {
  SharedForce()
      : value(static_cast<std::atomic<double>*>(
            mmap(nullptr, sizeof(std::atomic<double>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {
    value->store(-1);
  }
  ~SharedForce() { munmap(value, sizeof(std::atomic<double>)); }
  std::atomic<double>* value;
};

/// The thread sanitizer cannot follow threads that a forked process starts.
constexpr bool kForksMayHaveThreads = !test::kWithThreadSanitizer;
constexpr const char* kNoForks = "the thread sanitizer cannot follow a process that was forked";

/// Runs `child` in a new process, sends it a signal once it renders a force, and returns how it ended.
int end_of_child(SharedForce& last, const std::function<void(WrittenDevice&)>& child, int signal) {
  const pid_t pid = fork();
  if (pid == 0) {
    if (signal != 0) std::signal(signal, SIG_DFL);  // a test program in the background of a script ignores SIGINT
    WrittenDevice device;
    device.on_write = [&](const Vec3& force) { last.value->store(force.x()); };
    try {
      child(device);
    } catch (...) {
      _exit(98);
    }
    _exit(99);
  }
  if (signal != 0) {
    for (int n = 0; n < 20000 && last.value->load() < 0.5; ++n) usleep(1000);
    kill(pid, signal);
  }
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

/// Runs a device. When it renders a force, another thread ends the process by `end`.
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

/// Reads from a page without read permission.
void touch_nothing() {
  volatile int* nothing = static_cast<int*>(mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  (void)*nothing;
}

/// The sanitizers have their own handlers, which end the process.
constexpr bool kCrashesAreOurs = !test::kWithAddressSanitizer && !test::kWithThreadSanitizer;

TEST(Device, LeavesNoForceWhenAnotherThreadCrashes) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  if (!kCrashesAreOurs) GTEST_SKIP() << "the sanitizer handles crashes";
  const std::pair<int, std::function<void()>> crashes[] = {
      {SIGABRT, [] { std::abort(); }}, {SIGSEGV, touch_nothing}, {SIGFPE, [] { raise(SIGFPE); }}};
  for (const auto& one : crashes) {
    const int signal = one.first;
    const std::function<void()>& crash = one.second;
    SharedForce last;
    const int status = end_of_child(
        last, [&](WrittenDevice& device) { run_until_another_thread(device, *last.value, crash, true); }, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(last.value->load(), 0);
  }
}

/// What the previous handler records about a crash of the loop's own thread.
struct CrashOfTheLoop {
  std::atomic<double> began{0}, handed_on{0}, scale{1};
};
CrashOfTheLoop* crash_of_the_loop = nullptr;  // lies in memory that the processes share

TEST(Device, DoesNotWaitWhenItsOwnThreadCrashes) {
  if (!kForksMayHaveThreads) GTEST_SKIP() << kNoForks;
  if (!kCrashesAreOurs) GTEST_SKIP() << "the sanitizer handles crashes";
  constexpr double kGrace = 0.3;  // [s] that a loop has to switch its force off
  void* shared = mmap(nullptr, sizeof(CrashOfTheLoop), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  for (const bool at_once : {false, true}) {  // false: in a tick with a force; true: in the first tick
    double min_time = 1;
    for (int n = 0; n < 5 && min_time > kGrace / 2; ++n) {  // the machine may be busy
      crash_of_the_loop = new (shared) CrashOfTheLoop;
      SharedForce last;
      const int status = end_of_child(
          last,
          [&](WrittenDevice& device) {
            std::signal(SIGSEGV, [](int) {
              crash_of_the_loop->handed_on = monotonic_time();
              _exit(97);
            });
            RunOptions options = real(0);
            options.stop_on_crash = true;
            device.on_scale = [](double scale) { crash_of_the_loop->scale = scale; };
            device.run(
                [&](const DeviceState& state) {
                  if (at_once || last.value->load() > 0.5) {
                    crash_of_the_loop->began = monotonic_time();
                    touch_nothing();
                  }
                  return pushing()(state);
                },
                options);
          },
          0);
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 97) << status;
      EXPECT_TRUE(at_once || crash_of_the_loop->scale == 0) << "the force is off before the handler is called";
      min_time = std::min(min_time, crash_of_the_loop->handed_on - crash_of_the_loop->began);
    }
    EXPECT_LT(min_time, kGrace / 2) << at_once;
  }
  munmap(shared, sizeof(CrashOfTheLoop));
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
          throw std::runtime_error("a handler was installed");
      },
      0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 99) << status;
}

/// Imitates a runtime that turns crashes into exceptions: its handler runs on its own stack, checks the arguments of
/// the kernel, and continues elsewhere.
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

TEST(Device, PassesACrashToARuntimeThatHandlesItAndRunsAgainAfterAReset) {
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
        device.run(pushing(), options);
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
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // starts a new process, because a forked one may hang at its exit
  const auto run_and_exit = [] {
    std::atexit([] { std::fprintf(stderr, "the last force was %g.\n", last_force.load()); });
    WrittenDevice device;
    device.on_write = [](const Vec3& force) { last_force.store(force.x()); };
    run_until_another_thread(device, last_force, [] { std::exit(7); });
  };
  EXPECT_EXIT(run_and_exit(), testing::ExitedWithCode(7), "the last force was 0\\.");
}

}  // namespace
}  // namespace hapticut::process_end_test
