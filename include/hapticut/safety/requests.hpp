// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// The mailbox of requests to a run. The device's loop and its guard read it once per tick.
///
/// Any thread and any signal handler may make a request. Nothing is queued and nothing is lost: a request stays until
/// the loop has seen it, and two equal requests count as one. An emergency stop after a reset cancels the reset.
/// @realtime no allocation, no lock
class Requests {
 public:
  /// Ends the run after fading the force out. Has no effect on a run that begins later.
  void stop() noexcept { word_.fetch_or(kStop, std::memory_order_acq_rel); }

  /// Switches the force off from the next tick on, until `reset_fault`. The run goes on. A run that begins later has no
  /// force either.
  void emergency_stop() noexcept {
    std::uint32_t word = word_.load(std::memory_order_relaxed);
    while (!word_.compare_exchange_weak(word, (word | kEmergency) & ~kReset, std::memory_order_acq_rel)) {
    }
  }

  /// Leaves the fault state. There is a force again after the tool was free.
  void reset_fault() noexcept { word_.fetch_or(kReset, std::memory_order_acq_rel); }

  /// Switches the force off until the tool is free, because something changed that the hand would feel.
  /// @param reason  reclutched: the map from hand to tool changed; model_swapped: the tool or the workpiece changed
  void interrupt(SafetyEvent reason) noexcept { interruption_.store(reason, std::memory_order_release); }

  // --- the loop's side ----------------------------------------------------------------------------------------------
  [[nodiscard]] bool stop_wanted() const noexcept { return is_set(kStop); }
  [[nodiscard]] bool emergency() const noexcept { return is_set(kEmergency); }
  [[nodiscard]] bool reset_wanted() const noexcept { return is_set(kReset); }

  void forget_stop() noexcept { word_.fetch_and(~kStop, std::memory_order_acq_rel); }

  /// Removes a requested reset and ends the emergency that the reset is for.
  /// @return false when no reset is requested, or when an emergency stop came after it
  bool accept_reset() noexcept {
    std::uint32_t word = word_.load(std::memory_order_acquire);
    do {
      if ((word & kReset) == 0) return false;
    } while (!word_.compare_exchange_weak(word, word & ~(kReset | kEmergency), std::memory_order_acq_rel));
    return true;
  }

  /// Removes a requested interruption.  @return its reason, or nothing
  std::optional<SafetyEvent> accept_interruption() noexcept {
    const SafetyEvent reason = interruption_.exchange(kNoInterruption, std::memory_order_acq_rel);
    return reason == kNoInterruption ? std::nullopt : std::optional(reason);
  }

 private:
  static constexpr SafetyEvent kNoInterruption = SafetyEvent::count;
  static constexpr std::uint32_t kStop = 1U << 0, kEmergency = 1U << 1, kReset = 1U << 2;
  [[nodiscard]] bool is_set(std::uint32_t bit) const noexcept {
    return (word_.load(std::memory_order_acquire) & bit) != 0;
  }

  std::atomic<std::uint32_t> word_{0};
  std::atomic<SafetyEvent> interruption_{kNoInterruption};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<SafetyEvent>::is_always_lock_free,
                "a signal handler may only access lock-free atomics");
};

}  // namespace hapticut
