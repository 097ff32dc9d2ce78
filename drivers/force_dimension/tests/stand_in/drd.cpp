// SPDX-License-Identifier: Apache-2.0
#include <drdc.h>

#include "stand_in.hpp"

using dhdsim::Device;
using dhdsim::on;

extern "C" {

int drdOpenID(char id) {
  return on(id, [=](Device&) { return int(id); });
}
bool drdIsInitialized(char id) {
  return on(id, [](Device& d) { return d.calibrated && d.wrist_initialised ? 1 : 0; }) == 1;
}
int drdAutoInit(char id) {
  return on(id, [](Device& d) {
    ++d.counters.auto_inits;
    d.calibrated = d.wrist_initialised = true;
    return 0;
  });
}
int drdStop(bool /*frc*/, char id) {
  return on(id, [](Device& d) {
    dhdsim::switch_off(d, DHD_FORCE_OFF_SOFTWARE);
    return 0;
  });
}
}
