// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// Whether a force is allowed.
enum class ArmingState : std::uint8_t {
  off,        ///< before and after a run: no force
  armed,      ///< the run has begun; waiting for valid readings: no force
  wait_free,  ///< waiting until the tool touches nothing: no force
  ramp,       ///< the force is faded in
  on,         ///< the full force
  fault,      ///< latched until reset: no force
};

constexpr auto names_of(Of<ArmingState>) {
  using enum ArmingState;
  return std::array{
      Named{off, "off",
            "No hand leads the tool, so there is no force: move the tool, or reload this page if it only watches."},
      Named{armed, "armed", "The guard waits for the first readings of the hand: if this lasts, check the device."},
      Named{wait_free, "wait_free", "No force until the tool touches nothing: lift it off the workpiece."},
      Named{ramp, "ramp", "The force is being faded in: wait a moment."},
      Named{on, "on", "The force is on."},
      Named{fault, "fault", "Stopped without force: reset the fault when the hand is ready."},
  };
}

[[nodiscard]] const char* name_of(ArmingState state);

/// When a force is allowed, and how it begins.
struct ArmingOptions {
  /// [ticks] accepted readings, at least a third of all, after which the device counts as ready
  int valid_ticks = 10;
  /// [N] force below which the tool counts as free, if the model does not report whether it touches anything
  double free_force = 0.2;
  double free_torque = 0.02;  ///< [N m] torque below which the tool counts as free, under the same condition
  int free_ticks = 4;         ///< [ticks] ticks in a row for which the tool must be free
  double ramp = 1.5;          ///< [s] duration of the fade-in of the first force
  /// [s] duration of the fade-in after a late tick, a clutch or another announced interruption
  double short_ramp = 0.25;
};

constexpr auto fields_of(Of<ArmingOptions>) {
  using O = ArmingOptions;
  return std::tuple{
      field("valid_ticks", &O::valid_ticks, "ticks", Range::between(1, 10000),
            "accepted readings, at least a third of all, after which the device counts as ready"),
      field("free_force", &O::free_force, "N", Range::positive(),
            "force below which the tool counts as free, if the model does not report whether it touches anything"),
      field("free_torque", &O::free_torque, "N m", Range::positive(),
            "torque below which the tool counts as free, under the same condition"),
      field("free_ticks", &O::free_ticks, "ticks", Range::between(1, 10000),
            "ticks in a row for which the tool must be free"),
      field("ramp", &O::ramp, "s", Range::between(0.02, 60), "duration of the fade-in of the first force"),
      field("short_ramp", &O::short_ramp, "s", Range::between(0.02, 60),
            "duration of the fade-in after a late tick, a clutch or another announced interruption"),
  };
}

/// What the gate says about the reading of a tick.
enum class Reading : std::uint8_t {
  bad,       ///< it was not accepted
  repeated,  ///< the device has no newer one; the last one is held
  good,
};

/// The state machine that decides whether the hand may feel a force: off, armed, wait until free, fade in, on, fault.
///
/// If the tool is inside the material at the start or after an interruption, there is no force until the tool has been
/// free. Otherwise the model would push the hand out abruptly.
/// @realtime no allocation, no lock
class Arming {
 public:
  /// @throws Error when an option is out of range
  explicit Arming(const ArmingOptions& options);

  void start(SafetyLog& log) noexcept;
  void stop() noexcept { state_ = ArmingState::off; }

  /// Returns to `wait_free`. Changes nothing in the states `off`, `armed` and `fault`.
  void interrupt(SafetyEvent reason, bool short_ramp, SafetyLog& log, double value = 0) noexcept;

  void fail(SafetyLog& log, double value = 0) noexcept;

  /// Leaves `fault`.
  void reset(SafetyLog& log) noexcept;

  /// Advances the state machine by one tick.
  /// @param dt           [s] since the last tick
  /// @param reading      repeated ones do not count
  /// @param force        [N] commanded by the model
  /// @param torque       [N·m] commanded by the model
  /// @param touching     whether the tool touches anything; empty: force and torque decide
  /// @return [1] the fraction of the force that is allowed
  double tick(double dt, Reading reading, double force, double torque, std::optional<bool> touching,
              SafetyLog& log) noexcept;

  [[nodiscard]] ArmingState state() const { return state_; }

 private:
  void wait_free(SafetyLog& log) noexcept;

  ArmingOptions options_;
  ArmingState state_ = ArmingState::off;
  int ticks_ = 0;           // that fulfil what the state waits for
  int bad_ = 0;             // readings that were not accepted while `armed`
  bool inspected_ = false;  // whether the first force since the wait began was inspected
  bool first_ = true;       // there was no force since the start or since a fault
  bool short_ramp_ = false;
  double progress_ = 0;  // [1] progress of the fade-in
};

}  // namespace hapticut
