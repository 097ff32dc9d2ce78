// SPDX-License-Identifier: Apache-2.0
#include <HD/hd.h>

// The stand-in has no device until a test adds one.
int main() { return hdInitDevice(HD_DEFAULT_DEVICE) == HD_INVALID_HANDLE ? 0 : 1; }
