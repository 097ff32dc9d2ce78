# SPDX-License-Identifier: Apache-2.0
# Finds the SDK of Force Dimension: the libraries dhd (devices) and drd (their calibration).
#
# Gives ForceDimension::DHD, and ForceDimension_FOUND, ForceDimension_INCLUDE_DIR, ForceDimension_DHD_LIBRARY and
# ForceDimension_DRD_LIBRARY. Looks in ForceDimension_ROOT (variable or environment: the folder that the archive unpacks to),
# in FD_SDK_ROOT (environment), in /opt/sdk-3* and /usr/local/src/sdk-3*, and in the system's folders.

file(GLOB _forcedimension_folders "/opt/sdk-3*" "/opt/force*dimension*" "/usr/local/src/sdk-3*")
set(_forcedimension_hints "${ForceDimension_ROOT}" "$ENV{ForceDimension_ROOT}" "$ENV{FD_SDK_ROOT}"
    ${_forcedimension_folders})
set(_forcedimension_suffixes "lib/release/lin-${CMAKE_SYSTEM_PROCESSOR}-gcc" "lib/lin-${CMAKE_SYSTEM_PROCESSOR}-gcc"
    lib lib64)

find_path(ForceDimension_INCLUDE_DIR dhdc.h HINTS ${_forcedimension_hints} PATH_SUFFIXES include)
find_library(ForceDimension_DHD_LIBRARY NAMES dhd dhdms64 HINTS ${_forcedimension_hints}
             PATH_SUFFIXES ${_forcedimension_suffixes})
find_library(ForceDimension_DRD_LIBRARY NAMES drd drdms64 HINTS ${_forcedimension_hints}
             PATH_SUFFIXES ${_forcedimension_suffixes})
# The archive's static libraries leave the linking of libusb to their user.
find_library(ForceDimension_USB_LIBRARY NAMES usb-1.0 libusb-1.0.so.0)
mark_as_advanced(ForceDimension_INCLUDE_DIR ForceDimension_DHD_LIBRARY ForceDimension_DRD_LIBRARY
                 ForceDimension_USB_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ForceDimension
  REQUIRED_VARS ForceDimension_DHD_LIBRARY ForceDimension_DRD_LIBRARY ForceDimension_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "Unpack the Force Dimension SDK and set ForceDimension_ROOT to its folder.")

if(ForceDimension_FOUND AND NOT TARGET ForceDimension::DHD)
  find_package(Threads QUIET)
  add_library(ForceDimension::DRD UNKNOWN IMPORTED GLOBAL)
  add_library(ForceDimension::DHD UNKNOWN IMPORTED GLOBAL)
  set_target_properties(ForceDimension::DRD PROPERTIES IMPORTED_LOCATION "${ForceDimension_DRD_LIBRARY}")
  set_target_properties(ForceDimension::DHD PROPERTIES
    IMPORTED_LOCATION "${ForceDimension_DHD_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${ForceDimension_INCLUDE_DIR}"
    # Imported targets' folders are system folders: what the header warns about does not become an error.
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${ForceDimension_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES ForceDimension::DRD)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set_property(TARGET ForceDimension::DHD PROPERTY INTERFACE_COMPILE_DEFINITIONS LINUX)  # the manual asks for it
  endif()
  # drd calls dhd, and both, where they are static, libusb and the system.
  set(_forcedimension_needs "${ForceDimension_DHD_LIBRARY}" ${CMAKE_DL_LIBS})
  if(ForceDimension_USB_LIBRARY)
    list(APPEND _forcedimension_needs "${ForceDimension_USB_LIBRARY}")
  endif()
  if(TARGET Threads::Threads)
    list(APPEND _forcedimension_needs Threads::Threads)
  endif()
  set_property(TARGET ForceDimension::DRD PROPERTY INTERFACE_LINK_LIBRARIES "${_forcedimension_needs}")
endif()
