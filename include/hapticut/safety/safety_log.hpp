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

/// What the safety pipeline can have to say. Names are those of the enumerators.
enum class SafetyEvent : std::uint8_t {
  pose_not_finite,         ///< a reading held a number that is not finite; the last good pose is held
  pose_not_a_rotation,     ///< a reading's rotation matrix was not a rotation; the last good pose is held
  pose_outside_workspace,  ///< a reading was outside of what the device can reach; the last good pose is held
  pose_jump,               ///< a reading was farther away than a hand can move; the last good pose is held
  pose_rotation_jump,      ///< a reading was turned more than a hand can turn; the last good pose is held
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
      Named{pose_not_finite, "pose_not_finite",
            "The device gave a position that is no number, so the last good one is held: check its cable and driver."},
      Named{pose_not_a_rotation, "pose_not_a_rotation",
            "The device gave a pose that is no rotation, so the last good one is held: check its cable and driver."},
      Named{pose_outside_workspace, "pose_outside_workspace",
            "The hand is outside of what the device can reach: bring it back, or calibrate the device."},
      Named{pose_jump, "pose_jump",
            "The hand moved farther than a hand can, so the last good pose is held: move it smoothly."},
      Named{pose_rotation_jump, "pose_rotation_jump",
            "The hand turned more than a hand can, so the last good pose is held: turn it smoothly."},
      Named{pose_frozen, "pose_frozen",
            "The position stands still while the hand moves: check the cable of the device, and calibrate it."},
      Named{pose_units, "pose_units",
            "Positions are of a size that suggests other units than metres: check the driver."},
      Named{reading_invalid, "reading_invalid",
            "The driver calls its own reading invalid: check the device, and calibrate it."},
      Named{reading_stale, "reading_stale",
            "The driver gave the same reading again: if it lasts, check the cable of the device."},
      Named{armed, "armed",
            "The device is ready, and the guard waits for valid readings: if it lasts, check the device."},
      Named{waiting_free, "waiting_free", "No force until the tool touches nothing: lift it off the workpiece."},
      Named{start_inside, "start_inside", "The tool began inside the material, so there is no force: pull it out."},
      Named{fading_in, "fading_in", "The tool touches nothing: the force is faded in."},
      Named{engaged, "engaged", "The force is on."},
      Named{fault, "fault", "Stopped without force: reset the fault when the hand is ready."},
      Named{fault_reset, "fault_reset",
            "The fault is reset: lift the tool off the workpiece, and the force comes back."},
      Named{recalibrated, "recalibrated",
            "The device was calibrated or connected anew: lift the tool off the workpiece, and the force comes back."},
      Named{reclutched, "reclutched",
            "The tool goes with the hand again: lift it off the workpiece, and the force comes back."},
      Named{model_swapped, "model_swapped",
            "The workpiece or the tool was exchanged: lift the tool off, and the force comes back."},
      Named{late_wake_up, "late_wake_up", "The loop came late: close other programs that use the processor."},
      Named{paused, "paused", "The loop stood for a moment: lift the tool off, and the force comes back."},
      Named{force_not_finite, "force_not_finite",
            "The force came out as no number, so there is none: lift the tool off, and check the materials."},
      Named{passivity, "passivity",
            "The contact gave back more energy than it got, so the force is damped: press less."},
      Named{saturated, "saturated", "The force is larger than the device can give: press less."},
      Named{slew_limited, "slew_limited", "The force grew faster than the device may follow: touch more gently."},
      Named{continuous_limited, "continuous_limited",
            "The motors would become too warm, so the force is reduced: press less for a while."},
      Named{motors_warm, "motors_warm", "The motors are warm: let go until they have cooled."},
      Named{device_fault, "device_fault", "The device reports a fault"},
      Named{watchdog_late, "watchdog_late", "The force comes late: if it lasts, take a smaller head or larger voxels."},
      Named{watchdog_fading, "watchdog_fading",
            "The force has not come for so long that it is faded out: take a smaller head or larger voxels."},
      Named{watchdog_fault, "watchdog_fault",
            "The force has not come for too long, so there is none: reset the fault, with a smaller head or larger "
            "voxels."},
      Named{exception, "exception",
            "The program failed beside the loop, so there is no force: reset the fault, or start it again."},
      Named{emergency_stop, "emergency_stop", "The emergency stop was pulled: reset it when the hand is ready."},
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

/// What has happened and what to do about it, in a sentence for who holds the tool.
[[nodiscard]] std::string sentence_of(const SafetyLogEntry& entry);

/// An entry in words: time, name, value and the sentence.
[[nodiscard]] std::string describe(const SafetyLogEntry& entry);

}  // namespace hapticut
