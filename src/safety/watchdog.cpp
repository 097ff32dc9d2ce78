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

Watchdog::Watchdog(const WatchdogOptions& options) : options_(options) {
  require_fields_within(options, "WatchdogOptions::");
  require_between(options.fade_ticks, options.late_ticks, 1000, "WatchdogOptions::fade_ticks [ticks]");
  require_between(options.fault_ticks * options.period, options.fade_ticks * options.period + options.fade, 10,
                  "WatchdogOptions::fault_ticks, in seconds,");
}

Watchdog::Verdict Watchdog::verdict(double seconds_without) const noexcept {
  const double ticks = seconds_without / options_.period;
  if (ticks > options_.fault_ticks) return Verdict::dead;
  if (ticks > options_.fade_ticks) return Verdict::fading;
  return ticks > options_.late_ticks ? Verdict::late : Verdict::alive;
}

double Watchdog::scale(double seconds_without) const noexcept {
  return std::clamp(1 - (seconds_without - options_.fade_ticks * options_.period) / options_.fade, 0.0, 1.0);
}

struct WatchdogThread::State {
  std::mutex mutex;
  std::condition_variable wake;
  bool stop = false;
  std::thread thread;
};

WatchdogThread::WatchdogThread(const WatchdogOptions& options, const std::atomic<std::uint64_t>& heartbeat,
                               std::function<void(Watchdog::Verdict, double scale)> act)
    : state_(std::make_unique<State>()) {
  using Clock = std::chrono::steady_clock;
  state_->thread = std::thread([&heartbeat, state = state_.get(), watchdog = Watchdog(options), act = std::move(act)] {
    const std::chrono::duration<double> period(watchdog.options().period);
    std::uint64_t last = heartbeat.load(std::memory_order_acquire);
    Clock::time_point beat = Clock::now();
    bool silent = false;
    std::unique_lock lock(state->mutex);
    while (!state->wake.wait_for(lock, period, [&] { return state->stop; })) {
      const std::uint64_t now = heartbeat.load(std::memory_order_acquire);
      if (now != last || now == 0) {  // 0: the first tick has not come yet
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
