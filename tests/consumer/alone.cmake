# SPDX-License-Identifier: Apache-2.0
# Configures hapticut with one component, and the components that it needs, and runs the tests of its folder.
#   cmake -DCOMPONENTS=component,... -DFOLDERS=... -DKERNELS=... -DSOURCE=... -DBUILD=...
#     -DCXX=... -DCC=... -DLAUNCHER=... -P alone.cmake
#
# COMPONENTS  components whose option is ON, e.g. IO,IMPORT; all others are OFF
# FOLDERS     folders in tests/unit, or the folder of a driver, e.g. heat,sound; the test program of heat is test_heat
# BUILD       build folder; ccache finds the objects of build/release
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/commands.cmake")
string(REPLACE "," ";" COMPONENTS "${COMPONENTS}")
string(REPLACE "," ";" programs "${FOLDERS}")
list(TRANSFORM programs PREPEND "test_")
string(REPLACE "," "|" FOLDERS "${FOLDERS}")
set(ENV{CMAKE_C_COMPILER_LAUNCHER} "${LAUNCHER}")
set(ENV{CMAKE_CXX_COMPILER_LAUNCHER} "${LAUNCHER}")
set(options "-DHAPTICUT_KERNELS=${KERNELS}" -DHAPTICUT_WITH_TESTS=ON -DHAPTICUT_WITH_BENCHMARKS=OFF
    -DHAPTICUT_WITH_EXAMPLES=OFF -DHAPTICUT_WITH_PYTHON=OFF)
foreach(component SIMD IO IMPORT ITK ASSIMP SETTINGS C VIEW CLI)
  set(value OFF)
  if(component IN_LIST COMPONENTS OR component STREQUAL "SIMD")
    set(value ON)
  endif()
  list(APPEND options "-DHAPTICUT_WITH_${component}=${value}")
endforeach()
file(REMOVE_RECURSE "${BUILD}")
must("${CMAKE_COMMAND}" -E chdir "${SOURCE}" "${CMAKE_COMMAND}" --preset release -B "${BUILD}" "-DCMAKE_CXX_COMPILER=${CXX}"
     "-DCMAKE_C_COMPILER=${CC}" ${options})
must("${CMAKE_COMMAND}" --build "${BUILD}" -t ${programs})
must("${CMAKE_CTEST_COMMAND}" --test-dir "${BUILD}" -R "^(${FOLDERS})([.]|$)" --output-on-failure --no-tests=error)
