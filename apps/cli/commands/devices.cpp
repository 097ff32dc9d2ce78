// SPDX-License-Identifier: Apache-2.0
#include "cli/commands/devices.hpp"

#include "device/use_maker_devices.hpp"
#include "reports/recording_source.hpp"

namespace hapticut::apps {

void use_all_devices() {
  use_recordings_if_possible();
  use_maker_devices();
}

}  // namespace hapticut::apps
