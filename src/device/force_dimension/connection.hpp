// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "device/force_dimension/faults.hpp"
#include "hapticut/device/force_dimension.hpp"

/// @file
/// The library, without its header: that one defines uchar, ushort, uint and ulong at global scope, and stays in
/// connection.cpp.
namespace hapticut::force_dimension {

/// How a call went. Positive answers of the library (time guard, saturated motors) are not errors.
struct Answer {
  bool ok = true;
  bool saturated = false;                 ///< the motors cannot render all of the command
  int error = 0;                          ///< of the library
  DeviceFault fault = DeviceFault::none;  ///< that the error means; none: try again
};

/// What the device says about itself.
struct Status {
  bool force = false;       ///< its forces are on
  bool calibrated = false;  ///< its pose means something
  ForceOff cause = ForceOff::none;
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

  /// Brakes off, gravity compensation and watchdog on, and the forces, unless the device waits for something that the
  /// loop will see in its status.  @throws Error
  void begin();

  /// Zero force, forces off, brakes on; whatever fails on the way.
  void end() noexcept;

  /// @name What the loop calls: no allocation, no lock of ours
  /// @{
  /// Pose, velocity and buttons, in B. The angular velocity is left alone where the device reports none.
  [[nodiscard]] Answer read(DeviceState& state) noexcept;
  [[nodiscard]] bool reports_turning() const noexcept { return reports_turning_; }
  [[nodiscard]] Answer write(const Wrench& wrench) noexcept;
  [[nodiscard]] Answer ask(Status& status) noexcept;
  /// Does nothing, and is not `ok`, when another thread is in expert mode.
  [[nodiscard]] Answer switch_on() noexcept;
  /// The library's words for the last error of this thread.
  static void copy_last_error(std::array<char, 128>& words) noexcept;
  /// @}

 private:
  void open(const std::string& name);
  void describe_device();
  void calibrate();
  void complain(const std::string& what);

  char id_ = -1;
  std::size_t number_ = 0;  // the same
  ForceDimensionOptions options_;
  DeviceCapabilities capabilities_;
  bool has_wrist_ = false, active_wrist_ = false, reports_turning_ = false, begun_ = false;
  std::vector<std::string> warnings_;
  std::size_t of_opening_ = 0;  // of them; the others are of the last run
};

}  // namespace hapticut::force_dimension
