// SPDX-License-Identifier: Apache-2.0
#include <dhdc.h>
#include <drdc.h>

// The stand-in has no device until a test adds one.
int main() { return dhdOpen() < 0 && dhdErrorGetLast() == DHD_ERROR_NO_DEVICE_FOUND && !drdIsInitialized() ? 0 : 1; }
