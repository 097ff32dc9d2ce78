// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

/// @file
/// The running loops, in static memory and atomics only, so that signal handlers and exit handlers can reach them.
namespace hapticut::running_loops {

inline constexpr int kMaxLoops = 32;

struct RunningLoop {
  std::atomic<bool> used{false};
  std::atomic<bool> stop{false};       ///< requests the end of the loop
  std::atomic<bool> emergency{false};  ///< requests an emergency stop, once
  std::atomic<bool> on_crash{false};   ///< a crash sets `emergency`
  std::atomic<bool> quiet{false};      ///< the motors have no force, or will receive none
};

[[nodiscard]] RunningLoop& loop(int n) noexcept;

/// Acquires a free entry.
/// @param on_crash  whether a crash sets its `emergency`; for `catch_crashes`
/// @return the number of the entry, or -1 when none is free
[[nodiscard]] int acquire(bool on_crash) noexcept;
void give_back(int n) noexcept;

/// Makes SIGINT, SIGTERM and SIGHUP end the running loops, until the matching `release_signals`.
void catch_signals();

/// Restores the handlers, and raises again the signals that were received meanwhile.
void release_signals();

/// Makes the signal of a crash switch off the force of the loops with `on_crash`, until the matching `release_crashes`.
/// Then the previous handler is called with the same arguments: a runtime still turns the signal into an exception, and
/// a process that the signal would end still ends.
void catch_crashes();

/// Restores the handlers, except those that other code has replaced meanwhile.
void release_crashes();

}  // namespace hapticut::running_loops
