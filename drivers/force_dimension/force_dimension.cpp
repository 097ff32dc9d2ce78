// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/force_dimension.hpp"

#include <array>
#include <atomic>
#include <thread>

#include "device/angular_velocity_estimate.hpp"
#include "device/ticks_in.hpp"
#include "device/usages.hpp"
#include "force_dimension/connection.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/realtime/realtime.hpp"

namespace hapticut {
namespace {

using force_dimension::Connection;
using force_dimension::ForceOff;
using force_dimension::Reply;
using force_dimension::Status;

constexpr double kStatusTime = 10e-3;  // [s] between two polls of the status
constexpr double kRecoveryTime = 0.1;  // [s] between two attempts to switch the forces on again
constexpr int kMaxFailures = 100;      // failed calls in a row after which a device counts as lost

class ForceDimensionDevice final : public PolledDevice {
 public:
  ForceDimensionDevice(const ForceDimensionOptions& options, const std::string& name)
      : PolledDevice(name, {}), options_(options), connection_(options) {
    set_capabilities(connection_.capabilities());
    if (!options_.clock) options_.clock = monotonic_time;
  }

 protected:
  void begin_run(const RunOptions& options) override;
  bool read(DeviceState& state) noexcept override;
  Wrench write(const Wrench& wrench) noexcept override;
  void end_run() noexcept override;
  [[nodiscard]] std::vector<std::string> warnings() override;
  [[nodiscard]] bool is_simulated() const override { return simulated_; }
  void scale_output(double scale) noexcept override;

 private:
  void poll_status() noexcept;
  void record(const Reply& reply) noexcept;

  ForceDimensionOptions options_;
  bool simulated_ = bool(options_.clock);  // the options have a custom clock
  Connection connection_;
  AngularVelocityEstimate angular_velocity_;

  // State of a run.
  double period_ = 1e-3, begin_ = 0, last_read_ = 0;
  std::uint64_t tick_ = 0, next_try_ = 0;
  std::uint32_t epoch_ = 0;
  bool on_ = true, calibrated_ = true;  // at the last poll
  bool enable_pending_ = false;         // the forces are off because they were not switched on yet
  ForceOff cause_ = ForceOff::none;     // why the forces are off
  bool answered_ = true;                // the last reading succeeded
  int failures_ = 0;                    // failed calls in a row
  std::uint64_t saturated_ = 0;
  std::array<std::uint64_t, std::size_t(ForceOff::count)> switched_off_{};
  Wrench rendered_;
  DeviceFault fatal_ = DeviceFault::none;
  int fatal_error_ = 0;
  std::array<char, 128> fatal_words_{};

