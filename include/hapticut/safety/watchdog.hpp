// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// How long a force may live without a new one.
struct WatchdogOptions {
  double period = 1e-3;  ///< [s] > 0 of a tick
  int late_ticks = 3;    ///< after which it is reported
  int fade_ticks = 10;   ///< after which the last force is faded out
  double fade = 0.03;    ///< [s] of the fading
  int fault_ticks = 50;  ///< after which it is reported as a fault

  /// What a loop finds that comes back after fault_ticks. false: what it finds after any pause: no force until the tool
  /// was free, and then the long fade-in. true: the fault state, which lasts until `reset_fault`.
  bool latch = false;
};

/// What to do about a model that has not answered for a while. Pure logic; callers bring the time.
class Watchdog {
 public:
  enum class Verdict : std::uint8_t { alive, late, fading, dead };

  /// @throws Error when an option is out of range, or the force would outlive the fault
  explicit Watchdog(const WatchdogOptions& options);

  [[nodiscard]] Verdict verdict(double seconds_without) const noexcept;

  /// [1] of the last force that is still allowed: 1 while alive or late, falling to 0 while fading.
  [[nodiscard]] double scale(double seconds_without) const noexcept;

  [[nodiscard]] const WatchdogOptions& options() const { return options_; }

 private:
  WatchdogOptions options_;
};

/// A thread that watches a heartbeat by the wall clock, for devices that keep rendering the last force when no new one
/// is written.
class WatchdogThread {
 public:
  /// @param heartbeat  grows with every tick
  /// @param act        called about once a period while the heart does not beat, with the verdict and the allowed share
  ///                   of the last force, and once with `alive` when it beats again
  WatchdogThread(const WatchdogOptions& options, const std::atomic<std::uint64_t>& heartbeat,
                 std::function<void(Watchdog::Verdict, double scale)> act);
  ~WatchdogThread();
  WatchdogThread(const WatchdogThread&) = delete;
  WatchdogThread& operator=(const WatchdogThread&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
