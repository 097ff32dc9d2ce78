// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/device_state.hpp"

namespace hapticut {

std::string describe(DeviceFault fault) {
  switch (fault) {
    case DeviceFault::none:
      return "no fault";
    case DeviceFault::disconnected:
      return "the device stopped answering; check its cable, its power and the permission to use it, then run again";
    case DeviceFault::uncalibrated:
      return "the device is not calibrated, so its position is meaningless; dock the stylus or run the maker's "
             "calibration";
    case DeviceFault::motors_warm:
      return "the motors are too warm; release the stylus until they have cooled";
    case DeviceFault::force_limit:
      return "the driver refused a force or its change as too large; soften the contact or lower the slew limit";
    case DeviceFault::speed_limit:
      return "the stylus moved faster than the driver allows; move it more slowly";
    case DeviceFault::overloaded:
      return "the servo loop took longer than its period; simulate less per tick";
    case DeviceFault::driver_error:
      return "the driver refused a call; the report of the run contains its message";
    case DeviceFault::switched_off:
      return "the motors were switched off; switch them on again at the device, with its button or dead man's switch";
  }
  return "an unknown fault";
}

std::string describe(OutputChange changes) {
  std::string words;
  for (const auto& one : names_of(Of<OutputChange>{}))
    if (has_any(changes, one.value))
      words += (words.empty() ? "" : ", ") + std::string(one.words != nullptr ? one.words : one.name);
  return words.empty() ? "none" : words;
}

}  // namespace hapticut
