// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/analysis/stability.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut {

/// Faults between a hand and a model.
enum class InjectedFault : std::uint8_t {
  nan_pose,          ///< readings become not-a-number
  frozen_pose,       ///< the position stops changing while the driver still reports a speed
  stale_reading,     ///< the driver returns its last reading for ever
  jump_30mm,         ///< readings jump 30 mm into the material and stay there
  missed_1,          ///< the model misses 1 tick, while the device holds the last force
  missed_5,          ///< the model misses 5 ticks
  missed_20,         ///< the model misses 20 ticks
  missed_100,        ///< the model misses 100 ticks
  buried_5mm,        ///< the run begins 5 mm inside the material
  reclutch,          ///< the mapping from hand to tool moves the tool 5 mm into the material, and reports it
  calibration_jump,  ///< a calibration moves the readings 5 mm into the material
  units_x1000,       ///< readings come in millimetres
  force_x1000,       ///< the model's force comes in millinewtons
  nan_force,         ///< the model's force becomes not-a-number
  unplugged,         ///< the device stops answering
  emergency_stop,    ///< the emergency stop is pulled
};

constexpr auto names_of(Of<InjectedFault>) {
  using enum InjectedFault;
  return std::array{
      Named{nan_pose, "nan_pose"},
      Named{frozen_pose, "frozen_pose"},
      Named{stale_reading, "stale_reading"},
      Named{jump_30mm, "jump_30mm"},
      Named{missed_1, "missed_1"},
      Named{missed_5, "missed_5"},
      Named{missed_20, "missed_20"},
      Named{missed_100, "missed_100"},
      Named{buried_5mm, "buried_5mm"},
      Named{reclutch, "reclutch"},
      Named{calibration_jump, "calibration_jump"},
      Named{units_x1000, "units_x1000"},
      Named{force_x1000, "force_x1000"},
      Named{nan_force, "nan_force"},
      Named{unplugged, "unplugged"},
      Named{emergency_stop, "emergency_stop"},
  };
}

[[nodiscard]] std::string_view name_of(InjectedFault fault);
[[nodiscard]] std::span<const InjectedFault> injected_faults();

/// What the hand feels after a fault.
struct FaultResponse {
  double time_to_zero = -1;            ///< [s] from the fault to the first tick without force; < 0: the force continued
  double max_force = 0;                ///< [N] from the fault on
  double max_growth = 0;               ///< [N] growth in one tick from the fault on; release does not count
  double oldest_force = 0;             ///< [s] maximum age of the last good reading behind a force
  ArmingState end = ArmingState::off;  ///< state of the guard, 0.5 s after the fault
};

/// Presses into the surface z = `height` while moving sideways, injects the fault, and records for half a second. Guard
/// and watchdog are between the model and the device, as in a run, with the period of the loop.
/// @throws Error when GuardOptions::period is set to another period, the fault has no name, a number is not finite or
///         out of range, or the model returns a wrench that is not finite
[[nodiscard]] FaultResponse measure_fault_response(const ClosedLoopConfig& config, const ModelFactory& factory,
                                                   double stiffness, const GuardOptions& options, InjectedFault fault,
                                                   double height = 0);

/// Whether a response obeys the rules for every fault: never more than the device's peak force, no growth above the
/// slew limit, no force older than 50 ms.
/// @throws Error when the period is not positive
[[nodiscard]] bool obeys_the_rules(const FaultResponse& response, const SafetyGuard& guard, double period);

}  // namespace hapticut
