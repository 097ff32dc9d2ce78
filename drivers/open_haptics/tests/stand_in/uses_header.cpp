// SPDX-License-Identifier: Apache-2.0
// Compiled by the tests in several dialects; see CMakeLists.txt.
#include <HD/hd.h>

static_assert(sizeof(HDErrorInfo) == 12);
static_assert(HD_CALLBACK_DONE == 0 && HD_CALLBACK_CONTINUE == 1);
static_assert(HD_VERSION_MAJOR_NUMBER == 3);

HDCallbackCode HDCALLBACK one_frame(void* /*data*/) {
  const HHD device = hdGetCurrentDevice();
  hdBeginFrame(device);
  hdEndFrame(device);
  return HD_DEVICE_ERROR(hdGetError()) ? HD_CALLBACK_DONE : HD_CALLBACK_CONTINUE;
}
