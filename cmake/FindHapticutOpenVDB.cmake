# SPDX-License-Identifier: Apache-2.0
# Finds OpenVDB and TBB without touching the caller: OpenVDB's own find module switches BUILD_SHARED_LIBS on and needs
# an extended module path. Installed next to the package config, so users of hapticut get the same behaviour.
#
# Gives the imported target hapticut::openvdb and HapticutOpenVDB_FOUND, HapticutOpenVDB_VERSION.

include(FindPackageHandleStandardArgs)

find_path(HapticutOpenVDB_INCLUDE_DIR openvdb/version.h HINTS ${OpenVDB_ROOT} $ENV{OpenVDB_ROOT} PATH_SUFFIXES include)
find_library(HapticutOpenVDB_LIBRARY openvdb HINTS ${OpenVDB_ROOT} $ENV{OpenVDB_ROOT} PATH_SUFFIXES lib lib64)
find_path(HapticutOpenVDB_TBB_INCLUDE_DIR tbb/parallel_for.h HINTS ${TBB_ROOT} $ENV{TBB_ROOT} PATH_SUFFIXES include)
find_library(HapticutOpenVDB_TBB_LIBRARY tbb HINTS ${TBB_ROOT} $ENV{TBB_ROOT} PATH_SUFFIXES lib lib64)
# OpenVDB's half-float values need Imath.
find_path(HapticutOpenVDB_IMATH_INCLUDE_DIR Imath/half.h HINTS ${Imath_ROOT} $ENV{Imath_ROOT} PATH_SUFFIXES include)
find_library(HapticutOpenVDB_IMATH_LIBRARY NAMES Imath Imath-3_1 HINTS ${Imath_ROOT} $ENV{Imath_ROOT} PATH_SUFFIXES lib lib64)
find_package(Threads QUIET)

if(HapticutOpenVDB_INCLUDE_DIR)
  file(STRINGS "${HapticutOpenVDB_INCLUDE_DIR}/openvdb/version.h" _lines
       REGEX "#define OPENVDB_LIBRARY_(MAJOR|MINOR|PATCH)_VERSION_NUMBER")
  string(REGEX REPLACE "[^0-9]*([0-9]+)[^0-9]*([0-9]+)[^0-9]*([0-9]+).*" "\\1.\\2.\\3" HapticutOpenVDB_VERSION "${_lines}")
endif()

set(HapticutOpenVDB_NEEDS
    "hapticut needs OpenVDB 10 and TBB: sudo apt-get install libopenvdb-dev libtbb-dev libimath-dev libboost-dev")
find_package_handle_standard_args(HapticutOpenVDB
  REQUIRED_VARS HapticutOpenVDB_LIBRARY HapticutOpenVDB_INCLUDE_DIR HapticutOpenVDB_TBB_LIBRARY
                HapticutOpenVDB_TBB_INCLUDE_DIR HapticutOpenVDB_IMATH_LIBRARY HapticutOpenVDB_IMATH_INCLUDE_DIR Threads_FOUND
  VERSION_VAR HapticutOpenVDB_VERSION
  REASON_FAILURE_MESSAGE "${HapticutOpenVDB_NEEDS}")

if(HapticutOpenVDB_FOUND AND HapticutOpenVDB_VERSION VERSION_LESS 10)
  set(HapticutOpenVDB_FOUND FALSE)
  set(HapticutOpenVDB_NEEDS
      "hapticut needs OpenVDB 10 or newer; found ${HapticutOpenVDB_VERSION} in ${HapticutOpenVDB_INCLUDE_DIR}")
  if(HapticutOpenVDB_FIND_REQUIRED)
    message(FATAL_ERROR "${HapticutOpenVDB_NEEDS}")
  endif()
endif()

if(HapticutOpenVDB_FOUND AND NOT TARGET hapticut::openvdb)
  add_library(hapticut::openvdb UNKNOWN IMPORTED)
  set_target_properties(hapticut::openvdb PROPERTIES
    IMPORTED_LOCATION "${HapticutOpenVDB_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${HapticutOpenVDB_INCLUDE_DIR};${HapticutOpenVDB_TBB_INCLUDE_DIR};${HapticutOpenVDB_IMATH_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${HapticutOpenVDB_TBB_LIBRARY};${HapticutOpenVDB_IMATH_LIBRARY};Threads::Threads")
endif()
mark_as_advanced(HapticutOpenVDB_INCLUDE_DIR HapticutOpenVDB_LIBRARY HapticutOpenVDB_TBB_INCLUDE_DIR
                 HapticutOpenVDB_TBB_LIBRARY HapticutOpenVDB_IMATH_INCLUDE_DIR HapticutOpenVDB_IMATH_LIBRARY)
