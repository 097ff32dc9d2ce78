// SPDX-License-Identifier: Apache-2.0
#include "device/run_slots.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>

namespace hapticut::run_slots {
namespace {

constexpr int kGraceAtExit = 1000;  // [ms] for loops that end
constexpr int kGraceAtCrash = 300;  // [ms] for loops that take their force away

constexpr std::array<int, 3> kEnding = {SIGINT, SIGTERM, SIGHUP};
constexpr std::array<int, 5> kCrashing = {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL};

std::array<Slot, kSlots> slots;
std::atomic<int> pending{0};  // bit n: kEnding[n] came

std::mutex handlers_mutex;
int handlers_users = 0;
std::array<struct sigaction, kEnding.size()> old_ending;
std::array<struct sigaction, kCrashing.size()> old_crashing;

// Waits until no used slot lacks what `done` asks for. Async-signal-safe.
template <typename Done>
void wait(int milliseconds, const Done& done) noexcept {
  for (int n = 0; n < milliseconds; ++n) {
    bool all = true;
    for (const Slot& s : slots) all = all && (!s.used.load() || done(s));
    if (all) return;
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
}

void end_all() {
  for (Slot& s : slots) s.stop.store(true);
  wait(kGraceAtExit, [](const Slot& s) { return s.quiet.load(); });
}

extern "C" void hapticut_on_ending_signal(int signal) {
  for (std::size_t n = 0; n < kEnding.size(); ++n)
    if (kEnding[n] == signal) pending.fetch_or(1 << int(n));
  for (Slot& s : slots)
    if (s.used.load()) s.stop.store(true);
}

extern "C" void hapticut_on_crash(int signal) {
  for (Slot& s : slots) s.emergency.store(true);
  wait(kGraceAtCrash, [](const Slot& s) { return s.quiet.load(); });
  for (std::size_t n = 0; n < kCrashing.size(); ++n)
    if (kCrashing[n] == signal) sigaction(signal, &old_crashing[n], nullptr);
  raise(signal);  // delivered when this handler returns, to whoever was there before
}

}  // namespace

Slot& slot(int n) noexcept { return slots[std::size_t(n)]; }

int take() noexcept {
  static const bool registered = std::atexit(end_all) == 0;
  (void)registered;
  for (int n = 0; n < kSlots; ++n) {
    bool expected = false;
    Slot& s = slot(n);
    if (!s.used.compare_exchange_strong(expected, true)) continue;
    s.stop.store(false);
    s.emergency.store(false);
    s.quiet.store(false);
    return n;
  }
  return -1;
}

void give_back(int n) noexcept {
  if (n < 0) return;
  slot(n).quiet.store(true);
  slot(n).used.store(false);
}

void catch_signals() {
  const std::lock_guard lock(handlers_mutex);
  if (handlers_users++ > 0) return;
  pending.store(0);
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  action.sa_handler = hapticut_on_ending_signal;
  for (std::size_t n = 0; n < kEnding.size(); ++n) {
    sigaction(kEnding[n], nullptr, &old_ending[n]);
    if (old_ending[n].sa_handler != SIG_IGN) sigaction(kEnding[n], &action, nullptr);  // as nohup wants it
  }
  action.sa_flags = 0;
  action.sa_handler = hapticut_on_crash;
  for (std::size_t n = 0; n < kCrashing.size(); ++n) sigaction(kCrashing[n], &action, &old_crashing[n]);
}

void release_signals() {
  int came = 0;
  {
    const std::lock_guard lock(handlers_mutex);
    if (--handlers_users > 0) return;
    for (std::size_t n = 0; n < kEnding.size(); ++n) sigaction(kEnding[n], &old_ending[n], nullptr);
    for (std::size_t n = 0; n < kCrashing.size(); ++n) sigaction(kCrashing[n], &old_crashing[n], nullptr);
    came = pending.exchange(0);
  }
  for (std::size_t n = 0; n < kEnding.size(); ++n)
    if ((came & (1 << int(n))) != 0) raise(kEnding[n]);
}

}  // namespace hapticut::run_slots
