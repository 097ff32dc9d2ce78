// SPDX-License-Identifier: Apache-2.0
// The command line program as it is on a machine with the SDK and a Touch, whose scheduler runs in a thread of its own:
// linked with the program's own main.
#include <hdsim.h>

namespace {

const int touch = [] {
  hdsim_reset();
  const hdsim_device device = hdsim_touch("Default Device");
  hdsim_use_thread(1);
  return hdsim_add_device(&device);
}();

}  // namespace
