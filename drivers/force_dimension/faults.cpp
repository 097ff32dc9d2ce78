// SPDX-License-Identifier: Apache-2.0
#include "force_dimension/faults.hpp"

namespace hapticut::force_dimension {
DeviceFault fault_of(ForceOff cause) noexcept {
  switch (cause) {
    case ForceOff::velocity:
      return DeviceFault::speed_limit;
    case ForceOff::watchdog:
      return DeviceFault::overloaded;
    case ForceOff::usb:
      return DeviceFault::disconnected;
    case ForceOff::none:  // the device does not report why its forces are off
    case ForceOff::button:
    case ForceOff::software:
    case ForceOff::deadman:
    case ForceOff::count:
      break;
  }
  return DeviceFault::switched_off;
}

bool can_reenable(ForceOff cause) noexcept { return cause == ForceOff::velocity || cause == ForceOff::watchdog; }

const char* describe(ForceOff cause) noexcept {
  switch (cause) {
    case ForceOff::button:
      return "its force button was pressed; press it again";
    case ForceOff::velocity:
      return "it moved faster than it allows, and braked; move it more slowly";
    case ForceOff::watchdog:
      return "its watchdog waited too long for a command; simulate less per tick, or find out what delayed the loop";
    case ForceOff::software:
      return "a program switched them off; end other programs that use the device";
    case ForceOff::usb:
      return "its USB connection was lost; check the cable";
    case ForceOff::deadman:
      return "its dead man's switch was released; hold it";
    case ForceOff::none:
    case ForceOff::count:
      break;
  }
  return "it does not report why; check its force button and its lights";
}

DeviceFault fault_of(int code) noexcept {
  switch (code) {
    case error::kNone:
    case error::kBusy:
    case error::kTimeout:
    case error::kGeometry:
    case error::kNotReady:
    case error::kNotEnabled:
      return DeviceFault::none;
    case error::kCommunication:
    case error::kNoDriver:
    case error::kNoDevice:
      return DeviceFault::disconnected;
    default:
      return DeviceFault::driver_error;
  }
}

}  // namespace hapticut::force_dimension
