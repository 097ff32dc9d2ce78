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

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// The events that the safety pipeline reports. Their names are those of the enumerators.
enum class SafetyEvent : std::uint8_t {
  pose_not_finite,         ///< a reading has a number that is not finite; the last good pose is held
  pose_not_a_rotation,     ///< a reading's rotation matrix is not a rotation; the last good pose is held
  pose_outside_workspace,  ///< a reading is outside the workspace of the device; the last good pose is held
  pose_jump,               ///< the position jumped farther than a hand can move; the last good pose is held
  pose_rotation_jump,      ///< the orientation jumped farther than a hand can rotate; the last good pose is held
  pose_frozen,             ///< the position is exactly constant while the stylus rotates or reports a speed
  pose_units,              ///< the size of the positions suggests other units than metres
  reading_invalid,         ///< the driver marks its reading as invalid
  reading_stale,           ///< the device has no newer reading than in the tick before; the last one is used
  armed,                   ///< the device is ready; waiting for valid readings
  waiting_free,            ///< waiting until the tool touches nothing
  start_inside,            ///< the tool is inside the material where a force would begin; none until it is pulled out
  fading_in,               ///< the tool is free, and the force is being faded in
  engaged,                 ///< the full force is allowed
  fault,                   ///< latched; no force until `reset`
  fault_reset,             ///< the fault was reset
  recalibrated,            ///< calibration or reconnection: poses before and after are not comparable
  reclutched,              ///< the mapping between hand and tool changed
  model_swapped,           ///< the workpiece or the tool was exchanged
  late_wake_up,            ///< a tick came more than 5 ms late
  paused,                  ///< a tick came more than 20 ms late: a debugger, a suspended machine
  force_not_finite,        ///< the model's wrench is not finite
  passivity,               ///< the passivity controller changed the force of a contact by more than 7 %
  saturated,               ///< the wrench exceeds the device's peak
  slew_limited,            ///< the wrench grows faster than allowed
  continuous_limited,      ///< the motors would become too warm
  motors_warm,             ///< the device reports warm motors
  device_fault,            ///< the device reports a fault; the value is the number of its DeviceFault
  watchdog_late,           ///< the model has not answered for 3 ticks, for the fourth time in a second
  watchdog_fading,         ///< the model has not answered for 10 ticks: its last force is faded out
  watchdog_fault,          ///< the model has not answered for 50 ticks
  exception,               ///< the user's code threw
  emergency_stop,          ///< the emergency stop was triggered
  other_period,            ///< the readings come at another period than the guard was given; the value is theirs
  slow_readings,           ///< the device has good readings in fewer ticks than there are; the value is their rate
  count                    ///< number of events
};

