// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <atomic>
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

  /// Switches the amplifiers off beside a tick that hangs.
  void let_go() noexcept;
  [[nodiscard]] bool has_let_go() const noexcept { return let_go_.load(); }

  /// Switches them on again. In a tick, with the turn.
  void hold() noexcept {
    if (let_go_.exchange(false)) hdEnable(HD_FORCE_OUTPUT);
  }

 private:
  void initialise(const OpenHapticsOptions& options);
  void ask();
  void calibrate(bool reset_encoders);

  HHD handle_ = HD_INVALID_HANDLE;
  DeviceCapabilities capabilities_;
  HDenum calibration_style_ = 0;
  bool measures_temperature_ = false;
  std::vector<std::string> warnings_;
  std::atomic<bool> let_go_{false};
};

}  // namespace hapticut::open_haptics
