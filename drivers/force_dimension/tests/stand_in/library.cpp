// SPDX-License-Identifier: Apache-2.0
// Functions of the library rather than of a device: errors, expert mode, and calls that need expert mode.
#include "stand_in.hpp"

using dhdsim::Device;
using dhdsim::expert;
using dhdsim::fail;
using dhdsim::simulation;

namespace {

thread_local int last_error = DHD_NO_ERROR;

}  // namespace

int dhdsim::fail(int error) {
  last_error = error;
  return -1;
}

extern "C" {

int dhdErrorGetLast() { return last_error; }
const char* dhdErrorGetLastStr() {
  switch (last_error) {
    case DHD_NO_ERROR:
      return "no error (stand-in)";
    case DHD_ERROR_COM:
      return "communication error (stand-in)";
    case DHD_ERROR_NO_DEVICE_FOUND:
      return "no device found (stand-in)";
    case DHD_ERROR_DEVICE_IN_USE:
      return "device in use (stand-in)";
    case DHD_ERROR_NOT_AVAILABLE:
      return "not available (stand-in)";
    default:
      return "some error (stand-in)";
  }
}

int dhdEnableExpertMode() {
  const std::lock_guard lock(simulation().mutex);
  simulation().expert = true;
  return 0;
}
int dhdDisableExpertMode() {
  const std::lock_guard lock(simulation().mutex);
  simulation().expert = false;
  return 0;
}
int dhdSetWatchdog(unsigned char val, char id) {
  return expert(id, [=](Device& d) {
    if (d.spec.has_watchdog == 0) return fail(DHD_ERROR_NOT_AVAILABLE);
    d.counters.watchdog = val;
    return 0;
  });
}
}
