// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/open_haptics.hpp"

#include <HD/hd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "device/angular_velocity_estimate.hpp"
#include "device/ticks_in.hpp"
#include "device/usages.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "open_haptics/connection.hpp"
#include "open_haptics/errors.hpp"
#include "open_haptics/scheduler.hpp"

namespace hapticut {
namespace {

using open_haptics::Connection;
using open_haptics::drain;
using open_haptics::Entry;
using open_haptics::Scheduler;

constexpr double kTemperatureTime = 0.1;   // [s] between two readings of the temperature
constexpr double kCalibrationTime = 1;     // [s] between two checks, while the device is calibrated
constexpr double kUncalibratedTime = 0.1;  // [s] between two checks, while it is not
constexpr double kTooWarm = 1;             // [1] a temperature at which the guard reduces the force
constexpr double kCooled = 0.5;            // [1] measured temperature below which a warning of warm motors ends

/// The rotation of a column-major matrix, made orthonormal, because the driver's matrix has small errors.
Mat3 rotation_of(const std::array<HDdouble, 16>& m) {
  const Vec3 z = Vec3(m[8], m[9], m[10]).normalized();
  const Vec3 x = Vec3(m[4], m[5], m[6]).cross(z).normalized();
  Mat3 R;
  R << x, z.cross(x), z;
  return R;
}

// All devices share one error stack, so the device that drains it first also finds the errors of the others.
constexpr std::size_t kMaxDevices = 16;
std::array<std::atomic<DeviceFault>, kMaxDevices> faults_by_handle{};

/// The more severe of two faults.
DeviceFault more_severe(DeviceFault a, DeviceFault b) {
  const auto rank = [](DeviceFault f) { return f == DeviceFault::disconnected ? 100 : int(f); };
  return rank(a) < rank(b) ? b : a;
}

class OpenHapticsDevice final : public Device, private open_haptics::TickTarget {
 public:
  OpenHapticsDevice(const OpenHapticsOptions& options, const std::string& name)
      : Device(name, {}), options_(options), connection_(options) {
    set_capabilities(connection_.capabilities());
    require_fields_within(options, "OpenHapticsOptions::");
    if (!options_.clock) options_.clock = monotonic_time;
  }

 protected:
  std::string drive(Servo& servo, const RunOptions& options) override;
  [[nodiscard]] double choose_period(double asked) override;
  void scale_output(double scale) noexcept override;

 private:
  enum class RunState : std::uint8_t { running, ending, done };
  enum class Ending : std::uint8_t { done, silent, never_began };

  HDCallbackCode tick() noexcept override;
  bool render() noexcept;
  void begin(Servo& servo, const RunOptions& options);
  [[nodiscard]] Ending wait_for_end();
  void close(Entry& entry) noexcept;
  void read(DeviceState& state) noexcept;
  void check_calibration() noexcept;
  void drain_errors() noexcept;
  void write(const Wrench& wrench) noexcept;

  OpenHapticsOptions options_;
  Connection connection_;

