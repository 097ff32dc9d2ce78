// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kRampDampingShare = 0.2;
constexpr double kFastPace = 0.6, kSlowPace = 1.9;  // [periods] mean time of a tick
constexpr double kSlowDevice = 0.95;                // [1] good readings per tick
constexpr double kUnitsWatched = 1;                 // [s] after which the spread of positions is checked
constexpr double kImplausiblyFar = 2;               // [m] no desktop device reaches farther
constexpr double kImplausiblySmall = 1e-6;          // [m] spread of all positions within that time
constexpr double kExactRest = 1e-8;                 // [m] spread of a simulated hand that rotates about its point
constexpr double kRotatedByHand = 0.1;              // [rad]
// Smallest difference of force that a hand tells: Pang, Tan and Durlach, Perception & Psychophysics 49 (1991).
constexpr double kNoticed = 0.07;  // [1]

/// The options, where the stiffness and the damping that a device can render replace zeros.
PassivityOptions rendered_by(PassivityOptions options, double stiffness, double damping) {
  if (options.stiffness == 0) options.stiffness = stiffness;
  if (options.max_damping == 0) options.max_damping = damping;
  return options;
}

/// [m] The lever that converts torques and rotations to forces and distances; 0: only forces are watched.
double lever_of(double stiffness, const DeviceCapabilities& device, double max_force, double max_torque) {
  if (device.output_degrees_of_freedom < 6 || max_torque <= 0 || max_force <= 0) return 0;
  const bool known = stiffness > 0 && device.rotational_stiffness > 0;
  return known ? std::sqrt(device.rotational_stiffness / stiffness) : max_torque / max_force;
}

double or_default(double value, double fallback) { return value > 0 ? value : fallback; }

bool is_finite(const Wrench& w) { return w.force.allFinite() && w.torque.allFinite(); }

}  // namespace

SafetyGuard::SafetyGuard(const DeviceCapabilities& capabilities, const GuardOptions& options, Requests* requests)
    : capabilities_(capabilities),
      options_(options),
      max_force_(std::min(or_default(options.max_force, capabilities.peak_force), capabilities.peak_force)),
      max_torque_(std::min(or_default(options.max_torque, capabilities.peak_torque), capabilities.peak_torque)),
      slew_(0),
      torque_slew_(0),
      ramp_damping_(options.ramp_damping < 0 ? kRampDampingShare * capabilities.damping : options.ramp_damping),
      gate_(capabilities, options.gate),
      arming_(options.arming),
      passivity_(
          rendered_by(options.passivity, or_default(options.stiffness, capabilities.stiffness), capabilities.damping),
          max_force_,
          lever_of(or_default(options.stiffness, capabilities.stiffness), capabilities, max_force_, max_torque_),
          max_torque_),
      watchdog_(options.watchdog, options.period),
      clock_(options.period, options.pause),
      thermal_(max_force_, capabilities.continuous_force, options.thermal),
      requests_(requests != nullptr ? requests : &own_requests_) {
  require_fields_within(options, "GuardOptions::");
  require_between(options.pause, options.late, 10, "GuardOptions::pause [s]");
  if (capabilities.output_degrees_of_freedom < 3) max_force_ = 0;
  if (capabilities.output_degrees_of_freedom < 6) max_torque_ = 0;

  const double stiffness = or_default(options.stiffness, capabilities.stiffness);
  const double needed = min_force_growth(stiffness, options.max_contact_speed);
  slew_ = or_default(options.slew, default_force_growth(stiffness, options.max_contact_speed, max_force_));
  if (slew_ < needed)
    throw Error(
        "GuardOptions::slew"_name + " [N/s] = " + format_number(slew_, needed) +
        "; must be >= " + format_number(needed, slew_) +
        " = 1.25 x stiffness x max_contact_speed, or a wall of that stiffness gains energy; raise it or lower " +
        "GuardOptions::stiffness"_name + ".");
  torque_slew_ =
      or_default(options.torque_slew, max_force_ > 0 ? slew_ * max_torque_ / max_force_ : max_torque_ / 10e-3);
}

void SafetyGuard::start() noexcept {
  started_ = false;
  clock_.restart();
  worst_silence_.store(Watchdog::Verdict::alive, std::memory_order_release);
  gate_.restart();
  passivity_.restart();
  not_finite_ = 0;
  before_ramp_ = {};
  output_ = {};
  watched_ = 0;
  arming_.start(log_);
  published_state_.store(arming_.state(), std::memory_order_release);
}

