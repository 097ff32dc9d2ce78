// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"

/// @file
/// Properties, readings and outputs of a haptic device, in SI units.
///
/// Frames: `B` base of the device, `S` stylus. Adapters deliver B with +x to the right, +y up and +z towards the user,
/// and the origin of S at the point whose position the device measures and at which it applies its force.
namespace hapticut {

/// What a device can measure and render. Zero means that the device cannot do it, or that its driver does not report
/// it; the documentation of the adapter says which.
struct DeviceCapabilities {
  std::string model;           ///< name of the model, as the driver spells it
  std::string vendor;          ///< name of the maker, as the driver spells it
  std::string serial_number;   ///< serial number, as the driver spells it
  std::string driver_version;  ///< version of the driver, as the driver spells it

  int input_degrees_of_freedom = 6;   ///< [1] 3: position, 6: position and orientation
  int output_degrees_of_freedom = 0;  ///< [1] 0: no force, 3: force, 6: force and torque

  double peak_force = 0;            ///< [N] largest that the motors can produce
  double continuous_force = 0;      ///< [N] largest that the motors can hold without overheating
  double peak_torque = 0;           ///< [N m] largest that the motors can produce
  double continuous_torque = 0;     ///< [N m] largest that the motors can hold without overheating
  double stiffness = 0;             ///< [N/m] largest that the maker guarantees to be stable
  double rotational_stiffness = 0;  ///< [N m/rad] largest that the maker guarantees to be stable
  double damping = 0;               ///< [N s/m] largest that the maker guarantees to be stable
  double position_resolution = 0;   ///< [m] resolution of the device's sensors

  Vec3 workspace_low = Vec3::Zero();   ///< [m] corner of the largest box the stylus can reach, in B
  Vec3 workspace_high = Vec3::Zero();  ///< [m] the opposite corner; equal to workspace_low when unknown

