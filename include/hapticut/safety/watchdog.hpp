// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// How long a force may last without a new one. All times count from the moment at which a tick is due.
struct WatchdogOptions {
  double late = 2e-3;        ///< [s] delay after which a tick is reported as late
  double fade_after = 9e-3;  ///< [s] delay after which the last force is faded out, at least late
  double fade = 0.03;        ///< [s] duration of the fade-out
  double fault = 49e-3;      ///< [s] delay after which a fault is reported, at least fade_after + fade

  /// Whether a loop that resumes after the fault delay is in the fault state.
  /// false: there is no force until the tool was free, then the long fade-in follows, as after any pause. true: the
  /// guard is in the fault state until `reset_fault`.
  bool latch = false;
};

constexpr auto fields_of(Of<WatchdogOptions>) {
  using O = WatchdogOptions;
  return std::tuple{
      field("late", &O::late, "s", Range::between(0, 10), "delay after which a tick is reported as late"),
      field("fade_after", &O::fade_after, "s", Range::between(0, 10),
            "delay after which the last force is faded out, at least late"),
      field("fade", &O::fade, "s", Range::positive(), "duration of the fade-out"),
      field("fault", &O::fault, "s", Range::between(0, 10),
            "delay after which a fault is reported, at least fade_after + fade"),
      field("latch", &O::latch, "whether a loop that resumes after the fault delay is in the fault state"),
  };
}

/// Decides what happens when a model has not answered for a while. Pure logic: the caller supplies the time.
class Watchdog {
 public:
  enum class Verdict : std::uint8_t { alive, late, fading, dead };

  /// @param period  [s] > 0 of a tick
  /// @throws Error when an option is out of range, or the fault would be reported before the force has faded out
  explicit Watchdog(const WatchdogOptions& options, double period = 1e-3);

  [[nodiscard]] Verdict verdict(double seconds_without) const noexcept;

  /// [1] The fraction of the last force that is still allowed: 1 while alive or late, falling to 0 while fading.
  [[nodiscard]] double scale(double seconds_without) const noexcept;

  [[nodiscard]] const WatchdogOptions& options() const { return options_; }

 private:
  WatchdogOptions options_;
  double period_;
};

/// A thread that checks a heartbeat by the wall clock. It serves devices that keep rendering the last force when no new
/// one is written.
class WatchdogThread {
 public:
  /// @param heartbeat  grows with every tick; 0: no tick is due
  /// @param act        called about once a millisecond while no heartbeat comes, with the verdict and the allowed
  ///                   fraction of the last force, and once with `alive` when a heartbeat comes again
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
