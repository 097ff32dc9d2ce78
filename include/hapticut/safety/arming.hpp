// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// Whether a force is allowed.
enum class ArmingState : std::uint8_t {
  off,        ///< before the run and after it: no force
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
            "Nobody leads, so the loop stands without force: move the tool, or reload a page that looks on."},
      Named{armed, "armed", "The guard waits for the first readings of the hand: if it lasts, check the device."},
      Named{wait_free, "wait_free", "No force until the tool touches nothing: lift it off the workpiece."},
      Named{ramp, "ramp", "The force is being faded in: wait a moment."},
      Named{on, "on", "The force is on."},
      Named{fault, "fault", "Stopped without force: reset the fault when the hand is ready."},
  };
}

[[nodiscard]] const char* name_of(ArmingState state);

/// When a force is allowed, and how it begins.
struct ArmingOptions {
  int valid_ticks = 10;
  double free_force = 0.2;
  double free_torque = 0.02;
  int free_ticks = 4;
  double ramp = 1.5;
  double short_ramp = 0.25;
};

constexpr auto fields_of(Of<ArmingOptions>) {
  using O = ArmingOptions;
  return std::tuple{
      field("valid_ticks", &O::valid_ticks, "ticks", Range::between(1, 10000),
            "of accepted readings in a row before the device counts as ready"),
      field("free_force", &O::free_force, "N", Range::positive(),
            "below which the tool counts as free, of a model that does not say whether it touches anything"),
      field("free_torque", &O::free_torque, "N m", Range::positive(), "the same of the torque"),
      field("free_ticks", &O::free_ticks, "ticks", Range::between(1, 10000), "in a row that the tool must be free"),
      field("ramp", &O::ramp, "s", Range::between(0.02, 60), "over which the first force is faded in"),
      field("short_ramp", &O::short_ramp, "s", Range::between(0.02, 60),
            "after a late tick, a clutch or another interruption that was announced"),
  };
}

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
  /// @param touching     whether the tool touches anything; empty: judged by force and torque
  /// @return [1] the share of the force that is allowed
  double tick(double dt, bool reading_ok, double force, double torque, std::optional<bool> touching,
              SafetyLog& log) noexcept;

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
