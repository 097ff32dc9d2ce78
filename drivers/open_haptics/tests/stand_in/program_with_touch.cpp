// SPDX-License-Identifier: Apache-2.0
// Simulates a machine with the SDK and a Touch, whose scheduler runs in a separate thread. Linked with the main
// function of the command line program.
#include <hdsim.h>

namespace {

const int touch = [] {
  hdsim_reset();
  const hdsim_device device = hdsim_touch("Default Device");
  hdsim_use_thread(1);
  return hdsim_add_device(&device);
}();

}  // namespace
