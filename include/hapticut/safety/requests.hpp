// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// What the outside asks of a run: one mailbox, which the device's loop and its guard read once a tick.
///
/// Any thread may ask, a signal handler too. Nothing is queued and nothing is lost: a request stays until the loop has
/// seen it, and asking twice is asking once. An emergency stop that comes after a reset cancels the reset.
/// @realtime no allocation, no lock
class Requests {
 public:
  /// Ends the run after fading the force out. A run that begins later forgets it.
  void stop() noexcept { word_.fetch_or(kStop, std::memory_order_acq_rel); }

  /// No force from the next tick on, until `reset_fault`. The run goes on; one that begins later has no force either.
  void emergency_stop() noexcept {
    std::uint32_t word = word_.load(std::memory_order_relaxed);
    while (!word_.compare_exchange_weak(word, (word | kEmergency) & ~kReset, std::memory_order_acq_rel)) {
    }
  }

  /// Leaves the fault state. The tool must then be free before there is a force again.
  void reset_fault() noexcept { word_.fetch_or(kReset, std::memory_order_acq_rel); }

  /// Waits until the tool is free, because something changed under the hand.
  /// @param reason  reclutched: the mapping from hand to tool; model_swapped: the tool or the workpiece
  void interrupt(SafetyEvent reason) noexcept { interruption_.store(reason, std::memory_order_release); }

  // --- the loop's side ----------------------------------------------------------------------------------------------
  [[nodiscard]] bool stop_wanted() const noexcept { return is_set(kStop); }
  [[nodiscard]] bool emergency() const noexcept { return is_set(kEmergency); }
  [[nodiscard]] bool reset_wanted() const noexcept { return is_set(kReset); }

  void forget_stop() noexcept { word_.fetch_and(~kStop, std::memory_order_acq_rel); }

  /// Takes a reset and ends the emergency that it is about.
  /// @return false when there is none, or when an emergency stop came after it
  bool take_reset() noexcept {
    std::uint32_t word = word_.load(std::memory_order_acquire);
    do {
      if ((word & kReset) == 0) return false;
    } while (!word_.compare_exchange_weak(word, word & ~(kReset | kEmergency), std::memory_order_acq_rel));
    return true;
  }

  /// @return SafetyEvent::count when there was no interruption
  SafetyEvent take_interruption() noexcept {
    return interruption_.exchange(SafetyEvent::count, std::memory_order_acq_rel);
  }

 private:
  static constexpr std::uint32_t kStop = 1U << 0, kEmergency = 1U << 1, kReset = 1U << 2;
  [[nodiscard]] bool is_set(std::uint32_t bit) const noexcept {
    return (word_.load(std::memory_order_acquire) & bit) != 0;
  }

  std::atomic<std::uint32_t> word_{0};
  std::atomic<SafetyEvent> interruption_{SafetyEvent::count};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<SafetyEvent>::is_always_lock_free,
                "or a signal handler may not touch them");
};

}  // namespace hapticut
