// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

/// @file
/// Running loops, where signal handlers and the end of the process can reach them: static memory and atomics only.
namespace hapticut::run_slots {

inline constexpr int kSlots = 32;

struct Slot {
  std::atomic<bool> used{false};
  std::atomic<bool> stop{false};       ///< asks the loop to end
  std::atomic<bool> emergency{false};  ///< asks the guard for no force, once
  std::atomic<bool> on_crash{false};   ///< a crash sets `emergency`
  std::atomic<bool> quiet{false};      ///< the motors have no force, or will get none
};

[[nodiscard]] Slot& slot(int n) noexcept;

/// A free slot, or -1 when there is none.
/// @param on_crash  whether a crash concerns it; for `catch_crashes`
[[nodiscard]] int take(bool on_crash) noexcept;
void give_back(int n) noexcept;

/// From now on until the matching `release_signals`, SIGINT, SIGTERM and SIGHUP end the running loops.
void catch_signals();

/// Restores the handlers, and raises again what came in the meantime.
void release_signals();

/// From now on until the matching `release_crashes`, a signal of a crash takes the force of the loops that want it
/// away, and is then handed to the handler that was there before, with all that the kernel says of it: a runtime that
/// makes an exception of it does so still, and a process that it would end is ended by it.
void catch_crashes();

/// Restores the handlers, but for those that were replaced in the meantime.
void release_crashes();

}  // namespace hapticut::run_slots