void SafetyGuard::stop() noexcept {
  arming_.stop();
  published_state_.store(arming_.state(), std::memory_order_release);
}

void SafetyGuard::report_silence(Watchdog::Verdict verdict, double scale) {
  if (std::exchange(silence_, verdict) == verdict) return;
  switch (verdict) {
    case Watchdog::Verdict::alive:
      break;
    case Watchdog::Verdict::late:
      if (is_often_late()) log_.note(SafetyEvent::watchdog_late, scale);
      break;
    case Watchdog::Verdict::fading:
      log_.note(SafetyEvent::watchdog_fading, scale);
      break;
    case Watchdog::Verdict::dead:
      log_.note(SafetyEvent::watchdog_fault, scale);
      break;
  }
  note_silence(verdict);
}

// Whether the loop was late three times before within the last second.
bool SafetyGuard::is_often_late() noexcept {
  const std::uint64_t beat = heartbeat_.load(std::memory_order_acquire);
  const std::uint64_t before = std::exchange(late_beats_[0], late_beats_[1]);
  late_beats_[1] = std::exchange(late_beats_[2], beat);
  return before > 0 && before <= beat && double(beat - before) * options_.period <= 1;
}

void SafetyGuard::note_silence(Watchdog::Verdict verdict) noexcept {
  Watchdog::Verdict worst = worst_silence_.load(std::memory_order_relaxed);
  while (worst < verdict && !worst_silence_.compare_exchange_weak(worst, verdict, std::memory_order_acq_rel)) {
  }
}

// Stage 0: time stamps, missed ticks.
void SafetyGuard::keep_time(const DeviceState& reading) noexcept {
  // The clock of a device that is slower than the loop may stand between its readings, while ticks go on.
  const bool repeats = started_ && reading.sequence == gate_.state().sequence && reading.time <= last_time_;
  last_time_ = reading.time;
  elapsed_ = clock_.tick(reading.time, repeats, std::exchange(waited_, std::numeric_limits<double>::infinity()));
  const Watchdog::Verdict silence = worst_silence_.exchange(Watchdog::Verdict::alive, std::memory_order_acq_rel);
  if (!started_) return;
  if (silence == Watchdog::Verdict::dead && options_.watchdog.latch) arming_.fail(log_);
  if (elapsed_.late > options_.pause || silence == Watchdog::Verdict::dead) {
    arming_.interrupt(SafetyEvent::paused, false, log_, std::max(elapsed_.late, 0.0));
    gate_.restart();  // the hand may be anywhere now
  } else if (elapsed_.late > options_.late || silence == Watchdog::Verdict::fading) {
    arming_.interrupt(SafetyEvent::late_wake_up, true, log_, std::max(elapsed_.late, 0.0));
  }
}

void SafetyGuard::watch_pace(bool good) noexcept {
  if (good) clock_.count_good();
  const std::optional<TickClock::Pace> pace = clock_.pace();
  if (!pace) return;
  const double ticks = pace->period / options_.period;
  const auto report_once = [&](SafetyEvent event, double value) {
    if (log_.count(event) == 0) log_.report(event, value);
  };
  if (ticks < kFastPace || ticks > kSlowPace) report_once(SafetyEvent::other_period, pace->period);
  if (pace->rate * pace->period < kSlowDevice) report_once(SafetyEvent::slow_readings, pace->rate);
}

// Applies the requests of other threads since the last tick.
void SafetyGuard::apply_requests() noexcept {
  // An emergency stop that is reset within the same tick still ends in the fault state first.
  if (requests_->reset_wanted() && requests_->emergency() && arming_.state() != ArmingState::fault) fail_in_emergency();
  if (requests_->accept_reset() && arming_.state() == ArmingState::fault) {
    gate_.restart();
    not_finite_ = 0;
    arming_.reset(log_);
  }
  if (const std::optional<SafetyEvent> reason = requests_->accept_interruption())
    arming_.interrupt(*reason, true, log_);
}

void SafetyGuard::fail_in_emergency() noexcept {
  log_.report(SafetyEvent::emergency_stop);
  arming_.fail(log_);
}

