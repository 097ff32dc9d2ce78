// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/passivity.hpp"
#include "hapticut/safety/pose_gate.hpp"
#include "hapticut/safety/requests.hpp"
#include "hapticut/safety/safety_log.hpp"
#include "hapticut/safety/thermal_budget.hpp"
#include "hapticut/safety/watchdog.hpp"
#include "hapticut/simulation/output_limits.hpp"

namespace hapticut {

/// The limits of a device's output, for SimulationConfig::effects in a loop of your own: its peak force and torque, and
/// the least growth that leaves the stiffest wall it promises passive (min_force_growth). A RealtimeLoop does not
/// need them: SafetyGuard holds to the same, and to more. A device without motors for torque renders none, so torque is
/// not limited there.
/// @param max_contact_speed  [m/s] > 0 at which a surface is met
/// @throws Error when the device renders no force
[[nodiscard]] OutputLimits output_limits(const DeviceCapabilities& device, double max_contact_speed = 0.5);

/// The settings of every stage of the safety pipeline. The defaults suit a device of its capabilities.
struct GuardOptions {
  PoseGateOptions gate;
  ArmingOptions arming;
  PassivityOptions passivity;
  ThermalOptions thermal;
  WatchdogOptions watchdog;

  double period = 1e-3;
  double max_force = 0;
  double max_torque = 0;
  double slew = 0;
  double torque_slew = 0;
  double stiffness = 0;
  double max_contact_speed = 0.5;
  double ramp_damping = -1;
  double late = 5e-3;
  double pause = 20e-3;
  int not_finite_ticks = 3;
};

constexpr auto fields_of(Of<GuardOptions>) {
  using O = GuardOptions;
  return std::tuple{
      field("gate", &O::gate, "what a reading must be to be believed"),
      field("arming", &O::arming, "when a force is allowed, and how it begins"),
      field("passivity", &O::passivity, "how much energy the model may put into the hand"),
      field("thermal", &O::thermal, "when the motors count as too warm"),
      field("watchdog", &O::watchdog, "how long a force may live without a new one"),
      field("period", &O::period, "s", Range::positive(),
            "of a tick: of the loop, the guard, its watchdog, the driver and simulated devices"),
      field("max_force", &O::max_force, "N", Range::not_negative(),
            "of the output; 0: the device's peak; never more than it"),
      field("max_torque", &O::max_torque, "N m", Range::not_negative(),
            "of the output; 0: the device's peak; never more than it"),
      field("slew", &O::slew, "N/s", Range::not_negative(),
            "by which the force may grow; 0: 1.25 x stiffness x max_contact_speed, and no less is allowed"),
      field("torque_slew", &O::torque_slew, "N m/s", Range::not_negative(),
            "the same of the torque; 0: as long to the peak as for the force"),
      field("stiffness", &O::stiffness, "N/m", Range::not_negative(),
            "that the device feels, scales included; 0: what the device promises"),
      field("max_contact_speed", &O::max_contact_speed, "m/s", Range::positive(), "at which a surface is met"),
      field("ramp_damping", &O::ramp_damping, "N s/m",
            "while the force fades in; < 0: a fifth of what the device promises"),
      field("late", &O::late, "s", Range::between(0, 1), "a tick that comes later than this needs a free tool again"),
      field("pause", &O::pause, "s", Range::between(0, 10),
            "... and, later than this, the long fade-in; not below late"),
      field("not_finite_ticks", &O::not_finite_ticks, "ticks", Range::between(1, 50),
            "in a row of a wrench that is not finite before the fault"),
  };
}

/// The safety pipeline between a device and the code that computes its force. Always on; every stage can only take
/// force away (or, damping, oppose the motion).
///
/// Per tick: `admit` the reading, compute with what it returns, `limit` the wrench. Its stages, in order: time and
/// missed ticks, pose gate, arming, finite check, passivity, saturation, thermal budget, growth-only slew limit,
/// fade-in, last finite check.
///
/// `admit`, `limit` and `applied` belong to the thread of the loop; the rest may be called from any thread.
class SafetyGuard {
 public:
  /// @param requests  of the device; it must outlive the guard. Null: the guard has a mailbox of its own
  /// @throws Error when an option is out of range, or the slew limit would make the contact active
  SafetyGuard(const DeviceCapabilities& capabilities, const GuardOptions& options, Requests* requests = nullptr);

