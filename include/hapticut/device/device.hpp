// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/realtime/histogram.hpp"
#include "hapticut/realtime/realtime.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut {

/// The user's code for one tick: maps a reading to the wrench that the device renders until the next reading.
///
/// It is called for each new reading. A device that is slower than the loop has none in some ticks; they render the
/// same command. A model that stepped in them would take the hand's velocity for zero, and make the hand oscillate. It
/// runs in the thread of the loop, so it should neither allocate nor wait. When `DeviceState::valid` is false, the pose
/// is the last good one, and the returned force is not rendered. An exception ends the run without a force, and
/// `Device::run` throws it again.
using DeviceCallback = std::function<DeviceCommand(const DeviceState&)>;

/// Options of a run. `guard.period` is the period of its ticks, for the loop, the guard, the driver and simulated
/// devices.
struct RunOptions {
  double seconds = 0;           ///< [s] device time after which the run ends; 0: it ends when it is stopped
  bool simulated_time = false;  ///< whether a simulated device runs as fast as the callback allows, with exact periods
  /// Whether SIGINT, SIGTERM and SIGHUP end the run without force, before they act as usual
  bool stop_on_signals = true;

  /// Whether a crash switches the force off first.
  /// SIGSEGV, SIGABRT, SIGFPE, SIGBUS and SIGILL switch the force off within 0.3 s, then the previous handlers are
  /// called. This is an emergency stop: if the process survives, because its runtime handles the signal (Java, .NET,
  /// Mono), `reset_fault` brings the force back. If the thread of the loop itself crashes, the watchdog switches the
  /// force off, for devices that another thread can reach. Use this in standalone programs only; leave it off inside
  /// another program (Unity, Python). It has no effect in simulated time.
  bool stop_on_crash = false;
  RealtimeOptions realtime;  ///< scheduling of devices whose loop runs in the thread of the caller
  GuardOptions guard;        ///< the safety pipeline; it cannot be switched off
};

constexpr auto fields_of(Of<RunOptions>) {
  using O = RunOptions;
  return std::tuple{
      field("seconds", &O::seconds, "s", Range::not_negative(),
            "device time after which the run ends; 0: it ends when it is stopped"),
      field("simulated_time", &O::simulated_time,
            "whether a simulated device runs as fast as the callback allows, with exact periods"),
      field("stop_on_signals", &O::stop_on_signals,
            "whether SIGINT, SIGTERM and SIGHUP end the run without force, before they act as usual"),
      field("stop_on_crash", &O::stop_on_crash, "whether a crash switches the force off first"),
      field("realtime", &O::realtime, "scheduling of devices whose loop runs in the thread of the caller"),
      field("guard", &O::guard, "the safety pipeline; it cannot be switched off"),
  };
}

/// The report of a run.
struct RunReport {
  double period = 1e-3;  ///< [s] duration of a tick: as requested, or as the device determines it
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;  ///< ticks that were skipped because the loop was late
  LatencyHistogram wake_up;  ///< how late the ticks began; for a driver's own loop the deviation of the period
  LatencyHistogram compute;  ///< duration of callback and guard
  std::string end;           ///< why the run ended, in words
  DeviceFault fault = DeviceFault::none;              ///< that ended the run
  ArmingState arming = ArmingState::off;              ///< state of the guard when the run ended
  std::array<std::uint64_t, kSafetyEvents> events{};  ///< number of ticks, by SafetyEvent
  std::vector<SafetyLogEntry> log;                    ///< entries that were not drained during the run
  std::vector<std::string> warnings;  ///< settings that were not permitted, and complaints of the driver
};

class Servo;

/// A haptic device, real or simulated.
///
/// `run` drives the loop. If the driver has its own servo thread (OpenHaptics), the callback runs there; for all other
/// devices it runs in the thread that called `run`. The callback sees no difference. In both cases the safety guard
/// stands between the callback and the motors.
///
/// One thread calls `run`. Any thread may call the other functions, also during a run.
class Device {
 public:
  /// Closes the device.  @pre no run is in progress
  virtual ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< with which it was opened
  [[nodiscard]] const DeviceCapabilities& capabilities() const { return capabilities_; }