// Positions in millimetres are outside any workspace. Positions in kilometres seem not to move, although the hand
// rotates the stylus.
void SafetyGuard::watch_units(const DeviceState& reading) noexcept {
  const Vec3& p = reading.X_BS.translation;
  if (!is_finite(reading.X_BS)) return;
  if (p.norm() > kImplausiblyFar) log_.report(SafetyEvent::pose_units, p.norm());
  if (watched_ == 0) {
    low_seen_ = high_seen_ = p;
    R_BS_seen_ = reading.X_BS.rotation;
    rotated_ = 0;
  }
  low_seen_ = low_seen_.cwiseMin(p);
  high_seen_ = high_seen_.cwiseMax(p);
  rotated_ = std::max(rotated_, vector_from_rotation(reading.X_BS.rotation * R_BS_seen_.transpose()).norm());
  watched_ += elapsed_.for_speeds;
  if (watched_ < kUnitsWatched) return;
  const double spread = (high_seen_ - low_seen_).norm();
  if (rotated_ > kRotatedByHand && spread > kExactRest && spread < kImplausiblySmall)
    log_.report(SafetyEvent::pose_units, spread);
  watched_ = 0;
}

const DeviceState& SafetyGuard::admit(const DeviceState& reading) noexcept {
  log_.begin_tick(reading.time, reading.sequence);
  keep_time(reading);
  apply_requests();
  watch_units(reading);

  const std::uint32_t epoch = gate_.state().epoch;
  const PoseGate::Verdict verdict = gate_.check(reading, elapsed_.for_poses, log_);
  const DeviceState& state = gate_.state();
  reading_ = verdict == PoseGate::Verdict::accepted   ? Reading::good
             : verdict == PoseGate::Verdict::repeated ? Reading::repeated
                                                      : Reading::bad;
  watch_pace(reading_ == Reading::good);
  if (started_ && reading_ == Reading::good && state.epoch != epoch) {
    arming_.interrupt(SafetyEvent::recalibrated, false, log_);
    X_BS_last_ = state.X_BS;  // the distance between two calibrations is not a motion
  }
  if (verdict == PoseGate::Verdict::lost && arming_.state() > ArmingState::armed) arming_.fail(log_);
  switch (state.fault) {
    case DeviceFault::none:
      break;
    case DeviceFault::motors_warm:
      log_.report(SafetyEvent::motors_warm, state.temperature);
      break;
    case DeviceFault::force_limit:
    case DeviceFault::speed_limit:
    case DeviceFault::overloaded:    // the driver fades its output in again, and so does the guard
    case DeviceFault::switched_off:  // the motors may come back at any moment, at full strength
      log_.report(SafetyEvent::device_fault, double(state.fault));
      arming_.interrupt(SafetyEvent::device_fault, true, log_, double(state.fault));
      break;
    case DeviceFault::disconnected:
    case DeviceFault::uncalibrated:
    case DeviceFault::driver_error:
      log_.report(SafetyEvent::device_fault, double(state.fault));
      if (arming_.state() > ArmingState::armed) arming_.fail(log_, double(state.fault));
      reading_ = Reading::bad;
      break;
  }
  if (!started_) X_BS_last_ = state.X_BS;
  started_ = true;
  motion_ = state.X_BS.translation - X_BS_last_.translation;
  rotation_ = vector_from_rotation(state.X_BS.rotation * X_BS_last_.rotation.transpose());
  X_BS_last_ = state.X_BS;
  published_state_.store(arming_.state(), std::memory_order_release);
  return state;
}

Wrench SafetyGuard::finite_or_none(const Wrench& commanded) noexcept {
  if (is_finite(commanded)) {
    not_finite_ = 0;
    return commanded;
  }
  output_.changes |= OutputChange::not_finite;
  log_.report(SafetyEvent::force_not_finite);
  if (++not_finite_ >= options_.not_finite_ticks) arming_.fail(log_);
  return {};
}

