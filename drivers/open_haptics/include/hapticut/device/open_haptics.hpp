// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"

/// @file
/// Devices of 3D Systems (Touch, Touch X, Phantom), through the HDAPI of OpenHaptics 3. They are part of the component
/// `openhaptics`, which is built if the SDK is found.
namespace hapticut {

/// How an OpenHaptics device is opened.
struct OpenHapticsOptions {
  /// Name of the device in the maker's setup program; empty: the default device
  std::string device_name;

  /// Whether to try the usual names of the default device when the driver refuses the name.
  /// A warning of the run reports the name that was used. Only while no other device is open, because the driver would
  /// find that device instead.
  bool other_names = true;
  /// Calibrates a Phantom Premium while it is opened; a person must hold the links at right angles
  bool reset_encoders = false;
  std::string license_vendor;       ///< vendor of a deployment licence; empty: a development licence is installed
  std::string license_application;  ///< application of a deployment licence
  std::string license_password;     ///< password of a deployment licence
  double start_timeout = 5;         ///< [s] longest wait for the first tick of the driver's servo loop
  double silence = 0.5;             ///< [s] time without a tick after which the driver counts as lost
  std::function<double()> clock;    ///< clock of the readings, in [s]; null: the monotonic clock
};

constexpr auto fields_of(Of<OpenHapticsOptions>) {
  using O = OpenHapticsOptions;
  return std::tuple{
      field("device_name", &O::device_name,
            "name of the device in the maker's setup program; empty: the default device"),
      field("other_names", &O::other_names,
            "whether to try the usual names of the default device when the driver refuses the name"),
      field("reset_encoders", &O::reset_encoders,
            "calibrates a Phantom Premium while it is opened; a person must hold the links at right angles"),
      field("license_vendor", &O::license_vendor,
            "vendor of a deployment licence; empty: a development licence is installed"),
      field("license_application", &O::license_application, "application of a deployment licence"),
      field("license_password", &O::license_password, "password of a deployment licence"),
      field("start_timeout", &O::start_timeout, "s", Range::positive(),
            "longest wait for the first tick of the driver's servo loop"),
      field("silence", &O::silence, "s", Range::positive(),
            "time without a tick after which the driver counts as lost"),
      field("clock", &O::clock, "clock of the readings, in [s]; null: the monotonic clock"),
  };
}

/// Opens a device. Open all devices before the first of them runs, because the driver's scheduler must not be running.
///
/// Base frame of the device: +x to the right, +y up, +z towards the user. The stylus point is the middle of the gimbal.
/// The callback runs in the driver's servo thread; the driver sets its priority. The driver is asked to tick with
/// GuardOptions::period. If it refuses, the run has the driver's own period, and a warning says so. The angular
/// velocity is the filtered difference of orientations, because the value that the driver reports is not reliable.
/// @throws Error with the message of the driver and what to do
[[nodiscard]] std::unique_ptr<Device> open_open_haptics(const OpenHapticsOptions& options = {});

/// Makes `open_device("openhaptics")` and `open_device("openhaptics:NAME")` work.
void use_open_haptics();

}  // namespace hapticut
