// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/faults.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/interruption.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/effects/output_limits.hpp"

namespace hapticut {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMaxForceAge = 0.05;     // [s]
constexpr double kWatched = 0.5;          // [s] after the fault
constexpr double kSettled = 3;            // [s] before it: armed, faded in, in contact
constexpr double kPress = 4e-3;           // [m] target of the hand below the surface
constexpr double kStroke = 8e-3;          // [m] sideways
constexpr double kStrokeFrequency = 2.3;  // [Hz]; fast enough to contradict a frozen position at every phase but one
constexpr double kOffset = 5e-3;          // [m] shift by clutch and calibration

constexpr auto kFaults = [] {
  constexpr auto kNamed = names_of(Of<InjectedFault>{});
  std::array<InjectedFault, kNamed.size()> faults{};
  for (std::size_t i = 0; i < faults.size(); ++i) faults[i] = kNamed[i].value;
  return faults;
}();

int missed_ticks(InjectedFault fault) {
  switch (fault) {
    case InjectedFault::missed_1:
      return 1;
    case InjectedFault::missed_5:
      return 5;
    case InjectedFault::missed_20:
      return 20;
    case InjectedFault::missed_100:
      return 100;
    default:
      return 0;
  }
}

// The reading with the fault.
DeviceState spoiled(const DeviceState& reading, const DeviceState& at_fault, InjectedFault fault) {
  DeviceState s = reading;
  switch (fault) {
    case InjectedFault::nan_pose:
      s.X_BS.translation.setConstant(kNan);
      break;
    case InjectedFault::frozen_pose:
      s.X_BS.translation = at_fault.X_BS.translation;
      break;
    case InjectedFault::stale_reading:
      s = at_fault;
      s.time = reading.time;
      break;
    case InjectedFault::jump_30mm:
      s.X_BS.translation.z() -= 0.030;
      break;
    case InjectedFault::calibration_jump:
      s.X_BS.translation.z() -= kOffset;
      ++s.epoch;
      break;
    case InjectedFault::units_x1000:
      s.X_BS.translation *= 1000;
      break;
    case InjectedFault::unplugged:
      s = at_fault;
      s.time = reading.time;
      s.valid = false;
      s.fault = DeviceFault::disconnected;
      break;
    default:
      break;
  }
  return s;
}

}  // namespace

std::string_view name_of(InjectedFault fault) { return name_or_null(fault); }
std::span<const InjectedFault> injected_faults() { return kFaults; }

FaultResponse measure_fault_response(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                                     const GuardOptions& options, InjectedFault fault, double height) {
  if (name_or_null(fault) == nullptr)
    throw Error("InjectedFault = " + std::to_string(int(fault)) + "; must be one of " + list_of_names<InjectedFault>() +
                ".");
  require_within(stiffness, Range::any(), "the stiffness");
  require_within(height, range_of(&BounceTest::height), "the height [m]");
  if (options.period != config.period && options.period != GuardOptions{}.period)
    throw Error("GuardOptions::period"_name + " = " + format_number(options.period) + " s is not " +
                "ClosedLoopConfig::period"_name + " = " + format_number(config.period) + " s; set only the latter.");
  ClosedLoop loop(config);
  GuardOptions guard_options = options;
  guard_options.period = config.period;
  DeviceCapabilities device = capabilities(config.device);
  device.simulated = false;  // it stands for a real one
  SafetyGuard guard(device, guard_options);
  const Watchdog watchdog(options.watchdog, config.period);
  const ForceModel model = factory(stiffness);
  const bool buried = fault == InjectedFault::buried_5mm;
  loop.reset(Pose::from_translation({0, 0, height + (buried ? -kOffset : kOffset)}));
  guard.start();

  const double period = config.period;
  const long fault_tick = buried ? 0 : std::lround(kSettled / period);
  const long end = fault_tick + std::lround(kWatched / period);
  const int missed = missed_ticks(fault);
  DeviceState at_fault;
  FaultResponse response;
  Vec3 last = Vec3::Zero();
  double last_good = 0;
  for (long n = 0; n < end; ++n) {
    look_for_interruption();
    // The hand stays above the surface while the force is faded in, then presses and strokes.
    const double t = double(n) * period;
    const double depth = buried || t > kSettled - 0.8 ? kPress : -kOffset;
    const double side = kStroke * std::sin(2 * units::kPi * kStrokeFrequency * t);
    loop.plant().set_target(Pose::from_translation({side, 0, height - depth}));

    const bool faulty = n >= fault_tick;
    const DeviceState reading = loop.read();
    if (n == fault_tick) at_fault = reading;
    if (n == fault_tick && fault == InjectedFault::reclutch) guard.requests().interrupt(SafetyEvent::reclutched);
    if (n == fault_tick && fault == InjectedFault::emergency_stop) guard.requests().emergency_stop();
    if (faulty && n < fault_tick + missed) {
      const double silent = double(n - fault_tick + 1) * period;
      guard.report_silence(watchdog.verdict(silent), watchdog.scale(silent));
      loop.miss_tick(watchdog.scale(silent));
    } else {
      const DeviceState& admitted = guard.admit(faulty ? spoiled(reading, at_fault, fault) : reading);
      DeviceState seen = admitted;
      if (faulty && fault == InjectedFault::reclutch) seen.X_BS.translation.z() -= kOffset;
      Wrench wrench = admitted.valid ? model(seen) : Wrench{};
      if (faulty && fault == InjectedFault::nan_force) wrench.force.x() = kNan;
      if (faulty && fault == InjectedFault::force_x1000) wrench.force *= 1000;
      loop.write(guard.limit(wrench));
      const bool blind = fault == InjectedFault::nan_pose || fault == InjectedFault::frozen_pose ||
                         fault == InjectedFault::stale_reading || fault == InjectedFault::jump_30mm ||
                         fault == InjectedFault::units_x1000 || fault == InjectedFault::unplugged;
      if (!faulty || !blind) last_good = t;
    }
    const Vec3 force = loop.applied().force;
    if (faulty) {
      const double since = double(n - fault_tick) * period;
      response.max_force = std::max(response.max_force, force.norm());
      const Vec3 shrunken = growth_limited(last, force, 0);
      response.max_growth = std::max(response.max_growth, (force - shrunken).norm());
      if (force.isZero(0)) {
        if (response.time_to_zero < 0) response.time_to_zero = since;
      } else {
        response.oldest_force = std::max(response.oldest_force, t - last_good);
      }
    }
    last = force;
  }
  response.end = guard.state();
  return response;
}

bool obeys_the_rules(const FaultResponse& response, const SafetyGuard& guard, double period) {
  require_positive(period, "the period [s]");
  constexpr double kRounding = 1e-9;  // [1]
  return response.max_force <= guard.max_force() * (1 + kRounding) &&
         response.max_growth <= guard.slew() * period * (1 + kRounding) &&
         response.oldest_force <= kMaxForceAge + kRounding;
}

}  // namespace hapticut
