// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// Whether a force is allowed.
enum class ArmingState : std::uint8_t {
  off,        ///< before the run and after it: no force
  armed,      ///< the run has begun; waiting for valid readings: no force
  wait_free,  ///< waiting until the model asks for no force, that is until the tool touches nothing: no force
  ramp,       ///< the force is faded in
  on,         ///< the full force
  fault,      ///< latched until reset: no force
};

constexpr auto names_of(Of<ArmingState>) {
  using enum ArmingState;
  return std::array{
      Named{off, "off"},   Named{armed, "armed"}, Named{wait_free, "wait_free"},
      Named{ramp, "ramp"}, Named{on, "on"},       Named{fault, "fault"},
  };
}

[[nodiscard]] const char* name_of(ArmingState state);

/// When a force is allowed, and how it begins.
struct ArmingOptions {
  int valid_ticks = 10;       ///< [ticks] of accepted readings in a row before the device counts as ready
  double free_force = 0.2;    ///< [N] below which the tool counts as free
  double free_torque = 0.02;  ///< [N·m]
  int free_ticks = 4;         ///< [ticks] in a row that the tool must be free
  double ramp = 1.5;          ///< [s] over which the first force is faded in
  double short_ramp = 0.25;   ///< [s] after a late tick, a clutch or another interruption that was announced
};

/// The state machine that decides whether the hand may feel a force: off, armed, wait until free, fade in, on, fault.
///
/// A tool that begins inside the material, and one that is found there after an interruption, gets no force until it
/// has been free: otherwise the model would throw the hand out.
/// @realtime no allocation, no lock
class Arming {
 public:
  /// @throws Error when an option is out of range
  explicit Arming(const ArmingOptions& options);

  void start(SafetyLog& log) noexcept;
  void stop() noexcept { state_ = ArmingState::off; }

  /// Back to waiting until the tool is free; nothing changes in `off`, `armed` and `fault`.
  void interrupt(SafetyEvent reason, bool short_ramp, SafetyLog& log, double value = 0) noexcept;

  void fail(SafetyLog& log, double value = 0) noexcept;

  /// Leaves `fault`.
  void reset(SafetyLog& log) noexcept;

  /// One tick.
  /// @param dt           [s] since the last
  /// @param reading_ok   the gate accepted the reading
  /// @param force        [N] that the model asks for
  /// @param torque       [N·m] that the model asks for
  /// @return [1] the share of the force that is allowed
  double tick(double dt, bool reading_ok, double force, double torque, SafetyLog& log) noexcept;

  [[nodiscard]] ArmingState state() const { return state_; }

 private:
  void wait_free(SafetyLog& log) noexcept;

  ArmingOptions options_;
  ArmingState state_ = ArmingState::off;
  int ticks_ = 0;        // in a row, of what the state waits for
  bool looked_ = false;  // at the first force since the wait began
  bool first_ = true;    // no force since the start or since a fault
  bool short_ramp_ = false;
  double progress_ = 0;  // [1] of the ramp
};

}  // namespace hapticut
