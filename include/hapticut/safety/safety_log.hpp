// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/core/description.hpp"

namespace hapticut {

/// What the safety pipeline can have to say. Names are those of the enumerators.
enum class SafetyEvent : std::uint8_t {
  pose_not_finite,         ///< a reading held a number that is not finite; the last good pose is held
  pose_not_a_rotation,     ///< a reading's rotation matrix was not a rotation; the last good pose is held
  pose_outside_workspace,  ///< a reading was outside of what the device can reach; the last good pose is held
  pose_jump,               ///< a reading was farther away than a hand can move; the last good pose is held
  pose_turn_jump,          ///< a reading was turned more than a hand can turn; the last good pose is held
  pose_frozen,             ///< the position stands still bit by bit while the stylus turns or reports a speed
  pose_units,              ///< positions of a size that suggests other units than metres
  reading_invalid,         ///< the driver itself calls its reading invalid
  reading_stale,           ///< the driver returned the same reading again
  armed,                   ///< the device is ready; waiting for valid readings
  waiting_free,            ///< waiting until the tool touches nothing
  start_inside,            ///< the tool began inside the material; no force until it is pulled out
  fading_in,               ///< free: the force is allowed, and faded in
  engaged,                 ///< the full force is allowed
  fault,                   ///< latched; no force until `reset`
  fault_reset,             ///< the fault was reset
  recalibrated,            ///< poses before and after do not compare: calibration or reconnection
  reclutched,              ///< the mapping between hand and tool changed
  model_swapped,           ///< the workpiece or the tool was exchanged
  late_wake_up,            ///< a tick came more than 5 ms late
  paused,                  ///< a tick came more than 20 ms late: a debugger, a suspended machine
  force_not_finite,        ///< the model's wrench was not finite
  passivity,               ///< the passivity controller took energy out
  saturated,               ///< the wrench was longer than the device's peak
  slew_limited,            ///< the wrench grew faster than allowed
  continuous_limited,      ///< the motors would become too warm
  motors_warm,             ///< the device reports warm motors
  device_fault,            ///< the device reports a fault; the value is its number
  watchdog_late,           ///< the model did not answer for 3 ticks
  watchdog_fading,         ///< ... for 10 ticks: its last force is faded out
  watchdog_fault,          ///< ... for 50 ticks
  exception,               ///< the user's code threw
  emergency_stop,          ///< the emergency stop was pulled
  count                    ///< how many there are
};

constexpr auto names_of(Of<SafetyEvent>) {
  using enum SafetyEvent;
  return std::array{
      Named{pose_not_finite, "pose_not_finite"},
      Named{pose_not_a_rotation, "pose_not_a_rotation"},
      Named{pose_outside_workspace, "pose_outside_workspace"},
      Named{pose_jump, "pose_jump"},
      Named{pose_turn_jump, "pose_turn_jump"},
      Named{pose_frozen, "pose_frozen"},
      Named{pose_units, "pose_units"},
      Named{reading_invalid, "reading_invalid"},
      Named{reading_stale, "reading_stale"},
      Named{armed, "armed"},
      Named{waiting_free, "waiting_free"},
      Named{start_inside, "start_inside"},
      Named{fading_in, "fading_in"},
      Named{engaged, "engaged"},
      Named{fault, "fault"},
      Named{fault_reset, "fault_reset"},
      Named{recalibrated, "recalibrated"},
      Named{reclutched, "reclutched"},
      Named{model_swapped, "model_swapped"},
      Named{late_wake_up, "late_wake_up"},
      Named{paused, "paused"},
      Named{force_not_finite, "force_not_finite"},
      Named{passivity, "passivity"},
      Named{saturated, "saturated"},
      Named{slew_limited, "slew_limited"},
      Named{continuous_limited, "continuous_limited"},
      Named{motors_warm, "motors_warm"},
      Named{device_fault, "device_fault"},
      Named{watchdog_late, "watchdog_late"},
      Named{watchdog_fading, "watchdog_fading"},
      Named{watchdog_fault, "watchdog_fault"},
      Named{exception, "exception"},
      Named{emergency_stop, "emergency_stop"},
  };
}

inline constexpr std::size_t kSafetyEvents = std::size_t(SafetyEvent::count);

[[nodiscard]] std::string_view name_of(SafetyEvent event);

/// One entry: an event that began.
struct SafetyLogEntry {
  double time = 0;             ///< [s] of the reading
  std::uint64_t sequence = 0;  ///< of the reading
  SafetyEvent event = SafetyEvent::count;
  double value = 0;  ///< what was measured, in the unit of the event: metres, newtons, seconds, or a number
};

/// Events on their way out of the loop: counted every tick, and entered in a bounded list when they begin.
///
/// One thread reports, any thread reads; others that have something to say, a watchdog for one, use `note`. A full list
/// drops the entry and counts it; counters are never lost.
class SafetyLog {
 public:
  SafetyLog();
  ~SafetyLog();
  SafetyLog(const SafetyLog&) = delete;
  SafetyLog& operator=(const SafetyLog&) = delete;

  /// @realtime no allocation, no lock
  void begin_tick(double time, std::uint64_t sequence) noexcept;

  /// Counts an event of this tick; enters it when it was not reported in the tick before.
  /// @realtime no allocation, no lock
  void report(SafetyEvent event, double value = 0) noexcept;

  /// Counts and enters an event that another thread has seen, at the time of the last tick. May wait for readers.
  void note(SafetyEvent event, double value = 0);

  /// How many ticks reported the event.
  [[nodiscard]] std::uint64_t count(SafetyEvent event) const noexcept;

  /// Entries that found the list full.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

  /// Takes the entries out of the list, in the order of the ticks that they belong to.
  [[nodiscard]] std::vector<SafetyLogEntry> drain();

 private:
  struct Ring;
  struct Dated {
    std::uint64_t tick;  // of this log
    SafetyLogEntry entry;
  };
  [[nodiscard]] Dated dated(SafetyEvent event, double value) const noexcept;

  std::unique_ptr<Ring> ring_;
  std::mutex readers_;
  std::vector<Dated> noted_;  // by other threads
  std::array<std::atomic<std::uint64_t>, kSafetyEvents> counts_{};
  std::atomic<std::uint64_t> dropped_{0};
  std::array<std::uint64_t, kSafetyEvents> last_tick_{};
  std::atomic<std::uint64_t> tick_{1};
  std::atomic<double> time_{0};
  std::atomic<std::uint64_t> sequence_{0};
};

/// An entry in words: time, name and value.
[[nodiscard]] std::string describe(const SafetyLogEntry& entry);

}  // namespace hapticut
