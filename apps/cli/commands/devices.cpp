// SPDX-License-Identifier: Apache-2.0
#include "cli/commands/devices.hpp"

#include <utility>

#include "device/use_vendor_devices.hpp"
#include "hapticut/device/device.hpp"
#include "reports/recording_source.hpp"

namespace hapticut::cli {

void use_all_devices() {
  // Says what this build lacks, for users who do not build programs.
  for (DeviceDriver& driver : device_drivers())
    if (const std::size_t calls = driver.missing.find(", link hapticut::"); calls != std::string::npos) {
      driver.missing.erase(calls);
      register_device_driver(std::move(driver));
    }
  use_recordings_if_possible();
  use_vendor_devices();
}

}  // namespace hapticut::cli
