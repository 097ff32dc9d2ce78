// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/device_limits.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

OutputLimits output_limits(const DeviceCapabilities& device, double max_contact_speed) {
  require_positive(max_contact_speed, "max_contact_speed [m/s]");
  if (!(device.peak_force > 0) || device.output_degrees_of_freedom < 3)
    throw Error("the device '" + device.model +
                "' renders no force according to its capabilities, so it has no output limits" +
                Sentence::clause("; set " + "DeviceCapabilities::peak_force"_name + " and " +
                                 "DeviceCapabilities::output_degrees_of_freedom"_name + ", or set the " +
                                 "OutputLimits"_name + " directly") +
                ".");
  OutputLimits limits;
  limits.max_force = device.peak_force;
  limits.force_growth = default_force_growth(device.stiffness, max_contact_speed, device.peak_force);
  if (device.output_degrees_of_freedom < 6 || !(device.peak_torque > 0)) return limits;
  limits.max_torque = device.peak_torque;
  limits.torque_growth = limits.force_growth * device.peak_torque / device.peak_force;
  return limits;
}

}  // namespace hapticut
