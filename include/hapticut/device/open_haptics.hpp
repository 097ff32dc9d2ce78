// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"

/// @file
/// Devices of 3D Systems (Touch, Touch X, Phantom), through the HDAPI of OpenHaptics 3. Part of the component
/// `openhaptics`, which is built where the SDK is found.
namespace hapticut {

/// How an OpenHaptics device is opened.
struct OpenHapticsOptions {
  std::string device_name;

  /// The warnings of the run say so. Never done while another device is open, which would be found instead.
  bool other_names = true;
  bool reset_encoders = false;
  std::string license_vendor, license_application, license_password;
  double start_timeout = 5;
  double silence = 0.5;
  std::function<double()> clock;
};

constexpr auto fields_of(Of<OpenHapticsOptions>) {
  using O = OpenHapticsOptions;
  return std::tuple{
      field("device_name", &O::device_name, "as it is called in the maker's setup program; empty: the default device"),
      field("other_names", &O::other_names,
            "when the driver refuses the name, try its usual names of the default device"),
      field("reset_encoders", &O::reset_encoders,
            "a person holds the links at right angles while the device is opened; calibrates a Phantom Premium"),
      field("license_vendor", &O::license_vendor,
            "of an application with a deployment licence; empty: a development licence is installed"),
      field("license_application", &O::license_application, "the same"),
      field("license_password", &O::license_password, "the same"),
      field("start_timeout", &O::start_timeout, "s", Range::positive(),
            "for the first tick of the driver's servo loop"),
      field("silence", &O::silence, "s", Range::positive(), "without a tick after which the driver counts as lost"),
      field("clock", &O::clock, "of the readings, in seconds; null: the monotonic clock"),
  };
}

/// Opens a device. All devices must be opened before the first of them runs: the driver's scheduler must not be
/// running.
///
/// Base frame of the device: +x to the right, +y up, +z towards the user; the stylus point is the middle of the gimbal.
/// The callback runs in the driver's servo thread, whose priority is the driver's. It is asked to tick with
/// GuardOptions::period; where it refuses, the run has the driver's own period, and a warning that says so. Angular
/// velocity is the filtered difference of orientations, because what the driver reports for it is not reliable.
/// @throws Error with the driver's own words and what to do
[[nodiscard]] std::unique_ptr<Device> open_open_haptics(const OpenHapticsOptions& options = {});

/// Makes `open_device("openhaptics")` and `open_device("openhaptics:NAME")` work.
void use_open_haptics();

}  // namespace hapticut
