// SPDX-License-Identifier: Apache-2.0
#include "cli/commands/devices.hpp"

#include <utility>

#include "cli/commands/recording_source.hpp"
#include "hapticut/device/device.hpp"
#ifdef HAPTICUT_HAS_FORCEDIMENSION
#include "hapticut/device/force_dimension.hpp"
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
#include "hapticut/device/open_haptics.hpp"
#endif

namespace hapticut::cli {

void use_all_devices() {
  // What this build lacks, to somebody who builds no program.
  for (DeviceDriver& driver : device_drivers())
    if (const std::size_t calls = driver.missing.find(", link hapticut::"); calls != std::string::npos) {
      driver.missing.erase(calls);
      register_device_driver(std::move(driver));
    }
  use_recordings_if_possible();
#ifdef HAPTICUT_HAS_FORCEDIMENSION
  use_force_dimension();
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
  use_open_haptics();
#endif
}

}  // namespace hapticut::cli
