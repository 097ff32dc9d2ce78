// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hapticut/device/device.hpp"

/// @file
/// Devices of 3D Systems (Touch, Touch X, Phantom), through the HDAPI of OpenHaptics 3. Part of the component
/// `openhaptics`, which is built where the SDK is found.
namespace hapticut {

/// How an OpenHaptics device is opened.
struct OpenHapticsOptions {
  /// As it is called in the maker's setup program; empty: the default device.
  std::string device_name;

  /// When the driver refuses the name, try its usual names of the default device, and say so in the warnings of the
  /// run. Never done while another device is open, which would be found instead.
  bool other_names = true;

  /// Devices that are calibrated by holding their links at right angles (Phantom Premium). true: a person holds them so
  /// while the device is opened.
  bool reset_encoders = false;

  /// For applications with a deployment licence; empty: a development licence is installed.
  std::string license_vendor, license_application, license_password;

  double rate = 1000;        ///< [Hz] that is asked for; drivers that refuse keep their own
  double start_timeout = 5;  ///< [s] for the first tick of the driver's servo loop
  double silence = 0.5;      ///< [s] without a tick after which the driver counts as lost

  /// [s] the clock of the readings; null: the monotonic clock.
  std::function<double()> clock;
};

/// Opens a device. All devices must be opened before the first of them runs: the driver's scheduler must not be
/// running.
///
/// Base frame of the device: +x to the right, +y up, +z towards the user; the stylus point is the middle of the gimbal.
/// The callback runs in the driver's servo thread, whose priority is the driver's. Angular velocity is the filtered
/// difference of orientations, because what the driver reports for it is not reliable.
/// @throws Error with the driver's own words and what to do
[[nodiscard]] std::unique_ptr<Device> open_open_haptics(const OpenHapticsOptions& options = {});

/// Makes `open_device("openhaptics")` and `open_device("openhaptics:NAME")` work.
void use_open_haptics();

}  // namespace hapticut