constexpr auto names_of(Of<SafetyEvent>) {
  using enum SafetyEvent;
  return std::array{
      Named{pose_not_finite, "pose_not_finite",
            "The device reports a position that is not a number, so the last good one is held: check its cable and "
            "driver."},
      Named{pose_not_a_rotation, "pose_not_a_rotation",
            "The device reports a rotation that is invalid, so the last good one is held: check its cable and driver."},
      Named{pose_outside_workspace, "pose_outside_workspace",
            "The hand is outside the workspace of the device: bring it back, or calibrate the device."},
      Named{pose_jump, "pose_jump",
            "The position jumped farther than a hand can move, so the last good pose is held: move smoothly."},
      Named{pose_rotation_jump, "pose_rotation_jump",
            "The orientation jumped farther than a hand can rotate, so the last good pose is held: rotate smoothly."},
      Named{pose_frozen, "pose_frozen",
            "The position stands still while the hand moves: check the cable of the device, and calibrate the device."},
      Named{pose_units, "pose_units", "The size of the positions suggests other units than metres: check the driver."},
      Named{reading_invalid, "reading_invalid",
            "The driver marks its reading as invalid: check the device, and calibrate it."},
      Named{reading_stale, "reading_stale",
            "The device has no new reading for this tick, so the last one is used: a device slower than the loop does "
            "so, and works if it reads every 20 ms; if the force stops, check its driver and its connection."},
      Named{armed, "armed",
            "The device is ready, and the guard waits for valid readings: if this lasts, check the device."},
      Named{waiting_free, "waiting_free", "No force until the tool touches nothing: lift it off the workpiece."},
      Named{start_inside, "start_inside", "The tool is inside the material, so there is no force: pull it out."},
      Named{fading_in, "fading_in", "The tool touches nothing: the force is being faded in."},
      Named{engaged, "engaged", "The force is on."},
      Named{fault, "fault", "Stopped without force: reset the fault when the hand is ready."},
      Named{fault_reset, "fault_reset",
            "The fault is reset: lift the tool off the workpiece, and the force comes back."},
      Named{recalibrated, "recalibrated",
            "The device was calibrated or reconnected: lift the tool off the workpiece, and the force comes back."},
      Named{reclutched, "reclutched",
            "The tool follows the hand again: lift it off the workpiece, and the force comes back."},
      Named{model_swapped, "model_swapped",
            "The workpiece or the tool was exchanged: lift the tool off the workpiece, and the force comes back."},
      Named{late_wake_up, "late_wake_up", "The loop came late: close other programs that use the processor."},
      Named{paused, "paused",
            "The loop was interrupted for a moment: lift the tool off the workpiece, and the force comes back."},
      Named{force_not_finite, "force_not_finite",
            "The computed force is not a number, so there is no force: lift the tool off, and check the materials."},
      Named{passivity, "passivity",
            "The contact returned more energy than it had stored, so the force is damped: press less."},
      Named{saturated, "saturated", "The force is larger than the device can render: press less."},
      Named{slew_limited, "slew_limited", "The force grew faster than the device may render: touch more gently."},
      Named{continuous_limited, "continuous_limited",
            "The motors would become too warm, so the force is reduced: press less for a while."},
      Named{motors_warm, "motors_warm", "The motors are warm: release the device until they have cooled."},
      Named{device_fault, "device_fault", "The device reports a fault"},
      Named{watchdog_late, "watchdog_late",
            "The force often comes late: use a smaller head or larger voxels, or close other programs that use the "
            "processor."},
      Named{watchdog_fading, "watchdog_fading",
            "No new force has come for so long that the last one is faded out: use a smaller head or larger voxels."},
      Named{
          watchdog_fault, "watchdog_fault",
          "No new force has come for too long, so there is no force: use a smaller head or larger voxels, and lift the "
          "tool off the workpiece, or reset the fault if there is one."},
      Named{exception, "exception",
            "The program's code failed, so there is no force: reset the fault, or start the program again."},
      Named{emergency_stop, "emergency_stop", "The emergency stop was triggered: reset it when the hand is ready."},
      Named{other_period, "other_period",
            "The ticks come at another period than guard.period: set guard.period to that of the loop, or let the loop "
            "wait for each tick."},
      Named{slow_readings, "slow_readings",
            "The device has no good reading in some ticks, so the last one is used: set guard.period to the period of "
            "the device, or check its cable and driver."},
  };
}

inline constexpr std::size_t kSafetyEvents = std::size_t(SafetyEvent::count);

[[nodiscard]] std::string_view name_of(SafetyEvent event);

/// One log entry: an event that began.
struct SafetyLogEntry {
  double time = 0;             ///< [s] time of the reading
  std::uint64_t sequence = 0;  ///< sequence number of the reading
  SafetyEvent event = SafetyEvent::count;
  double value = 0;  ///< the measured value, in the unit of the event: metres, newtons, seconds, or a number
};

/// The events of a loop. Each event is counted in every tick, and entered in a bounded list when it begins.
///
/// The thread of the loop calls `report`, other threads, such as a watchdog, call `note`, and any thread reads. A full
/// list drops the entry and counts the drop. Counts are never lost.
class SafetyLog {
 public:
  SafetyLog();
  ~SafetyLog();
  SafetyLog(const SafetyLog&) = delete;
  SafetyLog& operator=(const SafetyLog&) = delete;

  /// @realtime no allocation, no lock
  void begin_tick(double time, std::uint64_t sequence) noexcept;

  /// Counts an event of this tick. Enters it in the list if the tick before did not report it; a stale reading if none
  /// of the hundred ticks before did, because a device slower than the loop has one every few ticks.
  /// @realtime no allocation, no lock
  void report(SafetyEvent event, double value = 0) noexcept;

  /// Counts and enters an event that another thread has seen, with the time of the last tick. May wait for readers.
  void note(SafetyEvent event, double value = 0);

  /// The number of ticks that reported the event.
  [[nodiscard]] std::uint64_t count(SafetyEvent event) const noexcept;

  /// The number of entries that were dropped because the list was full.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

  /// Removes the entries from the list and returns them in the order of their ticks.
  [[nodiscard]] std::vector<SafetyLogEntry> drain();

 private:
  struct Ring;
  struct Dated {
    std::uint64_t tick;  // number of the tick, counted by this log
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

/// A sentence for the user: what has happened and what to do.
[[nodiscard]] std::string sentence_of(const SafetyLogEntry& entry);

/// An entry as text: time, name, value and the sentence.
[[nodiscard]] std::string describe(const SafetyLogEntry& entry);

}  // namespace hapticut
