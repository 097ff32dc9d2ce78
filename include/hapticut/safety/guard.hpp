// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>

#include "hapticut/force/effects/output_limits.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/safety/passivity.hpp"
#include "hapticut/safety/pose_gate.hpp"
#include "hapticut/safety/requests.hpp"
#include "hapticut/safety/safety_log.hpp"
#include "hapticut/safety/thermal_budget.hpp"
#include "hapticut/safety/tick_clock.hpp"
#include "hapticut/safety/watchdog.hpp"

namespace hapticut {

/// The settings of all stages of the safety pipeline. The defaults follow from the capabilities of the device.
struct GuardOptions {
  PoseGateOptions gate;        ///< which readings are plausible
  ArmingOptions arming;        ///< when a force is allowed, and how it begins
  PassivityOptions passivity;  ///< how much energy the model may put into the hand
  ThermalOptions thermal;      ///< when the motors count as too warm
  WatchdogOptions watchdog;    ///< how long a force may last without a new one

  double period = 1e-3;   ///< [s] period of the ticks of loop, guard, watchdog, driver and simulated devices
  double max_force = 0;   ///< [N] largest output, at most the device's peak; 0: the device's peak
  double max_torque = 0;  ///< [N m] largest output, at most the device's peak; 0: the device's peak
  /// [N/s] limit of the force's growth, at least 1.25 x stiffness x max_contact_speed; 0: that minimum
  double slew = 0;
  /// [N m/s] limit of the torque's growth; 0: the torque reaches its peak in the same time as the force
  double torque_slew = 0;
  /// [N/m] stiffness of the contact at the device, scales included; 0: what the device promises
  double stiffness = 0;
  double max_contact_speed = 0.5;  ///< [m/s] largest speed at which the tool meets a surface
  /// [N s/m] damping while the force fades in; < 0: a fifth of what the device promises
  double ramp_damping = -1;
  /// [s] delay of a tick after which the tool must be free again before there is a force
  double late = 5e-3;
  double pause = 20e-3;  ///< [s] delay of a tick after which the long fade-in follows as well; not below late
  /// [ticks] ticks in a row with a wrench that is not finite, after which the guard enters the fault state
  int not_finite_ticks = 3;
};

constexpr auto fields_of(Of<GuardOptions>) {
  using O = GuardOptions;
  return std::tuple{
      field("gate", &O::gate, "which readings are plausible"),
      field("arming", &O::arming, "when a force is allowed, and how it begins"),
      field("passivity", &O::passivity, "how much energy the model may put into the hand"),
      field("thermal", &O::thermal, "when the motors count as too warm"),
      field("watchdog", &O::watchdog, "how long a force may last without a new one"),
      field("period", &O::period, "s", Range::positive(),
            "period of the ticks of loop, guard, watchdog, driver and simulated devices"),
      field("max_force", &O::max_force, "N", Range::not_negative(),
            "largest output, at most the device's peak; 0: the device's peak"),
      field("max_torque", &O::max_torque, "N m", Range::not_negative(),
            "largest output, at most the device's peak; 0: the device's peak"),
      field("slew", &O::slew, "N/s", Range::not_negative(),
            "limit of the force's growth, at least 1.25 x stiffness x max_contact_speed; 0: that minimum"),
      field("torque_slew", &O::torque_slew, "N m/s", Range::not_negative(),
            "limit of the torque's growth; 0: the torque reaches its peak in the same time as the force"),
      field("stiffness", &O::stiffness, "N/m", Range::not_negative(),
            "stiffness of the contact at the device, scales included; 0: what the device promises"),
      field("max_contact_speed", &O::max_contact_speed, "m/s", Range::positive(),
            "largest speed at which the tool meets a surface"),
      field("ramp_damping", &O::ramp_damping, "N s/m",
            "damping while the force fades in; < 0: a fifth of what the device promises"),
      field("late", &O::late, "s", Range::between(0, 1),
            "delay of a tick after which the tool must be free again before there is a force"),
      field("pause", &O::pause, "s", Range::between(0, 10),
            "delay of a tick after which the long fade-in follows as well; not below late"),
      field("not_finite_ticks", &O::not_finite_ticks, "ticks", Range::between(1, 50),
            "ticks in a row with a wrench that is not finite, after which the guard enters the fault state"),
  };
}

/// The safety pipeline between a device and the code that computes its force. It is always on. Every stage can only
/// reduce the force, or oppose the motion by damping.
///
/// In each tick, `admit` the reading, compute the wrench from the reading that it returns, then `limit` the wrench. The
/// stages in order: time and missed ticks, pose gate, arming, finite check, passivity, saturation, thermal budget, slew
/// limit (of growth only), fade-in, last finite check.
///
/// The thread of the loop calls `admit`, `limit` and `report_applied`. Any thread may call the other functions.
class SafetyGuard {
 public:
  /// @param requests  mailbox of the device, which must outlive the guard; null: the guard makes its own mailbox
  /// @throws Error when an option is out of range, or the slew limit would make the contact active
  SafetyGuard(const DeviceCapabilities& capabilities, const GuardOptions& options, Requests* requests = nullptr);

  /// Begins a run: clears all memory and enters the state `armed`.
  void start() noexcept;

