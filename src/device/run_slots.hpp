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
  std::atomic<bool> emergency{false};  ///< asks the guard for no force
  std::atomic<bool> quiet{false};      ///< the motors have no force
};

[[nodiscard]] Slot& slot(int n) noexcept;

/// A free slot, or -1 when there is none.
[[nodiscard]] int take() noexcept;
void give_back(int n) noexcept;

/// From now on until the matching `release_signals`, SIGINT, SIGTERM and SIGHUP end the running loops, and a crash of
/// another thread takes their force away.
void catch_signals();

/// Restores the handlers, and raises again what came in the meantime.
void release_signals();

}  // namespace hapticut::run_slots
