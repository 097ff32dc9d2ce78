# SPDX-License-Identifier: Apache-2.0
# Finds the device library (HDAPI) of 3D Systems OpenHaptics 3.
#
# Gives OpenHaptics::HD, and OpenHaptics_FOUND, OpenHaptics_INCLUDE_DIR, OpenHaptics_HD_LIBRARY, OpenHaptics_VERSION.
# Looks in OpenHaptics_ROOT (variable or environment), in OH_SDK_BASE and 3DTOUCH_BASE (environment, set by the
# installers), in /opt/OpenHaptics/Developer/* and in the system's folders. HDU, HL and QuickHaptics are not needed.

file(GLOB _openhaptics_developer "/opt/OpenHaptics/Developer/*" "C:/OpenHaptics/Developer/*")
set(_openhaptics_hints "${OpenHaptics_ROOT}" "$ENV{OpenHaptics_ROOT}" "$ENV{OH_SDK_BASE}" "$ENV{3DTOUCH_BASE}"
    ${_openhaptics_developer})
if(CMAKE_SIZEOF_VOID_P EQUAL 8)
  set(_openhaptics_suffixes lib lib64 lib/x64 usr/lib usr/lib64)
else()
  set(_openhaptics_suffixes lib lib/Win32 usr/lib)
endif()

find_path(OpenHaptics_INCLUDE_DIR HD/hd.h HINTS ${_openhaptics_hints} PATH_SUFFIXES include usr/include)
find_library(OpenHaptics_HD_LIBRARY NAMES HD hd HINTS ${_openhaptics_hints} PATH_SUFFIXES ${_openhaptics_suffixes})
# libHD needs the device's driver; the name changed between driver generations.
find_library(OpenHaptics_DRIVER_LIBRARY NAMES PhantomIOLib42 PHANToMIO HINTS ${_openhaptics_hints}
             PATH_SUFFIXES ${_openhaptics_suffixes})
mark_as_advanced(OpenHaptics_INCLUDE_DIR OpenHaptics_HD_LIBRARY OpenHaptics_DRIVER_LIBRARY)

set(OpenHaptics_VERSION "")
if(OpenHaptics_INCLUDE_DIR)
  file(STRINGS "${OpenHaptics_INCLUDE_DIR}/HD/hdDefines.h" _openhaptics_lines REGEX "HD_VERSION_(MAJOR|MINOR|BUILD)_NUMBER")
  foreach(_line IN LISTS _openhaptics_lines)
    if(_line MATCHES "HD_VERSION_[A-Z]+_NUMBER[ \t]+0*([0-9]+)")
      list(APPEND OpenHaptics_VERSION "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  list(JOIN OpenHaptics_VERSION "." OpenHaptics_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenHaptics REQUIRED_VARS OpenHaptics_HD_LIBRARY OpenHaptics_INCLUDE_DIR
  VERSION_VAR OpenHaptics_VERSION
  REASON_FAILURE_MESSAGE "Install OpenHaptics for Developers and the device's driver from 3D Systems, or set OpenHaptics_ROOT.")

if(OpenHaptics_FOUND AND NOT TARGET OpenHaptics::HD)
  add_library(OpenHaptics::HD UNKNOWN IMPORTED GLOBAL)
  set_target_properties(OpenHaptics::HD PROPERTIES
    IMPORTED_LOCATION "${OpenHaptics_HD_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenHaptics_INCLUDE_DIR}"
    # Include folders of imported targets are system folders, so unknown attributes and pragmas of the header are no
    # errors.
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OpenHaptics_INCLUDE_DIR}")
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    # The header tests `linux`, which a compiler in strict ISO mode does not predefine.
    set_property(TARGET OpenHaptics::HD PROPERTY INTERFACE_COMPILE_DEFINITIONS linux=1)
  endif()
  if(OpenHaptics_DRIVER_LIBRARY)
    set_property(TARGET OpenHaptics::HD PROPERTY INTERFACE_LINK_LIBRARIES "${OpenHaptics_DRIVER_LIBRARY}")
  endif()
endif()
