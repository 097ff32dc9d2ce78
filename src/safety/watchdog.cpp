// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/watchdog.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kBeatRounding = 1e-9;                 // [s] rounding error of a sum of periods
constexpr auto kCheck = std::chrono::milliseconds(1);  // between two checks of the heartbeat, at any rate

}  // namespace

Watchdog::Watchdog(const WatchdogOptions& options, double period) : options_(options), period_(period) {
  require_fields_within(options, "WatchdogOptions::");
  require_positive(period, "the period of a watchdog [s]");
  require_between(options.fade_after, options.late, 10, "WatchdogOptions::fade_after [s]");
  require_between(options.fault, options.fade_after + options.fade, 10, "WatchdogOptions::fault [s]");
}

Watchdog::Verdict Watchdog::verdict(double seconds_without) const noexcept {
  const double late = seconds_without - period_ - kBeatRounding;
  if (late > options_.fault) return Verdict::dead;
  if (late > options_.fade_after) return Verdict::fading;
  return late > options_.late ? Verdict::late : Verdict::alive;
}

double Watchdog::scale(double seconds_without) const noexcept {
  return std::clamp(1 - (seconds_without - period_ - options_.fade_after) / options_.fade, 0.0, 1.0);
}

struct WatchdogThread::State {
  std::mutex mutex;
  std::condition_variable wake;
  bool stop = false;
  std::thread thread;
};

WatchdogThread::WatchdogThread(const Watchdog& watchdog, const std::atomic<std::uint64_t>& heartbeat,
                               std::function<void(Watchdog::Verdict, double scale)> act)
    : state_(std::make_unique<State>()) {
  using Clock = std::chrono::steady_clock;
  state_->thread = std::thread([&heartbeat, state = state_.get(), watchdog, act = std::move(act)] {
    std::uint64_t last = heartbeat.load(std::memory_order_acquire);
    Clock::time_point beat = Clock::now();
    bool silent = false;
    std::unique_lock lock(state->mutex);
    while (!state->wake.wait_for(lock, kCheck, [&] { return state->stop; })) {
      const std::uint64_t now = heartbeat.load(std::memory_order_acquire);
      if (now != last || now == 0) {  // 0: before the first tick or after the last
        last = now;
        beat = Clock::now();
        if (std::exchange(silent, false)) act(Watchdog::Verdict::alive, 1);
        continue;
      }
      const double without = std::chrono::duration<double>(Clock::now() - beat).count();
      const Watchdog::Verdict verdict = watchdog.verdict(without);
      if (verdict == Watchdog::Verdict::alive) continue;
      silent = true;
      act(verdict, watchdog.scale(without));
    }
  });
}

WatchdogThread::~WatchdogThread() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stop = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

}  // namespace hapticut
