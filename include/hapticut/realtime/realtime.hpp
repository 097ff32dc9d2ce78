// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// How a thread is prepared for a 1 kHz loop.
struct RealtimeOptions {
  int priority = 80;               ///< [1] priority of SCHED_FIFO; 0: do not change the scheduler
  bool lock_memory = true;         ///< whether to lock the process in memory and to keep malloc from returning memory
  bool flush_denormals = true;     ///< whether numbers below 1e-308 count as zero; they are slow and irrelevant here
  int cpu = -1;                    ///< [1] the only processor that the thread may use; -1: any
  std::size_t stack = 256 * 1024;  ///< [bytes] length of the stack, touched in advance
};

constexpr auto fields_of(Of<RealtimeOptions>) {
  using O = RealtimeOptions;
  return std::tuple{
      field("priority", &O::priority, "1", Range::between(0, 99),
            "priority of SCHED_FIFO; 0: do not change the scheduler"),
      field("lock_memory", &O::lock_memory,
            "whether to lock the process in memory and to keep malloc from returning memory"),
      field("flush_denormals", &O::flush_denormals,
            "whether numbers below 1e-308 count as zero; they are slow and irrelevant here"),
      field("cpu", &O::cpu, "1", Range::between(-1, 1023), "the only processor that the thread may use; -1: any"),
      field("stack", &O::stack, "bytes", Range::between(0, 4 * 1024 * 1024), "length of the stack, touched in advance"),
  };
}

/// Prepares the calling thread for a real-time loop, and restores its settings in the destructor.
///
/// If the system does not permit a setting, a warning says so and names the cure. The loop then runs with more jitter.
class RealtimeScope {
 public:
  /// @throws Error when an option is out of range
  explicit RealtimeScope(const RealtimeOptions& options);
  ~RealtimeScope();
  RealtimeScope(const RealtimeScope&) = delete;
  RealtimeScope& operator=(const RealtimeScope&) = delete;

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void set_priority(int priority);
  void pin(int cpu);
  void lock_memory();

  std::vector<std::string> warnings_;
  int old_policy_ = 0, old_priority_ = 0;
  bool scheduled_ = false, locked_ = false, flushing_ = false;
  unsigned old_control_ = 0;
};

/// Periodic ticks at absolute times of the monotonic clock.
///
/// Each tick is a whole number of periods after the first, so no error accumulates. A loop that is late by more than a
/// period skips the ticks that it missed and counts them, instead of catching up in a burst.
/// @realtime no allocation, no lock
class PeriodicClock {
 public:
  /// @param period [s] > 0
  /// @throws Error when the period is out of range
  explicit PeriodicClock(double period);

  struct Tick {
    double time = 0;           ///< [s] since the first tick
    double late = 0;           ///< [s] between the requested moment and now
    std::uint64_t missed = 0;  ///< number of ticks skipped before this one
  };

  /// Sleeps until the next tick.
  Tick wait() noexcept;

  /// [s] The time since the first tick.
  [[nodiscard]] double now() const noexcept;

 private:
  std::int64_t period_, start_, next_;  // [ns]
};

/// [s] The time of the monotonic clock.
[[nodiscard]] double monotonic_time() noexcept;

}  // namespace hapticut
