// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// How long a force may live without a new one.
struct WatchdogOptions {
  double period = 1e-3;
  int late_ticks = 3;
  int fade_ticks = 10;
  double fade = 0.03;
  int fault_ticks = 50;

  /// false: what a loop finds after any pause: no force until the tool was free, and then the long fade-in. true: the
  /// fault state, which lasts until `reset_fault`.
  bool latch = false;
};

constexpr auto fields_of(Of<WatchdogOptions>) {
  using O = WatchdogOptions;
  return std::tuple{
      field("period", &O::period, "s", Range::positive(), "of a tick"),
      field("late_ticks", &O::late_ticks, "ticks", Range::between(1, 1000), "after which it is reported"),
      field("fade_ticks", &O::fade_ticks, "ticks", Range::between(1, 1000),
            "after which the last force is faded out, not below late_ticks"),
      field("fade", &O::fade, "s", Range::positive(), "of the fading"),
      field("fault_ticks", &O::fault_ticks, "ticks", Range::positive(),
            "after which it is reported as a fault, not before the force has faded out"),
      field("latch", &O::latch, "what a loop finds that comes back after fault_ticks"),
  };
}

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

constexpr auto names_of(Of<Watchdog::Verdict>) {
  using enum Watchdog::Verdict;
  return std::array{
      Named{alive, "alive"},
      Named{late, "late"},
      Named{fading, "fading"},
      Named{dead, "dead"},
  };
}

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
