// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// How long a force may live without a new one, from the moment on at which a tick is due.
struct WatchdogOptions {
  double late = 2e-3;
  double fade_after = 9e-3;
  double fade = 0.03;
  double fault = 49e-3;

  /// false: what a loop finds after any pause: no force until the tool was free, and then the long fade-in. true: the
  /// fault state, which lasts until `reset_fault`.
  bool latch = false;
};

constexpr auto fields_of(Of<WatchdogOptions>) {
  using O = WatchdogOptions;
  return std::tuple{
      field("late", &O::late, "s", Range::between(0, 10), "after which a tick is reported as late"),
      field("fade_after", &O::fade_after, "s", Range::between(0, 10),
            "after which the last force is faded out, not below late"),
      field("fade", &O::fade, "s", Range::positive(), "of the fading"),
      field("fault", &O::fault, "s", Range::between(0, 10),
            "after which it is reported as a fault, not before the force has faded out"),
      field("latch", &O::latch, "what a loop finds that comes back after fault"),
  };
}

/// What to do about a model that has not answered for a while. Pure logic; callers bring the time.
class Watchdog {
 public:
  enum class Verdict : std::uint8_t { alive, late, fading, dead };

  /// @param period  [s] > 0 of a tick
  /// @throws Error when an option is out of range, or the force would outlive the fault
  explicit Watchdog(const WatchdogOptions& options, double period = 1e-3);

  [[nodiscard]] Verdict verdict(double seconds_without) const noexcept;

  /// [1] of the last force that is still allowed: 1 while alive or late, falling to 0 while fading.
  [[nodiscard]] double scale(double seconds_without) const noexcept;

  [[nodiscard]] const WatchdogOptions& options() const { return options_; }

 private:
  WatchdogOptions options_;
  double period_;
};

/// A thread that watches a heartbeat by the wall clock, for devices that keep rendering the last force when no new one
/// is written.
class WatchdogThread {
 public:
  /// @param heartbeat  grows with every tick; 0: none is due
  /// @param act        called about once a millisecond while the heart does not beat, with the verdict and the allowed
  ///                   share of the last force, and once with `alive` when it beats again
  WatchdogThread(const Watchdog& watchdog, const std::atomic<std::uint64_t>& heartbeat,
                 std::function<void(Watchdog::Verdict, double scale)> act);
  ~WatchdogThread();
  WatchdogThread(const WatchdogThread&) = delete;
  WatchdogThread& operator=(const WatchdogThread&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