  double rate = 1000;         ///< [Hz] rate of the device's servo loop
  bool hard_realtime = true;  ///< false if the transport guarantees no timing (TCP, a window toolkit)
  bool simulated = false;     ///< its hand does not tremble, so a position may stand while the stylus rotates
};

constexpr auto fields_of(Of<DeviceCapabilities>) {
  using C = DeviceCapabilities;
  return std::tuple{
      field("model", &C::model, "name of the model, as the driver spells it"),
      field("vendor", &C::vendor, "name of the maker, as the driver spells it"),
      field("serial_number", &C::serial_number, "serial number, as the driver spells it"),
      field("driver_version", &C::driver_version, "version of the driver, as the driver spells it"),
      field("input_degrees_of_freedom", &C::input_degrees_of_freedom, "1", "3: position, 6: position and orientation"),
      field("output_degrees_of_freedom", &C::output_degrees_of_freedom, "1",
            "0: no force, 3: force, 6: force and torque"),
      field("peak_force", &C::peak_force, "N", "largest that the motors can produce"),
      field("continuous_force", &C::continuous_force, "N", "largest that the motors can hold without overheating"),
      field("peak_torque", &C::peak_torque, "N m", "largest that the motors can produce"),
      field("continuous_torque", &C::continuous_torque, "N m", "largest that the motors can hold without overheating"),
      field("stiffness", &C::stiffness, "N/m", "largest that the maker guarantees to be stable"),
      field("rotational_stiffness", &C::rotational_stiffness, "N m/rad",
            "largest that the maker guarantees to be stable"),
      field("damping", &C::damping, "N s/m", "largest that the maker guarantees to be stable"),
      field("position_resolution", &C::position_resolution, "m", "resolution of the device's sensors"),
      field("workspace_low", &C::workspace_low, "m", "corner of the largest box the stylus can reach, in B"),
      field("workspace_high", &C::workspace_high, "m", "the opposite corner; equal to workspace_low when unknown"),
      field("rate", &C::rate, "Hz", "rate of the device's servo loop"),
      field("hard_realtime", &C::hard_realtime, "false if the transport guarantees no timing (TCP, a window toolkit)"),
      field("simulated", &C::simulated, "its hand does not tremble, so a position may stand while the stylus rotates"),
  };
}

/// Why the readings of a device cannot be trusted, or why it cannot be driven, at present.
enum class DeviceFault : std::uint8_t {
  none,
  disconnected,  ///< the device stopped answering: cable, power, permission. Ends the run
  uncalibrated,  ///< the position is meaningless until the device is calibrated or docked. No force
  motors_warm,   ///< the motors are too hot. The driver reduces or stops the force until they cool
  force_limit,   ///< the driver refused a force or its change as too large, and fades its output in again
  speed_limit,   ///< the driver saw a motion that is too fast, and fades its output in again
  overloaded,    ///< the servo loop took longer than its period
  driver_error,  ///< the driver refused a valid call. Ends the run
  switched_off,  ///< the motors were switched off: by a button or dead man's switch of the device, or by another
                 ///< program
};

constexpr auto names_of(Of<DeviceFault>) {
  using enum DeviceFault;
  return std::array{
      Named{none, "none"},
      Named{disconnected, "disconnected"},
      Named{uncalibrated, "uncalibrated"},
      Named{motors_warm, "motors_warm"},
      Named{force_limit, "force_limit"},
      Named{speed_limit, "speed_limit"},
      Named{overloaded, "overloaded"},
      Named{driver_error, "driver_error"},
      Named{switched_off, "switched_off"},
  };
}

/// Describes a fault and what to do about it.
[[nodiscard]] std::string describe(DeviceFault fault);

/// One reading of a device.
struct DeviceState {
  Pose X_BS;  ///< pose of the stylus in the base
  /// Velocity of the stylus point, in B; a smoothed and therefore delayed estimate
  Twist velocity;
  std::uint32_t buttons = 0;  ///< [1] bit n: button n is pressed
  double time = 0;            ///< [s] time of the reading since the run began, by the clock of the device
  /// [1] grows by one with every new reading; an unchanged number means an unchanged reading
  std::uint64_t sequence = 0;
  /// [1] changes when earlier and later poses cannot be compared: calibration, reconnection
  std::uint32_t epoch = 0;
  /// [1] temperature of the hottest motor, 0 cold ... 1 too hot; 0 when not measured
  double temperature = 0;
  bool valid = true;                      ///< false: the pose is meaningless
  DeviceFault fault = DeviceFault::none;  ///< why the reading cannot be trusted, or why the device cannot be driven

