# SPDX-License-Identifier: Apache-2.0
# Finds HDF5's C library. CMake's own module needs a C compiler, which a C++ project may not enable. Installed next to
# the package config, like FindHapticutOpenVDB.cmake. HDF5_ROOT names a folder to search first.
#
# Gives the imported target hapticut::hdf5 and HapticutHDF5_FOUND.

include(FindPackageHandleStandardArgs)
# Debian has two builds; the serial one needs no MPI.
find_path(HapticutHDF5_INCLUDE_DIR H5public.h HINTS ${HDF5_ROOT} $ENV{HDF5_ROOT}
          PATH_SUFFIXES include include/hdf5/serial hdf5/serial)
find_library(HapticutHDF5_LIBRARY NAMES hdf5_serial hdf5 HINTS ${HDF5_ROOT} $ENV{HDF5_ROOT} PATH_SUFFIXES lib lib64)
mark_as_advanced(HapticutHDF5_INCLUDE_DIR HapticutHDF5_LIBRARY)
find_package_handle_standard_args(HapticutHDF5 REQUIRED_VARS HapticutHDF5_LIBRARY HapticutHDF5_INCLUDE_DIR)

if(HapticutHDF5_FOUND AND NOT TARGET hapticut::hdf5)
  add_library(hapticut::hdf5 UNKNOWN IMPORTED)
  set_target_properties(hapticut::hdf5 PROPERTIES IMPORTED_LOCATION "${HapticutHDF5_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${HapticutHDF5_INCLUDE_DIR}")
endif()
