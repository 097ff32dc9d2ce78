# SPDX-License-Identifier: Apache-2.0
# The component `forcedimension`: devices of Force Dimension, and the Falcon through their library.
include(HapticutMakerSdk)
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
set(HAPTICUT_WITH_FORCEDIMENSION AUTO CACHE STRING "devices of Force Dimension through their SDK: AUTO, ON or OFF")
hapticut_maker_sdk(FORCEDIMENSION "devices of Force Dimension" ForceDimension ForceDimension_DHD_LIBRARY
  "the Force Dimension SDK")