  /// Runs until `stop`, until the callback requests the end, until RunOptions::seconds are over, or until the device is
  /// lost. In every case the motors have received a zero force before it returns. It does not return while the callback
  /// runs; if the callback hangs, the force is switched off meanwhile.
  /// @throws Error when an option is out of range or the device cannot be started; also what the callback threw
  RunReport run(const DeviceCallback& callback, const RunOptions& options = {});

  /// The mailbox of stop, emergency stop, reset and interruption. Safe in a signal handler.
  [[nodiscard]] Requests& requests() noexcept { return requests_; }
  void stop() noexcept { requests_.stop(); }                                    ///< see Requests::stop
  void emergency_stop() noexcept { requests_.emergency_stop(); }                ///< see Requests::emergency_stop
  void reset_fault() noexcept { requests_.reset_fault(); }                      ///< see Requests::reset_fault
  void interrupt(SafetyEvent reason) noexcept { requests_.interrupt(reason); }  ///< see Requests::interrupt

  /// Whether a run is in progress, which `stop` would end.
  [[nodiscard]] bool is_running() const noexcept {
    return run_state_.load(std::memory_order_acquire) == RunState::running;
  }

  /// The last reading that the guard admitted; not `valid` before the first one.
  [[nodiscard]] DeviceState state() const;

  /// The commanded and the applied wrench of the last tick, and why they differ. After a run: of the last tick before
  /// the fade-out.
  [[nodiscard]] DeviceOutput output() const;

  /// The state of the guard.
  [[nodiscard]] ArmingState arming() const;

  /// The output of the previous tick, without a lock, for code that runs in the loop.
  /// @pre a run is in progress, in this thread
  [[nodiscard]] const DeviceOutput& last_output() const noexcept { return guard_->output(); }
  [[nodiscard]] const DeviceState& last_state() const noexcept { return guard_->admitted(); }  ///< reading of this tick
  [[nodiscard]] ArmingState last_arming() const noexcept { return guard_->state(); }
  [[nodiscard]] double period() const noexcept { return guard_->period(); }  ///< [s] duration of a tick of this run

  /// Removes and returns the entries of the safety log; empty before the first run.
  [[nodiscard]] std::vector<SafetyLogEntry> drain_log();

  /// The number of ticks of the run that reported an event.
  [[nodiscard]] std::uint64_t count(SafetyEvent event) const;

 protected:
  Device(std::string name, DeviceCapabilities capabilities);

  /// Drives the loop with `servo.tick` until `servo.should_end`, and leaves the motors without force.
  /// @return why the loop ended, in words
  virtual std::string drive(Servo& servo, const RunOptions& options) = 0;

  /// Decides the period of the ticks of a run, for devices that may impose their own. Called before the run begins. The
  /// whole run uses the result.
  /// @param asked  [s] GuardOptions::period
  /// @throws Error when no period suits
  [[nodiscard]] virtual double choose_period(double asked) { return asked; }

  /// Scales the force that the device renders, from another thread, because the loop does not answer. Some devices can
  /// only switch the force off (0). Only for devices that hold the last force without further commands.
  virtual void scale_output(double /*scale*/) noexcept {}

  /// For devices that know their capabilities only after they are open.
  void set_capabilities(const DeviceCapabilities& capabilities) { capabilities_ = capabilities; }

 private:
  friend class Servo;
  struct Latest;
  enum class RunState : std::uint8_t { idle, beginning, running };

  std::string name_;
  DeviceCapabilities capabilities_;
  std::atomic<RunState> run_state_{RunState::idle};
  Requests requests_;
  std::unique_ptr<Latest> latest_;
  mutable std::mutex guard_mutex_;  // for readers in other threads; the loop never takes it
  std::unique_ptr<SafetyGuard> guard_;
};

/// The interface of a run for `Device::drive`.
class Servo {
 public:
  /// One tick: guards the reading, calls the user's code, guards the force.
  /// @return the wrench that the motors must render
  /// @realtime no allocation, no lock, except in the user's code
  Wrench tick(const DeviceState& reading) noexcept;

