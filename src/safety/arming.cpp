// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/arming.hpp"

#include <algorithm>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr int kMaxBadPerGood = 2;  // readings of a device that is slower than the loop

}  // namespace

const char* name_of(ArmingState state) {
  const char* known = name_or_null(state);
  return known != nullptr ? known : "unknown";
}

Arming::Arming(const ArmingOptions& options) : options_(options) { require_fields_within(options, "ArmingOptions::"); }

void Arming::start(SafetyLog& log) noexcept {
  state_ = ArmingState::armed;
  ticks_ = bad_ = 0;
  first_ = true;
  log.report(SafetyEvent::armed);
}

void Arming::wait_free(SafetyLog& log) noexcept {
  state_ = ArmingState::wait_free;
  ticks_ = 0;
  inspected_ = false;
  log.report(SafetyEvent::waiting_free);
}

void Arming::interrupt(SafetyEvent reason, bool short_ramp, SafetyLog& log, double value) noexcept {
  log.report(reason, value);
  const bool interruptible =
      state_ == ArmingState::wait_free || state_ == ArmingState::ramp || state_ == ArmingState::on;
  if (!interruptible) return;
  // A pending or running long fade-in stays long.
  if (state_ == ArmingState::on)
    short_ramp_ = short_ramp;
  else
    short_ramp_ = short_ramp_ && short_ramp;
  wait_free(log);
}

void Arming::fail(SafetyLog& log, double value) noexcept {
  if (state_ == ArmingState::off || state_ == ArmingState::fault) return;
  state_ = ArmingState::fault;
  log.report(SafetyEvent::fault, value);
}

void Arming::reset(SafetyLog& log) noexcept {
  if (state_ != ArmingState::fault) return;
  log.report(SafetyEvent::fault_reset);
  start(log);
}

double Arming::tick(double dt, Reading reading, double force, double torque, std::optional<bool> touching,
                    SafetyLog& log) noexcept {
  const bool is_good = reading == Reading::good;
  switch (state_) {
    case ArmingState::off:
    case ArmingState::fault:
      return 0;

    case ArmingState::armed:
      if (reading == Reading::repeated) return 0;
      ++(is_good ? ticks_ : bad_);
      if (bad_ > kMaxBadPerGood * (ticks_ + 1)) ticks_ = bad_ = 0;
      if (ticks_ >= options_.valid_ticks) {
        short_ramp_ = !first_;
        wait_free(log);
      }
      return 0;

    case ArmingState::wait_free: {
      if (!is_good) return 0;  // the last good pose is held
      const bool is_quiet = force < options_.free_force && torque < options_.free_torque;
      const bool is_free = touching ? !*touching : is_quiet;
      if (!inspected_) {
        inspected_ = true;
        if (!is_free) log.report(SafetyEvent::start_inside, force);
      }
      ticks_ = is_free ? ticks_ + 1 : 0;
      if (ticks_ >= options_.free_ticks) {
        state_ = ArmingState::ramp;
        progress_ = 0;
        log.report(SafetyEvent::fading_in);
      }
      return 0;
    }

    case ArmingState::ramp: {
      progress_ += dt / (short_ramp_ ? options_.short_ramp : options_.ramp);
      if (progress_ >= 1) {
        state_ = ArmingState::on;
        first_ = false;
        log.report(SafetyEvent::engaged);
        return 1;
      }
      return progress_ * progress_ * (3 - 2 * progress_);  // smoothstep: begins and ends gently
    }

    case ArmingState::on:
      return 1;
  }
  return 0;
}

}  // namespace hapticut
