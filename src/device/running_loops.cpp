// SPDX-License-Identifier: Apache-2.0
#include "device/running_loops.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>

namespace hapticut::running_loops {
namespace {

constexpr int kGraceAtExit = 1000;  // [ms] for running loops to end
constexpr int kGraceAtCrash = 300;  // [ms] for running loops to switch their force off

constexpr std::array<int, 3> kEnding = {SIGINT, SIGTERM, SIGHUP};
constexpr std::array<int, 5> kCrashing = {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL};

std::array<RunningLoop, kMaxLoops> loops;
std::atomic<int> pending{0};  // bit n: kEnding[n] was received

std::mutex handlers_mutex;
int ending_users = 0, crashing_users = 0;
std::array<struct sigaction, kEnding.size()> old_ending;
std::array<struct sigaction, kCrashing.size()> old_crashing;
std::array<bool, kCrashing.size()> in_a_chain{};  // another handler was installed after ours and may call ours

// Waits until all used entries fulfil `done`. Async-signal-safe.
template <typename Done>
void wait(int milliseconds, const Done& done) noexcept {
  for (int n = 0; n < milliseconds; ++n) {
    bool all = true;
    for (const RunningLoop& s : loops) all = all && (!s.used.load() || done(s));
    if (all) return;
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
}

void end_all() {
  for (RunningLoop& s : loops) s.stop.store(true);
  wait(kGraceAtExit, [](const RunningLoop& s) { return s.quiet.load(); });
}

extern "C" void hapticut_on_ending_signal(int signal) {
  for (std::size_t n = 0; n < kEnding.size(); ++n)
    if (kEnding[n] == signal) pending.fetch_or(1 << int(n));
  for (RunningLoop& s : loops)
    if (s.used.load()) s.stop.store(true);
}

/// Whether a process or a thread sent the signal, rather than a faulty instruction.
bool was_sent(const siginfo_t& info) noexcept { return info.si_code <= 0; }

/// Does what would have happened to a signal without our handler.
void hand_on(int signal, siginfo_t* info, void* context, struct sigaction& before) noexcept {
  const struct sigaction old = before;
  if ((old.sa_flags & SA_SIGINFO) == 0 && (old.sa_handler == SIG_DFL || old.sa_handler == SIG_IGN)) {
    if (old.sa_handler == SIG_IGN && was_sent(*info)) return;
    // The kernel ends the process when the instruction runs again, or by another signal of the same number, which is
    // delivered when this handler returns.
    struct sigaction end {};
    end.sa_handler = SIG_DFL;
    sigaction(signal, &end, nullptr);
    if (was_sent(*info)) raise(signal);
    return;
  }
  if ((old.sa_flags & int(SA_RESETHAND)) != 0) {
    before = {};
    before.sa_handler = SIG_DFL;
  }
  sigset_t mask = old.sa_mask, mask_before;
  if ((old.sa_flags & SA_NODEFER) == 0)
    sigaddset(&mask, signal);
  else
    sigdelset(&mask, signal);
  pthread_sigmask(SIG_SETMASK, &mask, &mask_before);
  if ((old.sa_flags & SA_SIGINFO) != 0)
    old.sa_sigaction(signal, info, context);
  else
    old.sa_handler(signal);
  pthread_sigmask(SIG_SETMASK, &mask_before, nullptr);
}

extern "C" void hapticut_on_crash(int signal, siginfo_t* info, void* context) {
  const int error = errno;
  for (RunningLoop& s : loops)
    if (s.used.load() && s.on_crash.load()) s.emergency.store(true);
  wait(kGraceAtCrash, [](const RunningLoop& s) { return s.quiet.load() || !s.on_crash.load(); });
  for (std::size_t n = 0; n < kCrashing.size(); ++n)
    if (kCrashing[n] == signal) hand_on(signal, info, context, old_crashing[n]);
  errno = error;
}

bool is_ours(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 && action.sa_sigaction == hapticut_on_crash;
}

}  // namespace

RunningLoop& loop(int n) noexcept { return loops[std::size_t(n)]; }

int acquire(bool on_crash) noexcept {
  static const bool registered = std::atexit(end_all) == 0;
  (void)registered;
  for (int n = 0; n < kMaxLoops; ++n) {
    bool expected = false;
    RunningLoop& s = loop(n);
    if (!s.used.compare_exchange_strong(expected, true)) continue;
    s.stop.store(false);
    s.emergency.store(false);
    s.on_crash.store(on_crash);
    s.quiet.store(true);
    return n;
  }
  return -1;
}

void give_back(int n) noexcept {
  loop(n).quiet.store(true);
  loop(n).used.store(false);
}

void catch_signals() {
  const std::lock_guard lock(handlers_mutex);
  if (ending_users++ > 0) return;
  pending.store(0);
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  action.sa_handler = hapticut_on_ending_signal;
  for (std::size_t n = 0; n < kEnding.size(); ++n) {
    sigaction(kEnding[n], nullptr, &old_ending[n]);
    if (old_ending[n].sa_handler != SIG_IGN) sigaction(kEnding[n], &action, nullptr);  // nohup ignores SIGHUP
  }
}

void release_signals() {
  int received = 0;
  {
    const std::lock_guard lock(handlers_mutex);
    if (--ending_users > 0) return;
    for (std::size_t n = 0; n < kEnding.size(); ++n) sigaction(kEnding[n], &old_ending[n], nullptr);
    received = pending.exchange(0);
  }
  for (std::size_t n = 0; n < kEnding.size(); ++n)
    if ((received & (1 << int(n))) != 0) raise(kEnding[n]);
}

void catch_crashes() {
  const std::lock_guard lock(handlers_mutex);
  if (crashing_users++ > 0) return;
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  // On the alternate stack of the crashed thread: its normal stack may be exhausted, or be managed by a runtime.
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  action.sa_sigaction = hapticut_on_crash;
  for (std::size_t n = 0; n < kCrashing.size(); ++n) {
    if (in_a_chain[n]) continue;  // another handler calls ours; if ours were in front of it, ours would call itself
    sigaction(kCrashing[n], &action, &old_crashing[n]);
  }
}

void release_crashes() {
  const std::lock_guard lock(handlers_mutex);
  if (--crashing_users > 0) return;
  for (std::size_t n = 0; n < kCrashing.size(); ++n) {
    struct sigaction now {};
    sigaction(kCrashing[n], nullptr, &now);
    in_a_chain[n] = !is_ours(now);
    if (!in_a_chain[n]) sigaction(kCrashing[n], &old_crashing[n], nullptr);
  }
}

}  // namespace hapticut::running_loops
