// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "hapticut/core/spatial.hpp"

/// @file
/// What a haptic device is and what it says, in SI units.
///
/// Frames: `B` base of the device, `S` stylus. Adapters deliver B with +x to the right, +y up and +z towards the user,
/// and the origin of S at the point whose position the device measures and at which it applies its force.
namespace hapticut {

/// What a device can measure and render. Zero means that it has none or that nobody knows; a reason is in the
/// documentation of the adapter.
struct DeviceCapabilities {
  std::string model;           ///< as the driver spells it
  std::string vendor;          ///< as the driver spells it
  std::string serial_number;   ///< as the driver spells it
  std::string driver_version;  ///< as the driver spells it

  int input_degrees_of_freedom = 6;   ///< 3: position, 6: position and orientation
  int output_degrees_of_freedom = 0;  ///< 0: no force, 3: force, 6: force and torque

  double peak_force = 0;            ///< [N]
  double continuous_force = 0;      ///< [N] that the motors bear for ever
  double peak_torque = 0;           ///< [N·m]
  double continuous_torque = 0;     ///< [N·m]
  double stiffness = 0;             ///< [N/m] greatest that the maker promises to be stable
  double rotational_stiffness = 0;  ///< [N·m/rad]
  double damping = 0;               ///< [N·s/m] greatest that the maker promises to be stable
  double position_resolution = 0;   ///< [m]

  Vec3 workspace_low = Vec3::Zero();   ///< [m] corner of the largest box the stylus can reach, in B
  Vec3 workspace_high = Vec3::Zero();  ///< [m] the opposite corner; equal to workspace_low when unknown

  double rate = 1000;         ///< [Hz] of its servo loop
  bool hard_realtime = true;  ///< false where the transport gives no promise (TCP, a window toolkit)
};

/// Why a device cannot be trusted, or cannot be driven, right now.
enum class DeviceFault : std::uint8_t {
  none,
  disconnected,  ///< it stopped answering: cable, power, permission. Ends the run
  uncalibrated,  ///< its position means nothing until it is calibrated or docked. No force
  motors_warm,   ///< the motors are too hot. The driver reduces or stops the force until they cool
  force_limit,   ///< the driver refused a force or its change as too large, and restarts its output gently
  speed_limit,   ///< the driver saw a motion that is too fast, and restarts its output gently
  overloaded,    ///< the servo loop took longer than its period
  driver_error,  ///< the driver refused a call that it should not refuse. Ends the run
  switched_off,  ///< somebody switched the motors off: a button or dead man's switch of the device, another program
};

/// A fault in words, and what to do about it.
[[nodiscard]] std::string describe(DeviceFault fault);

/// One reading of a device.
struct DeviceState {
  Pose X_BS;                   ///< pose of the stylus in the base
  Twist velocity;              ///< of the stylus point, in B; an estimate, smoothed and therefore late
  std::uint32_t buttons = 0;   ///< bit n: button n is pressed
  double time = 0;             ///< [s] of the reading, from the device's own clock, since the run began
  std::uint64_t sequence = 0;  ///< grows by one with every new reading; the same number twice is the same reading
  std::uint32_t epoch = 0;     ///< changes when poses before and after do not compare: calibration, reconnection
  double temperature = 0;      ///< [1] of the hottest motor, 0 cold ... 1 too hot; 0 when not measured
  bool valid = true;           ///< false: the pose means nothing
  DeviceFault fault = DeviceFault::none;

  [[nodiscard]] bool pressed(int button) const { return ((buttons >> unsigned(button)) & 1U) != 0; }
};

/// What the user's code wants of the device until its next call.
struct DeviceCommand {
  Wrench wrench;      ///< [N], [N·m] on the stylus, torque about the stylus point, in B
  bool stop = false;  ///< end the run after this tick
};

/// What was done to a commanded wrench before it reached the motors, as bits.
enum class OutputLimit : std::uint32_t {
  none = 0,
  held_back = 1U << 0,     ///< not yet armed, or in the fault state: no force
  ramped = 1U << 1,        ///< the force is being faded in
  saturated = 1U << 2,     ///< longer than the device's peak, shortened without turning it
  slew_limited = 1U << 3,  ///< grew faster than allowed
  cooled = 1U << 4,        ///< shortened to let the motors cool
  damped = 1U << 5,        ///< the passivity controller took energy out
  not_finite = 1U << 6,    ///< the commanded wrench was not finite
  no_actuator = 1U << 7,   ///< the device has no motors for the torque, or for any of it
  by_driver = 1U << 8,     ///< the driver applied something else than it was given
};

[[nodiscard]] constexpr OutputLimit operator|(OutputLimit a, OutputLimit b) {
  return OutputLimit(std::uint32_t(a) | std::uint32_t(b));
}
constexpr OutputLimit& operator|=(OutputLimit& a, OutputLimit b) { return a = a | b; }
[[nodiscard]] constexpr bool has(OutputLimit limits, OutputLimit bits) {
  return (std::uint32_t(limits) & std::uint32_t(bits)) != 0;
}

/// The limits in words, separated by commas; "none" for none.
[[nodiscard]] std::string describe(OutputLimit limits);

/// The two sides of the last tick's output.
struct DeviceOutput {
  Wrench commanded;                        ///< what the user's code asked for
  Wrench applied;                          ///< what the motors got
  OutputLimit limits = OutputLimit::none;  ///< why they differ
};

}  // namespace hapticut
