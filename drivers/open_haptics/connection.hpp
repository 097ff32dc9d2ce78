// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <atomic>
#include <string>
#include <vector>

#include "hapticut/device/open_haptics.hpp"

namespace hapticut::open_haptics {

/// A device that the driver has initialised: its handle and its capabilities.
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

  /// Switches the amplifiers on, with the safety functions of the driver, or off.
  void enable_force(bool on);

  /// Switches the amplifiers off from another thread while a tick hangs.
  void release_hand() noexcept;
  [[nodiscard]] bool has_released_hand() const noexcept { return hand_released_.load(); }

  /// Switches the amplifiers on again after `release_hand`. Called in a tick that has acquired the driver.
  void resume() noexcept {
    if (hand_released_.exchange(false)) hdEnable(HD_FORCE_OUTPUT);
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
  std::atomic<bool> hand_released_{false};
};

}  // namespace hapticut::open_haptics
