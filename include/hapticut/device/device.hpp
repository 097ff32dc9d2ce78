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
#include "hapticut/core/device_state.hpp"
#include "hapticut/realtime/histogram.hpp"
#include "hapticut/realtime/realtime.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut {

/// The user's code of one tick: from a reading to the wrench that the device shall render until the next.
///
/// It runs in the thread of the loop: it should allocate nothing and wait for nothing. When `DeviceState::valid` is
/// false the pose is the last good one, and whatever force is returned will not be felt. An exception ends the run with
/// no force, and comes out of `Device::run`.
using DeviceCallback = std::function<DeviceCommand(const DeviceState&)>;

/// How a run goes. Its ticks have the period `guard.period`, and so has all that takes part in it.
struct RunOptions {
  double seconds = 0;
  bool simulated_time = false;
  bool stop_on_signals = true;

  /// SIGSEGV, SIGABRT, SIGFPE, SIGBUS and SIGILL take the force away within 0.3 s, and then go on to the handlers that
  /// were there before. It is the emergency stop: where the process lives on, because its runtime handles the signal
  /// (Java, .NET, Mono), `reset_fault` brings the force back. In the loop's own thread the watchdog lets go instead, of
  /// devices that another thread can reach. For programs of your own; inside another program (Unity, Python) leave it
  /// off. Simulated time knows no hand, and no crash.
  bool stop_on_crash = false;
  RealtimeOptions realtime;
  GuardOptions guard;
};

constexpr auto fields_of(Of<RunOptions>) {
  using O = RunOptions;
  return std::tuple{
      field("seconds", &O::seconds, "s", Range::not_negative(),
            "of device time after which it ends; 0: when it is stopped"),
      field("simulated_time", &O::simulated_time,
            "devices that are simulated: as fast as the callback allows, with exact periods"),
      field("stop_on_signals", &O::stop_on_signals,
            "SIGINT, SIGTERM and SIGHUP end the run without force, then act as they would"),
      field("stop_on_crash", &O::stop_on_crash, "a crash takes the force away first"),
      field("realtime", &O::realtime, "for devices whose loop runs in our thread"),
      field("guard", &O::guard, "the safety pipeline; it cannot be switched off"),
  };
}

/// What a run was like.
struct RunReport {
  double period = 1e-3;  ///< [s] of a tick: what was asked for, or what the device kept of its own
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;               ///< ticks that were skipped because the loop was late
  LatencyHistogram wake_up;               ///< how late the ticks began; of a driver's own loop: deviation of the period
  LatencyHistogram compute;               ///< the callback and the guard
  std::string end;                        ///< why it ended, in words
  DeviceFault fault = DeviceFault::none;  ///< that ended it
  ArmingState guard = ArmingState::off;   ///< the state of the guard when it ended
  std::array<std::uint64_t, kSafetyEvents> events{};  ///< ticks by SafetyEvent
  std::vector<SafetyLogEntry> log;                    ///< entries that were not drained during the run
  std::vector<std::string> warnings;                  ///< what was not permitted, and what the driver complained about
};

class Servo;

/// A haptic device, or something that stands for one.
///
/// `run` drives the loop. Where the driver has its own servo thread (OpenHaptics) the callback runs there; for all
/// other devices it runs in the thread that called `run`. The callback cannot tell the difference, and the safety guard
/// stands between it and the motors in both.
///
/// `run` belongs to one thread; everything else may be called from any thread, also while it runs.
class Device {
 public:
  /// Closes the device.  @pre no run is under way
  virtual ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< what it was opened as
  [[nodiscard]] const DeviceCapabilities& capabilities() const { return capabilities_; }

  /// Runs until `stop`, until the callback asks for it, until RunOptions::seconds are over, or until the device is
  /// lost. The motors have got a zero force before it returns, whatever happens. It does not return while the callback
  /// is inside what is the caller's: the force of one that hangs is taken away meanwhile.
  /// @throws Error when an option is out of range or the device cannot be started, and what the callback threw
  RunReport run(const DeviceCallback& callback, const RunOptions& options = {});

  /// The mailbox of stop, emergency stop, reset and interruption. Safe in a signal handler.
  [[nodiscard]] Requests& requests() noexcept { return requests_; }
  void stop() noexcept { requests_.stop(); }                                    ///< see Requests::stop
  void emergency_stop() noexcept { requests_.emergency_stop(); }                ///< see Requests::emergency_stop
  void reset_fault() noexcept { requests_.reset_fault(); }                      ///< see Requests::reset_fault
  void interrupt(SafetyEvent reason) noexcept { requests_.interrupt(reason); }  ///< see Requests::interrupt

  /// Whether a run is under way, which `stop` would end.
  [[nodiscard]] bool is_running() const noexcept { return phase_.load(std::memory_order_acquire) == Phase::running; }

  /// The last reading that the guard let through; not `valid` before the first.
  [[nodiscard]] DeviceState state() const;

  /// What was commanded and what was applied in the last tick, and why they differ. After a run: in its last tick,
  /// before the force was faded out.
  [[nodiscard]] DeviceOutput output() const;

  [[nodiscard]] ArmingState arming() const;

  /// The same without a lock, for code that runs in the loop: of the tick before the current one.
  /// @pre a run is under way, in this thread
  [[nodiscard]] const DeviceOutput& last_output() const noexcept { return guard_->output(); }
  [[nodiscard]] const DeviceState& last_state() const noexcept { return guard_->admitted(); }  ///< of this tick
  [[nodiscard]] ArmingState last_arming() const noexcept { return guard_->state(); }
  [[nodiscard]] double period() const noexcept { return guard_->period(); }  ///< [s] of the ticks of this run