  /// Reports the wrench that the motors did render, if it differs from what `tick` returned.
  void report_applied(const Wrench& wrench) noexcept;

  /// Whether the run must end, for any reason.
  [[nodiscard]] bool should_end() const noexcept;

  /// The reason in words, if nothing went wrong.
  [[nodiscard]] const char* why_it_ended() const noexcept;

  /// The force of the n-th tick after the end, n = 0, 1, ... It fades to zero over kFadeOut. It is zero at once after
  /// an error or an emergency stop.
  [[nodiscard]] Wrench fading_force(int n) noexcept;
  static constexpr double kFadeOut = 20e-3;  ///< [s]

  /// Reports that the last force is written and is zero. What follows may take any time.
  void finish() noexcept {
    report_.arming = guard_.state();
    guard_.finish();
  }

  void report_wake_up(double late) noexcept { report_.wake_up.add(late); }
  void report_missed(std::uint64_t ticks) noexcept { report_.missed += ticks; }

  /// Reports that the device was lost, if no reading says so. Only after the loop has ended.
  void report_lost(DeviceFault fault) noexcept {
    lost_ = true;
    report_.fault = fault;
  }

  /// Adds a warning to the report. Only before the loop begins and after it has ended.
  void warn(std::string text) { report_.warnings.push_back(std::move(text)); }

  [[nodiscard]] ArmingState arming() const noexcept { return guard_.state(); }
  [[nodiscard]] std::uint64_t ticks() const noexcept { return report_.ticks; }

 private:
  friend class Device;
  Servo(Device& device, SafetyGuard& guard, const DeviceCallback& callback, const RunOptions& options);
  void publish(const DeviceState& state) noexcept;

  Device& device_;
  SafetyGuard& guard_;
  const DeviceCallback& callback_;
  double seconds_;
  bool in_real_time_;
  double last_began_ = 0;  // [s] when the last tick began, by the clock of the computer
  DeviceCommand command_;  // for the last reading
  RunReport report_;
  std::exception_ptr exception_;
  double begin_ = 0;
  bool callback_ended_ = false, time_is_up_ = false, lost_ = false;
  int loop_number_ = -1;
};

/// A device whose driver is polled: the thread of the caller reads, computes and writes in every tick.
class PolledDevice : public Device {
 protected:
  using Device::Device;

  /// Called before the first tick of a run, in the thread of the loop.  @throws Error when the device cannot be started
  virtual void begin_run(const RunOptions& /*options*/) {}

  /// Fills in the next reading.  @return false when no further reading will come
  virtual bool read(DeviceState& state) noexcept = 0;

  /// Renders a wrench.  @return the wrench that was rendered
  virtual Wrench write(const Wrench& wrench) noexcept = 0;

  /// Called after the last tick, when a zero wrench was written. Called after every `begin_run` that did not throw.
  virtual void end_run() noexcept {}

  /// Warnings for the report of the run, called after `end_run`.
  [[nodiscard]] virtual std::vector<std::string> warnings() { return {}; }

  /// Whether the device can be run in simulated time.
  [[nodiscard]] virtual bool is_simulated() const { return false; }

  std::string drive(Servo& servo, const RunOptions& options) final;
};

/// A kind of device that `open_device` knows.
struct DeviceDriver {
  std::string scheme;   ///< before the colon: "mock"
  std::string usage;    ///< "mock:PATH, PATH one of rest, line, ..."
  std::string missing;  ///< empty when it can be used; otherwise what to install
  /// Opens a device by the text behind the colon.  @throws Error
  std::function<std::unique_ptr<Device>(const std::string& rest)> open;
};

/// Opens a device by its name: "mock:spiral", "mouse", "openhaptics", "openhaptics:Left Device".
/// @throws Error that names the requested device, the available kinds, and what to install
[[nodiscard]] std::unique_ptr<Device> open_device(const std::string& name);

/// Adds a kind of device, or replaces the kind of the same scheme.
void register_device_driver(DeviceDriver driver);

/// All known kinds of devices, usable or not.
[[nodiscard]] std::vector<DeviceDriver> device_drivers();

}  // namespace hapticut
