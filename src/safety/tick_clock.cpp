// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/tick_clock.hpp"

#include <algorithm>
#include <cmath>

namespace hapticut {
namespace {

constexpr double kMinStep = 0.2;       // [periods]
constexpr double kMaxLateness = 5e-3;  // [s]
constexpr double kMaxAhead = 20e-3;    // [s] lead of the clock over readings that stand, as long as the gate holds one
constexpr int kPaceTicks = 1000, kFewestTicks = 20;
constexpr double kPaceTime = 1;  // [s]

}  // namespace

void TickClock::restart() noexcept { *this = TickClock(period_, pause_); }

TickClock::Elapsed TickClock::tick(double time, bool repeats, double waited) noexcept {
  const bool known = std::isfinite(time), first = !started_;
  const bool starts = first || time < clock_ - kMaxAhead;  // also the clock of a device that was opened again
  const double step = std::min(period_, waited);           // duration of a tick whose reading tells no time
  double elapsed = step, passed = step;                    // by the readings; by the clock
  if (known && starts) {
    clock_ = time;
    started_ = true;
  } else if (known) {
    const double before = clock_;
    if (!repeats) elapsed = time - clock_;
    clock_ = repeats ? std::min(clock_ + step, time + kMaxAhead) : std::max(clock_, time);
    passed = std::clamp(clock_ - before, 0.0, waited);
  }
  if (!first) {
    ++ticks_;
    watched_ += std::min(passed, period_ + pause_);
  }
  const double max_dt = period_ + kMaxLateness, for_speeds = std::clamp(elapsed, kMinStep * period_, max_dt);
  const double for_poses = repeats ? elapsed : std::clamp(elapsed, for_speeds, std::max(for_speeds, pause_ + period_));
  return {for_speeds, std::min(passed, max_dt), for_poses, elapsed - period_};
}

std::optional<TickClock::Pace> TickClock::pace() noexcept {
  const bool ends = ticks_ >= kPaceTicks || (watched_ >= kPaceTime && ticks_ >= kFewestTicks);
  if (!ends) return {};
  const Pace pace{watched_ / ticks_, watched_ > 0 ? good_ / watched_ : 0};
  ticks_ = good_ = 0;
  watched_ = 0;
  return pace;
}

}  // namespace hapticut
