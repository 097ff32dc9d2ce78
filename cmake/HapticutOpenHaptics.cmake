# SPDX-License-Identifier: Apache-2.0
# The component `openhaptics`: devices of 3D Systems. Their SDK is not in Debian and cannot be installed by a script.

set(HAPTICUT_WITH_OPENHAPTICS AUTO CACHE STRING "devices of 3D Systems through OpenHaptics: AUTO, ON or OFF")
set_property(CACHE HAPTICUT_WITH_OPENHAPTICS PROPERTY STRINGS AUTO ON OFF)
set(HAPTICUT_OPENHAPTICS FALSE)
if(HAPTICUT_WITH_OPENHAPTICS)
  find_package(OpenHaptics QUIET MODULE)
  if(OpenHaptics_FOUND)
    set(HAPTICUT_OPENHAPTICS TRUE)
    list(APPEND HAPTICUT_COMPONENT_REPORT "OPENHAPTICS: on  (devices of 3D Systems, ${OpenHaptics_HD_LIBRARY})")
  elseif(NOT HAPTICUT_WITH_OPENHAPTICS STREQUAL "AUTO")
    message(FATAL_ERROR "HAPTICUT_WITH_OPENHAPTICS=ON, but the SDK was not found: install OpenHaptics for Developers "
                        "and the device's driver from 3D Systems, or set OpenHaptics_ROOT.")
  else()
    list(APPEND HAPTICUT_COMPONENT_REPORT "OPENHAPTICS: off (devices of 3D Systems, to turn it on: docs/devices.md)")
  endif()
else()
  list(APPEND HAPTICUT_COMPONENT_REPORT "OPENHAPTICS: off (devices of 3D Systems, HAPTICUT_WITH_OPENHAPTICS=OFF)")
endif()