  /// Ends a run: there is no force from here on.
  void stop() noexcept;

  /// Checks a reading and returns the reading to compute with. Its `valid` is false when no reading is plausible; its
  /// velocity is zero when the last good pose is held or repeated.  @realtime no allocation, no lock
  const DeviceState& admit(const DeviceState& reading) noexcept;

  /// The reading that `admit` returned last; for the thread of the loop.
  [[nodiscard]] const DeviceState& admitted() const noexcept { return gate_.state(); }

  /// Whether the device had no newer reading for `admit`. The last command is held: the model makes no step.
  [[nodiscard]] bool repeats() const noexcept { return reading_ == Reading::repeated; }

  /// Turns the wrench that the model commands into the wrench that the device may render.
  /// @param contact  what the model knows about the contact that causes the wrench
  /// @realtime no allocation, no lock
  Wrench limit(const Wrench& commanded, const ModelContact& contact = {}) noexcept;

  /// Reports that the loop does not answer. A watchdog in another thread calls this, or a test. Logs each verdict once
  /// per silence, `late` from the fourth silence within a second on. After `fading` the tool must be free again before
  /// there is a force, after `dead` the long fade-in follows as well, or the fault state if WatchdogOptions::latch is
  /// set. `alive` ends a silence. One thread at a time.
  /// @param scale  [1] fraction of the last force that is still allowed
  void report_silence(Watchdog::Verdict verdict, double scale);

  /// Reports by a clock of the loop how long ago the last tick was: the clock of a device may stand with the loop, or
  /// count ticks. In the thread of the loop, before `admit`. The same verdicts as for a silence; and the fade-in takes
  /// no less time by this clock.
  void report_wait(double seconds) noexcept {
    waited_ = std::max(0.0, seconds);
    note_silence(watchdog_.verdict(seconds));
  }

  /// Reports that the loop answers, although it asks for no force.
  void keep_alive() noexcept { heartbeat_.fetch_add(1, std::memory_order_acq_rel); }

  /// Reports the wrench that the device did render, when it differs from what `limit` returned.
  void report_applied(const Wrench& wrench) noexcept;

  /// Counts an exception of the user's code and enters the fault state.
  void report_exception() noexcept;

  /// The requests to the guard: emergency stop, reset, waiting until the tool is free.
  [[nodiscard]] Requests& requests() noexcept { return *requests_; }

  [[nodiscard]] ArmingState state() const noexcept { return published_state_.load(std::memory_order_acquire); }

  /// Reports that the last wrench is written. The watchdog waits for no further wrench, and the state is `off`.
  void finish() noexcept {
    heartbeat_.store(0, std::memory_order_release);
    published_state_.store(ArmingState::off, std::memory_order_release);
  }

  /// Grows with every wrench that `limit` returns, for a watchdog in another thread. 0 before the first wrench and
  /// after the last one.
  [[nodiscard]] const std::atomic<std::uint64_t>& heartbeat() const noexcept { return heartbeat_; }

  [[nodiscard]] SafetyLog& log() noexcept { return log_; }
  [[nodiscard]] const SafetyLog& log() const noexcept { return log_; }

  /// The commanded and the applied wrench of the last tick; for the thread of the loop.
  [[nodiscard]] const DeviceOutput& output() const noexcept { return output_; }

  [[nodiscard]] double period() const noexcept { return options_.period; }  ///< [s] duration of a tick
  [[nodiscard]] double slew() const noexcept { return slew_; }              ///< [N/s] limit in use
  [[nodiscard]] double max_force() const noexcept { return max_force_; }    ///< [N] limit in use

 private:
  void keep_time(const DeviceState& reading) noexcept;
  void watch_pace(bool good) noexcept;
  void note_silence(Watchdog::Verdict verdict) noexcept;
  [[nodiscard]] bool is_often_late() noexcept;
  void apply_requests() noexcept;
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
  Watchdog watchdog_;
  TickClock clock_;
  ThermalBudget thermal_;

  Requests own_requests_;
  Requests* requests_;
  std::atomic<Watchdog::Verdict> worst_silence_{Watchdog::Verdict::alive};  // since the last tick
  std::atomic<ArmingState> published_state_{ArmingState::off};
  std::atomic<std::uint64_t> heartbeat_{0};
  Watchdog::Verdict silence_ = Watchdog::Verdict::alive;  // last verdict, for the watchdog's thread only
  std::array<std::uint64_t, 3> late_beats_{};  // heartbeats at the last times that were late; for its thread only

  bool started_ = false;
  Reading reading_ = Reading::bad;
  double last_time_ = 0;                                     // [s] time of the last reading
  double waited_ = std::numeric_limits<double>::infinity();  // [s] since the last tick; infinite: not reported
  TickClock::Elapsed elapsed_;
  int not_finite_ = 0;
  Pose X_BS_last_;          // pose of the last admitted reading
  Vec3 motion_, rotation_;  // since then
  Vec3 low_seen_, high_seen_;
  Mat3 R_BS_seen_;      // the first while the units are checked
  double rotated_ = 0;  // [rad] farthest from it
  double watched_ = 0;  // [s] for which the units were checked
  Wrench before_ramp_;  // wrench of the last tick: the slew limit starts from it
  DeviceOutput output_;
};

}  // namespace hapticut