  // State of a run. Only the driver's thread accesses it, except the atomics.
  Servo* servo_ = nullptr;
  std::atomic<RunState> run_state_{RunState::done};
  std::atomic<std::uint64_t> ticks_{0};
  double period_ = 1e-3, begin_ = 0, last_time_ = 0;
  int fading_ticks_ = 0;
  std::uint32_t epoch_ = 0;
  HDenum calibration_ = HD_CALIBRATION_OK;
  bool must_calibrate_ = false, warm_ = false;
  double temperature_ = 0;
  DeviceFault fault_ = DeviceFault::none;
  open_haptics::Errors fatal_;
  AngularVelocityEstimate angular_velocity_;
};

void OpenHapticsDevice::read(DeviceState& state) noexcept {
  const std::uint64_t n = ticks_.fetch_add(1, std::memory_order_acq_rel);
  const double now = options_.clock();
  if (n == 0) begin_ = last_time_ = now;
  const double elapsed = n == 0 ? period_ : now - last_time_;
  last_time_ = now;
  servo_->report_wake_up(std::max(0.0, elapsed - period_));
  if (elapsed > 1.5 * period_) servo_->report_missed(std::uint64_t(std::lround(elapsed / period_)) - 1);

  std::array<HDdouble, 16> transform{};
  std::array<HDdouble, 3> velocity{};
  HDint buttons = 0;
  hdGetDoublev(HD_CURRENT_TRANSFORM, transform.data());
  hdGetDoublev(HD_CURRENT_VELOCITY, velocity.data());
  hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons);
  if (connection_.measures_temperature() && n % ticks_in(kTemperatureTime, period_) == 0) {
    std::array<HDdouble, 6> temperatures{};
    hdGetDoublev(HD_MOTOR_TEMPERATURE, temperatures.data());
    temperature_ = *std::max_element(temperatures.begin(), temperatures.end());
    if (temperature_ < kCooled) warm_ = false;
  }
  state.X_BS = {rotation_of(transform), Vec3(transform[12], transform[13], transform[14]) * units::mm};
  state.velocity = {Vec3(velocity[0], velocity[1], velocity[2]) * units::mm,
                    angular_velocity_.update(state.X_BS.rotation, now)};
  state.buttons = std::uint32_t(buttons);
  state.time = now - begin_;
  state.sequence = n + 1;
  state.epoch = epoch_;
  state.temperature = warm_ ? kTooWarm : temperature_;
  state.fault = fault_;
  state.valid = true;
  if (calibration_ == HD_CALIBRATION_NEEDS_MANUAL_INPUT) {
    state.valid = false;
    if (state.fault == DeviceFault::none) state.fault = DeviceFault::uncalibrated;
  }
}

// A calibration makes the pose jump. The tick before it has no force, and the guard waits after it.
void OpenHapticsDevice::check_calibration() noexcept {
  const std::uint64_t n = ticks_.load(std::memory_order_relaxed);
  const double pause = calibration_ == HD_CALIBRATION_OK ? kCalibrationTime : kUncalibratedTime;
  if (connection_.calibration_style() == 0 || n % ticks_in(pause, period_) != 0) return;
  calibration_ = hdCheckCalibration();
  must_calibrate_ =
      calibration_ == HD_CALIBRATION_NEEDS_UPDATE && connection_.calibration_style() != HD_CALIBRATION_ENCODER_RESET;
}

// Assigns the errors of the driver to the next readings of the devices that they concern.
void OpenHapticsDevice::drain_errors() noexcept {
  const HHD own = connection_.handle();
  const open_haptics::Errors errors = drain();
  fault_ = own < kMaxDevices ? faults_by_handle[own].exchange(DeviceFault::none) : DeviceFault::none;
  for (int n = 0; n < errors.count; ++n) {
    const HDErrorInfo& error = errors.kept[std::size_t(n)];
    const DeviceFault fault = open_haptics::fault_of(error.errorCode);
    // A lost connection is reported without a handle in the frame that detects it, so it is this device.
    const bool foreign = error.hHD != own && error.hHD < kMaxDevices && fault != DeviceFault::disconnected &&
                         fault != DeviceFault::driver_error;
    if (foreign)
      faults_by_handle[error.hHD] = more_severe(faults_by_handle[error.hHD], fault);
    else
      fault_ = more_severe(fault_, fault);
  }
  if (fault_ == DeviceFault::motors_warm) warm_ = true;
  if (fault_ == DeviceFault::disconnected || fault_ == DeviceFault::driver_error) fatal_ = errors;
}

void OpenHapticsDevice::write(const Wrench& wrench) noexcept {
  const std::array<HDdouble, 3> force = {wrench.force.x(), wrench.force.y(), wrench.force.z()};
  hdSetDoublev(HD_CURRENT_FORCE, force.data());
  if (capabilities().output_degrees_of_freedom < 6) return;
  const Vec3 t = wrench.torque / units::mN_m;
  const std::array<HDdouble, 3> torque = {t.x(), t.y(), t.z()};
  hdSetDoublev(HD_CURRENT_TORQUE, torque.data());
}

// A frame of the run. It releases the driver while the user's code runs.
// @return whether it acquired the driver again
bool OpenHapticsDevice::render() noexcept {
  Scheduler& scheduler = Scheduler::instance();
  connection_.resume();
  DeviceState state;
  read(state);
  check_calibration();
  scheduler.release_driver();
  Wrench wrench = servo_->tick(state);
  if (servo_->should_end()) run_state_.store(RunState::ending, std::memory_order_relaxed);
  const bool has_driver = scheduler.acquire_driver();
  if (has_driver) hdMakeCurrentDevice(connection_.handle());
  // If another thread has released the hand meanwhile, this force is too old.
  if (!has_driver || connection_.has_released_hand() || must_calibrate_) {
    wrench = {};
    servo_->report_applied(wrench);
  }
  if (has_driver) write(wrench);
  return has_driver;
}

HDCallbackCode OpenHapticsDevice::tick() noexcept {
  Scheduler& scheduler = Scheduler::instance();
  if (!scheduler.acquire_driver()) return HD_CALLBACK_CONTINUE;  // another thread releases a hand
  bool has_driver = true, last = false;
  const HHD handle = connection_.handle();
  hdMakeCurrentDevice(handle);
  hdBeginFrame(handle);
  if (run_state_.load(std::memory_order_relaxed) == RunState::running) {
    has_driver = render();
  } else {
    const Wrench wrench = servo_->fading_force(fading_ticks_++);
    write(wrench);
    last = wrench.force.isZero(0) && wrench.torque.isZero(0);
  }
  hdEndFrame(handle);
  if (has_driver && must_calibrate_) {
    hdUpdateCalibration(connection_.calibration_style());
    calibration_ = HD_CALIBRATION_OK;
    must_calibrate_ = false;
    ++epoch_;
  }
  drain_errors();
  if (has_driver) scheduler.release_driver();
  if (!last) return HD_CALLBACK_CONTINUE;
  servo_->finish();
  run_state_.store(RunState::done, std::memory_order_release);
  return HD_CALLBACK_DONE;
}

double OpenHapticsDevice::choose_period(double asked) {
  return Scheduler::instance().choose_period(asked, connection_.handle());
}

void OpenHapticsDevice::scale_output(double scale) noexcept {
  if (scale <= 0 && !connection_.has_released_hand()) connection_.release_hand();
}

void OpenHapticsDevice::begin(Servo& servo, const RunOptions& options) {
  servo_ = &servo;
  ticks_ = 0;
  fading_ticks_ = 0;
  period_ = options.guard.period;
  fault_ = DeviceFault::none;
  fatal_ = {};
  must_calibrate_ = warm_ = false;
  angular_velocity_.restart();
  Scheduler::instance().between_ticks([this] {
    hdMakeCurrentDevice(connection_.handle());
    calibration_ = connection_.calibration_style() == 0 ? HD_CALIBRATION_OK : hdCheckCalibration();
    drain();
  });
  connection_.enable_force(true);
  run_state_.store(RunState::running, std::memory_order_release);
}

// Waits for the last tick, or until the driver was silent for too long.
OpenHapticsDevice::Ending OpenHapticsDevice::wait_for_end() {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
  Clock::time_point heard = Clock::now();
  std::uint64_t last = 0;
  while (run_state_.load(std::memory_order_acquire) != RunState::done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::uint64_t now = ticks_.load(std::memory_order_acquire);
    const bool ending = run_state_.load(std::memory_order_acquire) == RunState::ending;
    if (now != last) {
      last = now;
      heard = Clock::now();
    }
    if (seconds(Clock::now() - heard) <= (last == 0 || ending ? options_.start_timeout : options_.silence)) continue;
    return last == 0 ? Ending::never_began : Ending::silent;
  }
  return Ending::done;
}

std::string OpenHapticsDevice::drive(Servo& servo, const RunOptions& options) {
  if (options.simulated_time)
    throw Error("An OpenHaptics device cannot run in simulated time; do not set " + "RunOptions::simulated_time"_name +
                ".");
  for (const std::string& warning : connection_.warnings()) servo.warn(warning);
  Scheduler& scheduler = Scheduler::instance();
  begin(servo, options);
  Entry& entry = scheduler.acquire_entry();
  entry.open(*this);
  HDSchedulerHandle handle{};
  try {
    handle = scheduler.join(entry, period_);
  } catch (...) {
    close(entry);
    connection_.enable_force(false);
    throw;
  }
  const Ending ending = wait_for_end();
  const bool hangs = ending == Ending::silent && entry.is_entered();
  if (ending != Ending::done && !connection_.has_released_hand()) connection_.release_hand();
  close(entry);
  scheduler.leave(handle, ending == Ending::done);
  if (ending == Ending::done) scheduler.return_entry(entry);
  if (!connection_.has_released_hand()) connection_.enable_force(false);
  if (ending == Ending::never_began)
    throw Error("The OpenHaptics scheduler runs but never calls back; check that no other program uses the device.");
  if (ending == Ending::silent) {
    servo.report_lost(DeviceFault::disconnected);
    return std::string("the driver stopped calling back") + (hangs ? " because the callback did not return" : "") +
           "; " + describe(DeviceFault::disconnected);
  }
  if (!fatal_.any()) return servo.why_it_ended();
  servo.warn("OpenHaptics: " + fatal_.describe());
  return describe(fault_ == DeviceFault::none ? DeviceFault::disconnected : fault_);
}

// The callback uses objects of the caller, so it must have returned before the run ends, however long that takes.
void OpenHapticsDevice::close(Entry& entry) noexcept {
  entry.close();
  while (entry.is_entered()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  servo_ = nullptr;
}

}  // namespace

std::unique_ptr<Device> open_open_haptics(const OpenHapticsOptions& options) {
  return std::make_unique<OpenHapticsDevice>(
      options, options.device_name.empty() ? "openhaptics" : "openhaptics:" + options.device_name);
}

void use_open_haptics() {
  register_device_driver({"openhaptics", kOpenHapticsUsage, "", [](const std::string& rest) {
                            OpenHapticsOptions options;
                            options.device_name = rest;
                            return open_open_haptics(options);
                          }});
}

}  // namespace hapticut
