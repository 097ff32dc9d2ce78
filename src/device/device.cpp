// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/device.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "core/at_end.hpp"
#include "device/running_loops.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/realtime/triple_buffer.hpp"

namespace hapticut {

namespace {

/// The state of a device before its first reading.
DeviceState no_reading() {
  DeviceState state;
  state.valid = false;
  return state;
}

}  // namespace

struct Device::Latest {
  std::mutex readers;
  TripleBuffer<DeviceState> state{no_reading()};
  TripleBuffer<DeviceOutput> output;
};

Device::Device(std::string name, DeviceCapabilities capabilities)
    : name_(std::move(name)), capabilities_(std::move(capabilities)), latest_(std::make_unique<Latest>()) {}

Device::~Device() { HAPTICUT_ASSERT(run_state_ == RunState::idle); }

DeviceState Device::state() const {
  const std::lock_guard lock(latest_->readers);
  return latest_->state.latest();
}

DeviceOutput Device::output() const {
  const std::lock_guard lock(latest_->readers);
  return latest_->output.latest();
}

ArmingState Device::arming() const {
  const std::lock_guard lock(guard_mutex_);
  return guard_ ? guard_->state() : ArmingState::off;
}

std::vector<SafetyLogEntry> Device::drain_log() {
  const std::lock_guard lock(guard_mutex_);
  return guard_ ? guard_->log().drain() : std::vector<SafetyLogEntry>();
}

std::uint64_t Device::count(SafetyEvent event) const {
  const std::lock_guard lock(guard_mutex_);
  return guard_ ? guard_->log().count(event) : 0;
}

RunReport Device::run(const DeviceCallback& callback, const RunOptions& asked) {
  if (!callback)
    throw Error("Device::run"_name + " needs a callback; pass a function from DeviceState to DeviceCommand.");
  require_fields_within(asked, "RunOptions::");
  require_within(asked.guard.period, range_of(&GuardOptions::period), "GuardOptions::period [s]");
  RunState idle = RunState::idle;
  if (!run_state_.compare_exchange_strong(idle, RunState::beginning))
    throw Error("The device \"" + name_ + "\" runs already; stop it before running it again.");
  const AtEnd idle_again([this] { run_state_.store(RunState::idle); });
  RunOptions options = asked;
  options.guard.period = choose_period(asked.guard.period);
  {
    const std::lock_guard lock(guard_mutex_);
    guard_ = std::make_unique<SafetyGuard>(capabilities_, options.guard, &requests_);
  }
  const AtEnd off_again([this] { guard_->stop(); });
  requests_.forget_stop();  // only here: from now on other threads see the run and may stop it
  run_state_.store(RunState::running, std::memory_order_release);
  const bool crashes = options.stop_on_crash && !options.simulated_time;  // no hand feels the force in simulated time
  const int loop_number = running_loops::acquire(crashes);
  if (loop_number < 0)
    throw Error("More than " + std::to_string(running_loops::kMaxLoops) +
                " devices would be running at once in this process; stop one first.");
  if (options.stop_on_signals) running_loops::catch_signals();
  if (crashes) running_loops::catch_crashes();
  const AtEnd process_again([&] {
    running_loops::give_back(loop_number);
    if (crashes) running_loops::release_crashes();
    if (options.stop_on_signals) running_loops::release_signals();
  });
  Servo servo(*this, *guard_, callback, options);
  servo.loop_number_ = loop_number;
  servo.report_.period = options.guard.period;
  if (options.guard.period != asked.guard.period)
    servo.warn("The device \"" + name_ + "\" imposes its own period: " + format_number(asked.guard.period) +
               " s became " + format_number(options.guard.period) + " s.");
  guard_->start();
  {
    // No tick can be late in simulated time.
    std::unique_ptr<WatchdogThread> watchdog;
    if (!options.simulated_time)
      watchdog = std::make_unique<WatchdogThread>(
          Watchdog(options.guard.watchdog, options.guard.period), guard_->heartbeat(),
          [this, &loop = running_loops::loop(loop_number)](Watchdog::Verdict verdict, double scale) {
            // A loop that does not handle an emergency stop may have crashed itself: its force is not faded out.
            if (loop.emergency.load(std::memory_order_acquire)) scale = 0;
            scale_output(scale);
            if (scale <= 0) loop.quiet.store(true, std::memory_order_release);
            guard_->report_silence(verdict, scale);
          });
    servo.report_.end = drive(servo, options);
  }
  RunReport report = std::move(servo.report_);
  if (guard_->state() != ArmingState::off) report.arming = guard_->state();  // there was no last tick
  for (std::size_t n = 0; n < kSafetyEvents; ++n) report.events[n] = guard_->log().count(SafetyEvent(n));
  report.log = guard_->log().drain();
  if (servo.exception_) std::rethrow_exception(servo.exception_);
  return report;
}

Servo::Servo(Device& device, SafetyGuard& guard, const DeviceCallback& callback, const RunOptions& options)
    : device_(device),
      guard_(guard),
      callback_(callback),
      seconds_(options.seconds),
      in_real_time_(!options.simulated_time) {}

Wrench Servo::tick(const DeviceState& reading) noexcept {
  const double began = monotonic_time();
  if (report_.ticks++ == 0)
    begin_ = reading.time;
  else if (const double waited = began - last_began_; in_real_time_ && waited > guard_.period())
    guard_.report_wait(waited);  // a driver that has its own clock may catch up
  last_began_ = began;
  running_loops::RunningLoop& loop = running_loops::loop(loop_number_);
  if (loop.emergency.exchange(false, std::memory_order_acq_rel)) device_.emergency_stop();

  const DeviceState& state = guard_.admit(reading);
  if (guard_.repeats()) {
    command_.contact.motor = command_.contact.motor ? std::optional(0.0) : std::nullopt;  // it is that of one step
  } else if (!exception_) {
    try {
      command_ = callback_(state);
    } catch (...) {
      exception_ = std::current_exception();
      guard_.report_exception();
      command_ = {};
    }
  }
  callback_ended_ = callback_ended_ || command_.stop;
  time_is_up_ = time_is_up_ || (seconds_ > 0 && reading.time - begin_ >= seconds_);
  if (reading.fault == DeviceFault::disconnected || reading.fault == DeviceFault::driver_error)
    report_lost(reading.fault);
  Wrench wrench = guard_.limit(command_.wrench, command_.contact);
  loop.quiet.store(wrench.force.isZero(0) && wrench.torque.isZero(0), std::memory_order_release);
  publish(state);
  report_.compute.add(monotonic_time() - began);
  return wrench;
}

void Servo::report_applied(const Wrench& wrench) noexcept {
  guard_.report_applied(wrench);
  device_.latest_->output.write(guard_.output());
}

void Servo::publish(const DeviceState& state) noexcept {
  device_.latest_->state.write(state);
  device_.latest_->output.write(guard_.output());
}

bool Servo::should_end() const noexcept {
  return callback_ended_ || time_is_up_ || lost_ || exception_ || device_.requests_.stop_wanted() ||
         running_loops::loop(loop_number_).stop.load(std::memory_order_acquire);
}

const char* Servo::why_it_ended() const noexcept {
  if (callback_ended_) return "the callback ended it";
  return time_is_up_ ? "its time was up" : "stopped";
}

Wrench Servo::fading_force(int n) noexcept {
  guard_.keep_alive();
  const bool emergency = device_.requests_.emergency() || running_loops::loop(loop_number_).emergency.load();
  const bool may_fade = !lost_ && !exception_ && !emergency && guard_.state() != ArmingState::fault;
  if (!may_fade) return {};
  const double scale = 1 - double(n + 1) / std::max(1.0, std::round(kFadeOut / guard_.period()));
  if (scale <= 0) return {};
  return {scale * guard_.output().applied.force, scale * guard_.output().applied.torque};
}

std::string PolledDevice::drive(Servo& servo, const RunOptions& options) {
  const bool simulated = options.simulated_time && is_simulated();
  if (options.simulated_time && !simulated)
    throw Error("The device \"" + name() + "\" cannot run in simulated time; do not set " +
                "RunOptions::simulated_time"_name + ".");
  // Before begin_run: locking the memory takes longer than a started device may wait for its first command.
  std::unique_ptr<RealtimeScope> scope;
  if (!simulated) {
    scope = std::make_unique<RealtimeScope>(options.realtime);
    for (const std::string& warning : scope->warnings()) servo.warn(warning);
  }
  begin_run(options);
  std::string end;
  {
    const AtEnd the_run([this] { end_run(); });
    PeriodicClock clock(options.guard.period);
    const auto wait = [&] {
      if (simulated) return;
      const PeriodicClock::Tick tick = clock.wait();
      servo.report_wake_up(tick.late);
      servo.report_missed(tick.missed);
    };
    DeviceState state;
    bool more = true;
    while (!servo.should_end()) {
      wait();
      more = read(state);
      if (!more) break;
      servo.report_applied(write(servo.tick(state)));
    }
    end = servo.why_it_ended();
    if (!more) end = "the device has no more readings";
    if (state.fault == DeviceFault::disconnected || state.fault == DeviceFault::driver_error)
      end = describe(state.fault);
    for (int n = 0;; ++n) {
      const Wrench wrench = servo.fading_force(n);
      write(wrench);
      if (wrench.force.isZero(0) && wrench.torque.isZero(0)) break;
      wait();
    }
    servo.finish();
  }
  for (std::string& warning : warnings()) servo.warn(std::move(warning));
  return end;
}

}  // namespace hapticut