  /// Begins a run: armed, nothing remembered.
  void start() noexcept;

  /// Ends a run: no force from here on.
  void stop() noexcept;

  /// Judges a reading and returns the one to compute with: `valid` is false when no reading is good, its velocity zero
  /// when the pose is held.  @realtime no allocation, no lock
  const DeviceState& admit(const DeviceState& reading) noexcept;

  /// The reading that `admit` returned last; for the thread of the loop.
  [[nodiscard]] const DeviceState& admitted() const noexcept { return gate_.state(); }

  /// Turns the wrench that the model asks for into the one that the device may render.
  /// @param contact  what the model knows of the contact behind it
  /// @realtime no allocation, no lock
  Wrench limit(const Wrench& commanded, const ModelContact& contact = {}) noexcept;

  /// What a watchdog in another thread, or a bench, sees of a loop that does not answer: enters each verdict once in a
  /// silence, and latches the fault where WatchdogOptions::latch says so. One thread at a time; `alive` ends a silence.
  void report_silence(Watchdog::Verdict verdict, double share);

  /// What the device did render, when that is something else than `limit` returned.
  void applied(const Wrench& wrench) noexcept;

  /// Counts an exception of the user's code, and fails.
  void report_exception() noexcept;

  /// What is asked of the guard: emergency stop, reset, waiting until the tool is free.
  [[nodiscard]] Requests& requests() noexcept { return *requests_; }

  [[nodiscard]] ArmingState state() const noexcept { return published_state_.load(std::memory_order_acquire); }

  /// The last wrench is written: no watchdog waits for another, and the state is off.
  void rest() noexcept {
    heartbeat_.store(0, std::memory_order_release);
    published_state_.store(ArmingState::off, std::memory_order_release);
  }

  /// Grows with every released wrench, for a watchdog in another thread; 0 before the first and after the last.
  [[nodiscard]] const std::atomic<std::uint64_t>& heartbeat() const noexcept { return heartbeat_; }

  [[nodiscard]] SafetyLog& log() noexcept { return log_; }
  [[nodiscard]] const SafetyLog& log() const noexcept { return log_; }

  /// Both sides of the last tick; for the thread of the loop.
  [[nodiscard]] const DeviceOutput& output() const noexcept { return output_; }

  [[nodiscard]] double period() const noexcept { return options_.period; }  ///< [s] of a tick
  [[nodiscard]] double slew() const noexcept { return slew_; }              ///< [N/s] in force
  [[nodiscard]] double max_force() const noexcept { return max_force_; }    ///< [N] in force

 private:
  void keep_time(const DeviceState& reading) noexcept;
  void obey() noexcept;
  void fail_in_emergency() noexcept;
  void watch_units(const DeviceState& reading) noexcept;
  [[nodiscard]] Wrench finite_or_none(const Wrench& commanded) noexcept;
  [[nodiscard]] Wrench make_passive(const Wrench& wrench, const ModelContact& contact) noexcept;
  [[nodiscard]] Wrench bound(const Wrench& wrench) noexcept;

  DeviceCapabilities capabilities_;
  GuardOptions options_;
  double max_force_, max_torque_, slew_, torque_slew_, ramp_damping_;
  SafetyLog log_;
  PoseGate gate_;
  Arming arming_;
  PassivityController passivity_;
  ThermalBudget thermal_;

  Requests own_requests_;
  Requests* requests_;
  std::atomic<bool> was_dead_{false};
  std::atomic<ArmingState> published_state_{ArmingState::off};
  std::atomic<std::uint64_t> heartbeat_{0};
  Watchdog::Verdict silence_ = Watchdog::Verdict::alive;  // of the watchdog's thread

  bool started_ = false, reading_ok_ = false;
  double last_time_ = 0, dt_ = 0, gate_time_ = 0;
  int not_finite_ = 0;
  Pose X_BS_last_;      // of the last admitted reading
  Vec3 motion_, turn_;  // since then
  Vec3 low_seen_, high_seen_;
  double watched_ = 0;  // [s] of the check of units
  Wrench before_ramp_;  // of the last tick, what the slew limit starts from
  DeviceOutput output_;
};

}  // namespace hapticut
