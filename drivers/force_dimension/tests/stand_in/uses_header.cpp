// SPDX-License-Identifier: Apache-2.0
// Compiled by the tests in several dialects; see CMakeLists.txt.
#include <dhdc.h>
#include <drdc.h>

static_assert(DHD_ERROR_COM == 2 && DHD_ERROR_EXPERT_MODE_DISABLED == 9 && DHD_ERROR_NO_REGULATION == 22);
static_assert(DHD_MAX_STATUS == 17 && DHD_STATUS_FORCE_OFF_CAUSE == 14);
static_assert(sizeof(uchar) == 1 && sizeof(ushort) == 2, "names at global scope, as in the real header");

int one_tick() {
  double x = 0, y = 0, z = 0;
  return dhdGetPosition(&x, &y, &z) < 0 ? dhdErrorGetLast() : dhdSetForce(0, 0, 0);
}
