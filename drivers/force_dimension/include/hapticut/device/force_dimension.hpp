// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"

/// @file
/// Devices of Force Dimension (omega, delta, sigma, lambda) and the Falcon, through the library DHD. They are part of
/// the component `forcedimension`, which is built if the SDK is found.
namespace hapticut {

/// Options for opening a device of Force Dimension.
struct ForceDimensionOptions {
  /// A serial number (1234) or a model; empty: the first free device.
  /// "omega.7" is a model for either hand, "omega.7-left" and "omega.7-right" are models for one hand.
  std::string device_name;

  /// Whether an uncalibrated device calibrates itself by moving; false: calibrate it by hand.
  /// Release the device before it moves. There is no force until it is calibrated.
  bool calibrate = false;
  double effector_mass = 0;  ///< [kg] mass at the tip, for gravity compensation; 0: the device's own value

  /// [s] time without a command after which the device switches its forces off.
  /// In steps of 125 us. While a callback hangs, the watchdog of this library fades the force out from 10 ms on by
  /// further commands. With a shorter time here the device switches its force off earlier.
  double watchdog = 20e-3;

  /// Clock of the readings, in [s]; null: the monotonic clock.
  /// A custom clock allows a run in simulated time. It is called once per tick.
  std::function<double()> clock;
};

constexpr auto fields_of(Of<ForceDimensionOptions>) {
  using O = ForceDimensionOptions;
  return std::tuple{
      field("device_name", &O::device_name, "a serial number (1234) or a model; empty: the first free device"),
      field("calibrate", &O::calibrate,
            "whether an uncalibrated device calibrates itself by moving; false: calibrate it by hand"),
      field("effector_mass", &O::effector_mass, "kg", Range::not_negative(),
            "mass at the tip, for gravity compensation; 0: the device's own value"),
      field("watchdog", &O::watchdog, "s", Range::between(2e-3, 31.875e-3),
            "time without a command after which the device switches its forces off"),
      field("clock", &O::clock, "clock of the readings, in [s]; null: the monotonic clock"),
  };
}

/// Opens a device.
///
/// Base frame of the device: +x to the right, +y up, +z towards the user. The origin is that of the DHD library, in the
/// middle of the workspace. (The frame of DHD has x towards the user, y to the right, z up.) The stylus frame equals
/// the base frame when DHD reports the identity as orientation.
///
/// This library drives the loop: one reading and one force command per tick, also when the force is zero, because the
/// device compensates the weight of its arm with each command. When the device switches its forces off (too fast a
/// motion, its watchdog), they are switched on again after 0.1 s, and faded in when the tool is free. When a button, a
/// dead man's switch or another program switches the forces off, only the same cause can switch them on again.
/// @throws Error with the message of DHD and what to do
[[nodiscard]] std::unique_ptr<Device> open_force_dimension(const ForceDimensionOptions& options = {});

/// Makes `open_device("forcedimension")` and `open_device("forcedimension:NAME")` work.
void use_force_dimension();

}  // namespace hapticut
