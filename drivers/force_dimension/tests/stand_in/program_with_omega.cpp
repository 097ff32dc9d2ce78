// SPDX-License-Identifier: Apache-2.0
// Simulates a machine with the SDK and an omega.6. Linked with the main function of the command line program.
#include <dhdsim.h>

namespace {

const int omega = [] {
  dhdsim_reset();
  dhdsim_use_real_time(1);
  const dhdsim_device device = dhdsim_device_of(34, 1234);  // DHD_DEVICE_OMEGA6_RIGHT
  return dhdsim_add_device(&device);
}();

}  // namespace