  [[nodiscard]] bool pressed(int button) const { return ((buttons >> unsigned(button)) & 1U) != 0; }
};

constexpr auto fields_of(Of<DeviceState>) {
  using S = DeviceState;
  return std::tuple{
      field("X_BS", &S::X_BS, "pose of the stylus in the base"),
      field("velocity", &S::velocity, "velocity of the stylus point, in B; a smoothed and therefore delayed estimate"),
      field("buttons", &S::buttons, "1", "bit n: button n is pressed"),
      field("time", &S::time, "s", "time of the reading since the run began, by the clock of the device"),
      field("sequence", &S::sequence, "1",
            "grows by one with every new reading; an unchanged number means an unchanged reading"),
      field("epoch", &S::epoch, "1",
            "changes when earlier and later poses cannot be compared: calibration, reconnection"),
      field("temperature", &S::temperature, "1",
            "temperature of the hottest motor, 0 cold ... 1 too hot; 0 when not measured"),
      field("valid", &S::valid, "false: the pose is meaningless"),
      field("fault", &S::fault, "why the reading cannot be trusted, or why the device cannot be driven"),
  };
}

/// What the code that computes a force knows about the contact that causes it. The guard uses it; for fields that are
/// empty, the guard judges by the force alone.
struct ModelContact {
  /// Whether the tool touches anything; empty: not known, and a force below ArmingOptions::free_force counts as no
  /// contact
  std::optional<bool> touching;
  /// [N], [N m] the part of the wrench that does not come from contact, such as weight and vibration, in B
  Wrench effects;
  /// [J] energy at the hand that contact and coupling can return; empty: not known, and the guard forgets no energy
  /// while the force lasts
  std::optional<double> stored;
  /// [J] energy at the hand that the tool's motor supplied in this tick; empty: not known. If it is known, so is all
  /// energy that the hand may get, and force that would push the hand beyond that is removed
  std::optional<double> motor = {};
};

constexpr auto fields_of(Of<ModelContact>) {
  using C = ModelContact;
  return std::tuple{
      field("touching", &C::touching,
            "whether the tool touches anything; empty: not known, and a force below ArmingOptions::free_force counts "
            "as no "
            "contact"),
      field("effects", &C::effects,
            "[N], [N m] the part of the wrench that does not come from contact, such as weight and vibration, in B"),
      field(
          "stored", &C::stored, "J",
          "energy at the hand that contact and coupling can return; empty: not known, and the guard forgets no energy "
          "while the force lasts"),
      field("motor", &C::motor, "J",
            "energy at the hand that the tool's motor supplied in this tick; empty: not known. If it is known, so "
            "is all energy that the hand may get, and force that would push the hand beyond that is removed"),
  };
}

/// What the user's code asks of the device until its next call.
struct DeviceCommand {
  Wrench wrench = {};         ///< [N], [N·m] on the stylus, torque about the stylus point, in B
  bool stop = false;          ///< end the run after this tick
  ModelContact contact = {};  ///< contact that causes the wrench
};

/// How a commanded wrench was changed before it reached the motors, as bits.
enum class OutputChange : std::uint32_t {
  none = 0,
  held_back = 1U << 0,     ///< not yet armed, or in the fault state: no force
  ramped = 1U << 1,        ///< the force is being faded in
  saturated = 1U << 2,     ///< above the device's peak; shortened, direction unchanged
  slew_limited = 1U << 3,  ///< growth limited to the allowed rate
  cooled = 1U << 4,        ///< shortened to let the motors cool
  damped = 1U << 5,        ///< changed by the passivity controller, by more than 7 %
  not_finite = 1U << 6,    ///< the commanded wrench was not finite
  no_actuator = 1U << 7,   ///< the device has no motors for the torque, or for any output
  by_driver = 1U << 8,     ///< the driver applied a different wrench
};

constexpr auto names_of(Of<OutputChange>) {
  using enum OutputChange;
  return std::array{
      Named{none, "none"},
      Named{held_back, "held_back", "held back"},
      Named{ramped, "ramped", "faded in"},
      Named{saturated, "saturated"},
      Named{slew_limited, "slew_limited", "growth limited"},
      Named{cooled, "cooled", "reduced to cool the motors"},
      Named{damped, "damped", "damped by the passivity controller"},
      Named{not_finite, "not_finite", "not finite"},
      Named{no_actuator, "no_actuator", "no motors for it"},
      Named{by_driver, "by_driver", "changed by the driver"},
  };
}

[[nodiscard]] constexpr OutputChange operator|(OutputChange a, OutputChange b) {
  return OutputChange(std::uint32_t(a) | std::uint32_t(b));
}
constexpr OutputChange& operator|=(OutputChange& a, OutputChange b) { return a = a | b; }
/// Whether any of the given bits is set.
[[nodiscard]] constexpr bool has_any(OutputChange changes, OutputChange bits) {
  return (std::uint32_t(changes) & std::uint32_t(bits)) != 0;
}

/// The changes in words, separated by commas; "none" when nothing changed.
[[nodiscard]] std::string describe(OutputChange changes);

/// The two sides of the last tick's output.
struct DeviceOutput {
  Wrench commanded;                           ///< wrench that the user's code asked for
  Wrench applied;                             ///< wrench that the motors got
  OutputChange changes = OutputChange::none;  ///< why they differ; bits of OutputChange
};

constexpr auto fields_of(Of<DeviceOutput>) {
  return std::tuple{
      field("commanded", &DeviceOutput::commanded, "wrench that the user's code asked for"),
      field("applied", &DeviceOutput::applied, "wrench that the motors got"),
      field("changes", &DeviceOutput::changes, "why they differ; bits of OutputChange"),
  };
}

}  // namespace hapticut
