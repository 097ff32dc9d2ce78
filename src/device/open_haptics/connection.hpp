// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <string>
#include <vector>

#include "hapticut/device/open_haptics.hpp"

namespace hapticut::open_haptics {

/// A device that the driver has initialised: its handle, and what it says about itself.
class Connection {
 public:
  /// @throws Error
  explicit Connection(const OpenHapticsOptions& options);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  [[nodiscard]] HHD handle() const { return handle_; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const { return capabilities_; }
  [[nodiscard]] HDenum calibration_style() const { return calibration_style_; }
  [[nodiscard]] bool measures_temperature() const { return measures_temperature_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Switches the amplifiers, and what the driver offers for safety.
  void enable_force(bool on);

 private:
  void initialise(const OpenHapticsOptions& options);
  void ask();
  void calibrate(bool reset_encoders);

  HHD handle_ = HD_INVALID_HANDLE;
  DeviceCapabilities capabilities_;
  HDenum calibration_style_ = 0;
  bool measures_temperature_ = false;
  std::vector<std::string> warnings_;
};

}  // namespace hapticut::open_haptics