Wrench SafetyGuard::make_passive(const Wrench& wrench, const ModelContact& contact) noexcept {
  const Wrench effects = is_finite(contact.effects) ? contact.effects : Wrench{};
  // If torque is rendered, the force may return the energy of a rotation, so the force is not reduced.
  const bool reduces = max_torque_ == 0 && std::isfinite(contact.motor.value_or(0));
  const std::optional<double> motor = reduces ? contact.motor : std::nullopt;
  Wrench damped = passivity_.control({wrench, effects, output_.applied, motion_, rotation_, elapsed_.for_speeds,
                                      contact.stored, motor, !contact.touching.value_or(true)});
  if (passivity_.damping_force() > kNoticed * wrench.force.norm()) {
    output_.changes |= OutputChange::damped;
    if (contact.touching.value_or(true)) log_.report(SafetyEvent::passivity, passivity_.damping_force());
  }
  return damped;
}

// Saturation, thermal budget, growth.
Wrench SafetyGuard::bound(const Wrench& wrench) noexcept {
  const double force = wrench.force.norm(), torque = wrench.torque.norm();
  if (force > max_force_ || torque > max_torque_) {
    const bool no_motors = (force > 0 && max_force_ == 0) || (torque > 0 && max_torque_ == 0);
    if (no_motors) output_.changes |= OutputChange::no_actuator;
    if (force > max_force_ && max_force_ > 0) {
      output_.changes |= OutputChange::saturated;
      log_.report(SafetyEvent::saturated, force);
    } else if (torque > max_torque_ && max_torque_ > 0) {
      output_.changes |= OutputChange::saturated;
      log_.report(SafetyEvent::saturated, torque);
    }
  }
  Wrench w{saturated(wrench.force, max_force_), saturated(wrench.torque, max_torque_)};
  if (w.force.norm() > thermal_.limit()) {
    w.force = saturated(w.force, thermal_.limit());
    output_.changes |= OutputChange::cooled;
    log_.report(SafetyEvent::continuous_limited, thermal_.limit());
  }
  const double growth_time = std::min(elapsed_.for_speeds, options_.period);  // a late tick may not take a larger step
  Wrench grown{growth_limited(before_ramp_.force, w.force, slew_ * growth_time),
               growth_limited(before_ramp_.torque, w.torque, torque_slew_ * growth_time)};
  // A rounding error does not count as a limit.
  if ((grown.force - w.force).norm() > 1e-9 * force || (grown.torque - w.torque).norm() > 1e-9 * torque) {
    output_.changes |= OutputChange::slew_limited;
    log_.report(SafetyEvent::slew_limited, (grown.force - w.force).norm());
  }
  return grown;
}

Wrench SafetyGuard::limit(const Wrench& commanded, const ModelContact& contact) noexcept {
  output_.commanded = commanded;
  output_.changes = OutputChange::none;
  const Wrench finite = finite_or_none(commanded);
  if (requests_->emergency()) fail_in_emergency();
  const double ramp =
      arming_.tick(elapsed_.for_ramps, reading_, finite.force.norm(), finite.torque.norm(), contact.touching, log_);
  Wrench wrench;
  if (ramp > 0) {
    before_ramp_ = bound(make_passive(finite, contact));
    wrench = {ramp * before_ramp_.force, ramp * before_ramp_.torque};
    if (ramp < 1) {
      output_.changes |= OutputChange::ramped;
      const Vec3 speed = motion_ / elapsed_.for_speeds;
      const double growth_time = std::min(elapsed_.for_speeds, options_.period);
      wrench.force = saturated(wrench.force - (1 - ramp) * ramp_damping_ * speed, max_force_);
      wrench.force = growth_limited(output_.applied.force, wrench.force, slew_ * growth_time);
    }
    if (!is_finite(wrench)) wrench = {};
  } else {
    output_.changes |= OutputChange::held_back;
    before_ramp_ = {};
    passivity_.restart();
  }
  thermal_.tick(wrench.force.norm(), gate_.state().temperature, elapsed_.for_speeds);
  output_.applied = wrench;
  published_state_.store(arming_.state(), std::memory_order_release);
  keep_alive();
  return wrench;
}

void SafetyGuard::report_applied(const Wrench& wrench) noexcept {
  if (!is_finite(wrench)) return;
  if (wrench.force != output_.applied.force || wrench.torque != output_.applied.torque)
    output_.changes |= OutputChange::by_driver;
  output_.applied = wrench;
}

void SafetyGuard::report_exception() noexcept {
  log_.report(SafetyEvent::exception);
  arming_.fail(log_);
  published_state_.store(arming_.state(), std::memory_order_release);
}

}  // namespace hapticut
