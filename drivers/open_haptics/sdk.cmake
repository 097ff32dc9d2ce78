# SPDX-License-Identifier: Apache-2.0
# The component `openhaptics`: devices of 3D Systems.
include(HapticutMakerSdk)
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
set(HAPTICUT_WITH_OPENHAPTICS AUTO CACHE STRING "devices of 3D Systems through OpenHaptics: AUTO, ON or OFF")
hapticut_maker_sdk(OPENHAPTICS "devices of 3D Systems" OpenHaptics OpenHaptics_HD_LIBRARY
  "OpenHaptics for Developers and the device's driver from 3D Systems")
