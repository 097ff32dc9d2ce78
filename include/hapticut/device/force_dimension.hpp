// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"

/// @file
/// Devices of Force Dimension (omega, delta, sigma, lambda), and the Falcon, through the library DHD. Part of the
/// component `forcedimension`, which is built where the SDK is found.
namespace hapticut {

/// How a device of Force Dimension is opened.
struct ForceDimensionOptions {
  /// "omega.7" is one of either hand, "omega.7-left" and "omega.7-right" one of that hand.
  std::string device_name;

  /// Let go of it before it moves. Until it is calibrated there is no force.
  bool calibrate = false;
  double effector_mass = 0;

  /// In steps of 125 us. While a callback hangs, our own watchdog fades the force out from 10 ms on and goes on
  /// commanding; a shorter time here lets the device be faster than that.
  double watchdog = 20e-3;

  /// With a clock of your own a run may be in simulated time: it is asked once per tick.
  std::function<double()> clock;
};

constexpr auto fields_of(Of<ForceDimensionOptions>) {
  using O = ForceDimensionOptions;
  return std::tuple{
      field("device_name", &O::device_name, "a serial number (1234), or a model; empty: the first that is free"),
      field("calibrate", &O::calibrate,
            "the device calibrates itself by moving, where it is not calibrated; false: calibrate it by hand"),
      field("effector_mass", &O::effector_mass, "kg", Range::not_negative(),
            "that gravity compensation carries at the tip; 0: what the device knows of itself"),
      field("watchdog", &O::watchdog, "s", Range::between(2e-3, 31.875e-3),
            "without a command after which the device itself switches its forces off"),
      field("clock", &O::clock, "of the readings, in seconds; null: the monotonic clock"),
  };
}

/// Opens a device.
///
/// Base frame of the device: +x to the right, +y up, +z towards the user, the origin where the library has its own, in
/// the middle of the workspace. (The library's own frame has x towards the user, y to the right, z up.) The stylus
/// frame is that of the base when the library calls the orientation the identity.
///
/// The loop is ours: one reading and one force command per tick, also when the force is zero, because the weight of the
/// arm is compensated with each command. Forces that the device itself switched off (too fast a motion, its watchdog)
/// are switched on again after a tenth of a second, and faded in when the tool is free; those that a button, a dead
/// man's switch or another program switched off come back only from there.
/// @throws Error with the library's own words and what to do
[[nodiscard]] std::unique_ptr<Device> open_force_dimension(const ForceDimensionOptions& options = {});

/// Makes `open_device("forcedimension")` and `open_device("forcedimension:NAME")` work.
void use_force_dimension();

}  // namespace hapticut