  // Between the loop and the watchdog's thread.
  std::array<std::atomic<double>, 6> written_{};
  std::atomic<bool> rendering_{false}, scaling_{false};
};

void ForceDimensionDevice::begin_run(const RunOptions& options) {
  if (options_.watchdog < 2 * options.guard.period)
    throw Error("ForceDimensionOptions::watchdog"_name + " = " + format_number(options_.watchdog) +
                " s is shorter than two ticks of " + format_number(options.guard.period) +
                " s, so the device would switch its forces off all the time; shorten " + "GuardOptions::period"_name +
                ".");
  connection_.begin();
  angular_velocity_.restart();
  period_ = options.guard.period;
  tick_ = next_try_ = saturated_ = 0;
  on_ = calibrated_ = answered_ = true;
  enable_pending_ = false;
  cause_ = ForceOff::none;
  failures_ = fatal_error_ = 0;
  rendered_ = {};
  fatal_ = DeviceFault::none;
  fatal_words_.fill('\0');
  switched_off_.fill(0);
  for (std::atomic<double>& part : written_) part.store(0, std::memory_order_relaxed);
  rendering_ = true;
}

// Records an error, and whether it ends the run.
void ForceDimensionDevice::record(const Reply& reply) noexcept {
  if (reply.saturated) ++saturated_;
  if (reply.ok || fatal_ != DeviceFault::none) return;
  fatal_ = reply.fault;
  if (fatal_ == DeviceFault::none && ++failures_ > kMaxFailures) fatal_ = DeviceFault::disconnected;
  if (fatal_ == DeviceFault::none) return;
  fatal_error_ = reply.error;
  Connection::copy_last_error(fatal_words_);
}

// Polls whether the device has switched its forces off, and whether it is calibrated.
void ForceDimensionDevice::poll_status() noexcept {
  Status status;
  const Reply asked = connection_.read_status(status);
  record(asked);
  if (!asked.ok) return;
  if (!status.calibrated) {
    calibrated_ = on_ = false;
    enable_pending_ = true;  // switch the forces on after calibration
    return;
  }
  if (!calibrated_) ++epoch_;  // poses before and after are not comparable
  calibrated_ = true;
  if (status.force) {
    on_ = true;
    enable_pending_ = false;
    return;
  }
  if (!enable_pending_ && (on_ || status.cause != cause_)) {
    ++switched_off_[std::size_t(status.cause)];
    next_try_ = tick_ + ticks_in(kRecoveryTime, period_);
  }
  on_ = false;
  cause_ = status.cause;
  if ((!enable_pending_ && !can_reenable(cause_)) || tick_ < next_try_) return;
  next_try_ = tick_ + ticks_in(kRecoveryTime, period_);
  (void)connection_.switch_on();  // the next poll shows the result
}

bool ForceDimensionDevice::read(DeviceState& state) noexcept {
  const double now = options_.clock();
  if (tick_ == 0) begin_ = last_read_ = now;
  const bool too_late = now - last_read_ > options_.watchdog;  // for the device's watchdog
  last_read_ = now;

  const Reply pose = connection_.read(state);
  record(pose);
  answered_ = pose.ok;
  if (tick_ % ticks_in(kStatusTime, period_) == 0 || too_late) poll_status();
  ++tick_;
  if (pose.ok && !connection_.reports_angular_velocity())
    state.velocity.angular = angular_velocity_.update(state.X_BS.rotation, now);
  state.time = now - begin_;
  state.sequence = tick_;
  state.epoch = epoch_;
  state.valid = pose.ok && calibrated_;
  state.fault = DeviceFault::none;
  if (!calibrated_)
    state.fault = DeviceFault::uncalibrated;
  else if (!on_)
    state.fault = fault_of(cause_);
  if (fatal_ != DeviceFault::none) state.fault = fatal_;
  return true;
}

Wrench ForceDimensionDevice::write(const Wrench& wrench) noexcept {
  for (Eigen::Index n = 0; n < 3; ++n) {
    written_[std::size_t(n)].store(wrench.force[n], std::memory_order_relaxed);
    written_[std::size_t(3 + n)].store(wrench.torque[n], std::memory_order_relaxed);
  }
  const Reply written = connection_.write(wrench);
  // If a user action or a missing calibration keeps the forces off, a refused command is no error.
  const bool counts = on_ || (calibrated_ && !enable_pending_ && can_reenable(cause_));
  if (counts) record(written);
  if (answered_ && (written.ok || !counts)) failures_ = 0;
  // After a failed command the device keeps the one before, unless it is disconnected. Forces that are switched on
  // again start from zero.
  if (!on_ || fatal_ == DeviceFault::disconnected)
    rendered_ = {};
  else if (written.ok)
    rendered_ = wrench;
  return rendered_;
}

// While the loop does not answer: writes a fraction of its last force, which also feeds the device's watchdog and keeps
// the weight of the arm compensated. If the loop resumes at this moment, it overwrites this force one tick later.
void ForceDimensionDevice::scale_output(double scale) noexcept {
  if (scale >= 1) return;  // late, but not yet fading: the device still renders that force
  const auto part = [&](std::size_t n) { return scale * written_[n].load(std::memory_order_relaxed); };
  scaling_ = true;
  if (rendering_) (void)connection_.write({Vec3(part(0), part(1), part(2)), Vec3(part(3), part(4), part(5))});
  scaling_ = false;
}

void ForceDimensionDevice::end_run() noexcept {
  rendering_ = false;
  while (scaling_) std::this_thread::yield();  // nothing may follow the zero force
  connection_.end();
}

std::vector<std::string> ForceDimensionDevice::warnings() {
  std::vector<std::string> words = connection_.warnings();
  for (std::size_t n = 0; n < switched_off_.size(); ++n)
    if (switched_off_[n] > 0)
      words.push_back("The device switched its forces off " +
                      (switched_off_[n] == 1 ? "once" : std::to_string(switched_off_[n]) + " times") + ": " +
                      describe(ForceOff(n)) + ".");
  if (saturated_ > 0)
    words.push_back("The motors could not render all of the command in " + std::to_string(saturated_) + " ticks.");
  if (fatal_error_ != 0)
    words.push_back("Force Dimension: " + std::string(fatal_words_.data()) + " (error " + std::to_string(fatal_error_) +
                    ").");
  return words;
}

}  // namespace

std::unique_ptr<Device> open_force_dimension(const ForceDimensionOptions& options) {
  return std::make_unique<ForceDimensionDevice>(
      options, options.device_name.empty() ? "forcedimension" : "forcedimension:" + options.device_name);
}

void use_force_dimension() {
  register_device_driver({"forcedimension", kForceDimensionUsage, "", [](const std::string& rest) {
                            ForceDimensionOptions options;
                            options.device_name = rest;
                            return open_force_dimension(options);
                          }});
}

}  // namespace hapticut
