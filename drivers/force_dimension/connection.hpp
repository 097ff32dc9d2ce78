// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "force_dimension/faults.hpp"
#include "hapticut/device/force_dimension.hpp"

/// @file
/// The interface to the library DHD. Its header defines uchar, ushort, uint and ulong at global scope, so only
/// connection.cpp includes it.
namespace hapticut::force_dimension {

/// The reply of the library to a call. Positive results of the library (time guard, saturated motors) are not errors.
struct Reply {
  bool ok = true;
  bool saturated = false;                 ///< the motors cannot render all of the command
  int error = 0;                          ///< number of the library's error
  DeviceFault fault = DeviceFault::none;  ///< meaning of the error; none: try again
};

/// The status that the device reports.
struct Status {
  bool force = false;               ///< its forces are switched on
  bool calibrated = false;          ///< its pose is valid
  ForceOff cause = ForceOff::none;  ///< why its forces are off
};

/// A device that the library has opened.
class Connection {
 public:
  /// @throws Error
  explicit Connection(const ForceDimensionOptions& options);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  [[nodiscard]] const DeviceCapabilities& capabilities() const { return capabilities_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Switches the brakes off, and gravity compensation, watchdog and forces on. If the device keeps its forces off, the
  /// loop sees why in its status.  @throws Error
  void begin();

  /// Sends a zero force, switches forces off and brakes on. Continues after errors.
  void end() noexcept;

  /// @name Functions for the loop, without allocation or lock in this library
  /// @{
  /// Reads pose, velocity and buttons, in B. Leaves the angular velocity unchanged if the device reports none.
  [[nodiscard]] Reply read(DeviceState& state) noexcept;
  [[nodiscard]] bool reports_angular_velocity() const noexcept { return reports_angular_velocity_; }
  [[nodiscard]] Reply write(const Wrench& wrench) noexcept;
  [[nodiscard]] Reply read_status(Status& status) noexcept;
  /// Switches the forces on. Does nothing, and is not `ok`, when another thread is in expert mode.
  [[nodiscard]] Reply switch_on() noexcept;
  /// Copies the library's text of the last error of this thread.
  static void copy_last_error(std::array<char, 128>& words) noexcept;
  /// @}

 private:
  void open(const std::string& name);
  void describe_device();
  void calibrate();
  void complain(const std::string& what);

  char id_ = -1;
  std::size_t number_ = 0;  // equals id_
  ForceDimensionOptions options_;
  DeviceCapabilities capabilities_;
  bool has_wrist_ = false, active_wrist_ = false, reports_angular_velocity_ = false, begun_ = false;
  std::vector<std::string> warnings_;
  std::size_t opening_warnings_ = 0;  // number of warnings from opening; the others are of the last run
};

}  // namespace hapticut::force_dimension