  /// Takes the entries of the safety log; empty before the first run.
  [[nodiscard]] std::vector<SafetyLogEntry> drain_log();

  /// How many ticks of the run reported an event.
  [[nodiscard]] std::uint64_t count(SafetyEvent event) const;

 protected:
  Device(std::string name, DeviceCapabilities capabilities);

  /// Drives the loop with `servo.tick` until `servo.should_end`, and leaves the motors without force. Returns why it
  /// ended, in words.
  virtual std::string drive(Servo& servo, const RunOptions& options) = 0;

  /// The period of the ticks of a run, for devices that may keep their own. Asked before the run begins; everything
  /// in it then goes by the answer.
  /// @param asked  [s] GuardOptions::period
  /// @throws Error when there is none that suits
  [[nodiscard]] virtual double settle_period(double asked) { return asked; }

  /// Scales the force that the device renders, from another thread, because the loop does not answer; 0 may be all
  /// that it can. Only for devices that hold the last force by themselves.
  virtual void scale_output(double /*share*/) noexcept {}

  /// For devices that know what they are only once they are open.
  void set_capabilities(const DeviceCapabilities& capabilities) { capabilities_ = capabilities; }

 private:
  friend class Servo;
  struct Latest;
  enum class Phase : std::uint8_t { idle, beginning, running };

  std::string name_;
  DeviceCapabilities capabilities_;
  std::atomic<Phase> phase_{Phase::idle};
  Requests requests_;
  std::unique_ptr<Latest> latest_;
  mutable std::mutex guard_mutex_;  // for readers in other threads; the loop never takes it
  std::unique_ptr<SafetyGuard> guard_;
};

/// A run as the device's loop sees it: what `Device::drive` works with.
class Servo {
 public:
  /// One tick: guards the reading, calls the user's code, guards the force.
  /// @return what the motors shall render
  /// @realtime no allocation, no lock but what the user's code does
  Wrench tick(const DeviceState& reading) noexcept;

  /// Tells what the motors did render, where that is not what `tick` returned.
  void applied(const Wrench& wrench) noexcept;

  /// Whether the run shall end, for whatever reason.
  [[nodiscard]] bool should_end() const noexcept;

  /// In words, where nothing went wrong.
  [[nodiscard]] const char* why_it_ended() const noexcept;

  /// The force of the n-th tick after the end, n = 0, 1, ...: faded to zero over kFarewell, or zero at once when
  /// something is wrong or an emergency stop comes.
  [[nodiscard]] Wrench farewell(int n) const noexcept;
  static constexpr double kFarewell = 20e-3;  ///< [s]

  /// The last force is written, and it is zero; what is still to be done may take its time.
  void rest() noexcept {
    report_.guard = guard_.state();
    guard_.rest();
  }

  void report_wake_up(double late) noexcept { report_.wake_up.add(late); }
  void report_missed(std::uint64_t ticks) noexcept { report_.missed += ticks; }

  /// That the device was lost, where no reading says so. Only after the loop has ended.
  void report_lost(DeviceFault fault) noexcept {
    lost_ = true;
    report_.fault = fault;
  }

  /// Only before the loop begins and after it has ended.
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
  RunReport report_;
  std::exception_ptr exception_;
  double begin_ = 0;
  bool callback_ended_ = false, time_is_up_ = false, lost_ = false;
  int slot_ = -1;
};

/// A device whose driver is asked: our thread reads, computes and writes in every tick.
class PolledDevice : public Device {
 protected:
  using Device::Device;

  /// Before the first tick of a run, in the thread of the loop.  @throws Error when the device cannot be started
  virtual void begin_run(const RunOptions& /*options*/) {}

  /// Fills in the next reading. False: nothing more will come.
  virtual bool read(DeviceState& state) noexcept = 0;

  /// Renders a wrench.  @return what was rendered
  virtual Wrench write(const Wrench& wrench) noexcept = 0;

  /// After the last tick; the last wrench written was zero. Comes after every `begin_run` that did not throw.
  virtual void end_run() noexcept {}

  /// What the report of the run shall say in words, asked after `end_run`.
  [[nodiscard]] virtual std::vector<std::string> warnings() { return {}; }

  /// Whether the device can be run in simulated time.
  [[nodiscard]] virtual bool is_simulated() const { return false; }

  std::string drive(Servo& servo, const RunOptions& options) final;
};

/// A kind of device that `open_device` knows.
struct DeviceDriver {
  std::string scheme;   ///< before the colon: "mock"
  std::string usage;    ///< "mock:PATH, PATH one of rest, line, ..."
  std::string missing;  ///< empty when it can be used; else what to install
  /// Opens what stands behind the colon.  @throws Error
  std::function<std::unique_ptr<Device>(const std::string& rest)> open;
};

/// Opens a device by its name: "mock:spiral", "mouse", "openhaptics", "openhaptics:Left Device".
/// @throws Error that says what was asked for, what there is, and what to install
[[nodiscard]] std::unique_ptr<Device> open_device(const std::string& name);

/// Adds a kind of device, or replaces the one of the same scheme.
void register_device_driver(DeviceDriver driver);

/// The kinds there are, usable or not.
[[nodiscard]] std::vector<DeviceDriver> device_drivers();

}  // namespace hapticut
