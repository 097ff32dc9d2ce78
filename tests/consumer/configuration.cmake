# SPDX-License-Identifier: Apache-2.0
# Configures, builds, installs and uses hapticut with some of its components off: library, C interface and program.
#   cmake -DWITHOUT=component,... -DHIDDEN=component,... -DOPTIONS=-D...,... -DKERNELS=... -DSOURCE=... -DBUILD=...
#     -DCXX=... -DCC=... -DLAUNCHER=... -P configuration.cmake
#
# WITHOUT  components whose option is OFF, e.g. IO,IMPORT,ITK,ASSIMP
# HIDDEN   components whose packages CMake does not find, as on a machine without them: their option is AUTO. A second
#          configuration finds them, as after `apt-get install`.
# OPTIONS  further options of the configuration
# BUILD    build folder. It and KERNELS (HAPTICUT_KERNELS) are chosen so that ccache finds the objects of build/release.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/commands.cmake")
# must_have(component on|off): the last configuration reported the component so.
function(must_have component state)
  if(NOT output MATCHES "  ${component}: ${state} ")
    message(FATAL_ERROR "the configuration does not report ${component}: ${state}\n${output}")
  endif()
endfunction()
foreach(list WITHOUT HIDDEN OPTIONS)
  string(REPLACE "," ";" ${list} "${${list}}")
endforeach()
set(ENV{CMAKE_C_COMPILER_LAUNCHER} "${LAUNCHER}")
set(ENV{CMAKE_CXX_COMPILER_LAUNCHER} "${LAUNCHER}")

set(hidden_folders "")
set(options -DHAPTICUT_WITH_TESTS=OFF -DHAPTICUT_WITH_BENCHMARKS=OFF -DHAPTICUT_WITH_EXAMPLES=OFF
    "-DHAPTICUT_KERNELS=${KERNELS}" ${OPTIONS})
foreach(component SIMD IO IMPORT ITK ASSIMP SETTINGS C VIEW CLI)
  set(value ON)
  if(component IN_LIST HIDDEN)
    set(value AUTO)
    set(places "")
    string(TOLOWER "${component}" name)
    foreach(place /usr/lib/cmake /usr/lib/*/cmake /lib/cmake /lib/*/cmake)
      list(APPEND places "${place}/${component}*" "${place}/${name}*")
    endforeach()
    file(GLOB folders ${places})
    list(APPEND hidden_folders ${folders})
  elseif(component IN_LIST WITHOUT)
    set(value OFF)
  endif()
  set(has_${component} FALSE)
  if(value STREQUAL "ON")
    set(has_${component} TRUE)
  endif()
  list(APPEND options -DHAPTICUT_WITH_${component}=${value})
endforeach()

# --- the build, and its installation ----------------------------------------------------------------------------------
set(prefix "${BUILD}/prefix")
file(REMOVE_RECURSE "${BUILD}")
set(hidden "${BUILD}/hidden.cmake")
file(WRITE "${hidden}" "set(CMAKE_IGNORE_PATH \"${hidden_folders}\" CACHE STRING \"\")\n")
set(configure "${CMAKE_COMMAND}" -S "${SOURCE}" --preset release -B "${BUILD}" "-DCMAKE_CXX_COMPILER=${CXX}"
    "-DCMAKE_C_COMPILER=${CC}" ${options})
must("${CMAKE_COMMAND}" -E chdir "${SOURCE}" ${configure} -C "${hidden}")
foreach(component IN LISTS WITHOUT HIDDEN)
  must_have(${component} off)
endforeach()
if(has_CLI)
  # As after scripts/demo.sh: only the program is built.
  must("${CMAKE_COMMAND}" --build "${BUILD}" -t hapticut_cli)
  run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
  if(code EQUAL 0 OR EXISTS "${prefix}" OR NOT output MATCHES "-t[^\n]* hapticut_heat")
    message(FATAL_ERROR "an incomplete installation must fail, write nothing and give the command that builds "
                        "the rest:\n${output}")
  endif()
endif()
must("${CMAKE_COMMAND}" --build "${BUILD}")
must("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
if(has_CLI)
  must("${prefix}/bin/hapticut" --version)
  must("${prefix}/bin/hapticut" inspect molar --voxel_mm 0.5)
endif()

# --- programs that use it ---------------------------------------------------------------------------------------------
set(absent "")
foreach(component IO IMPORT ITK ASSIMP C VIEW)
  if(NOT has_${component})
    string(TOLOWER "${component}" component)
    list(APPEND absent "${component}")
  endif()
endforeach()
list(JOIN absent "," absent)
set(components "build,surface,heat,islands,sound,analysis")
foreach(component IO IMPORT SETTINGS C)
  if(has_${component})
    string(TOLOWER "${component}" component)
    list(APPEND components "${component}")
  endif()
endforeach()
foreach(component IN LISTS components)
  string(REGEX REPLACE ",.*" "" consumer "${BUILD}/consumer_${component}")
  if(component STREQUAL "c")
    set(absent "")  # a program in C looks up nothing else
  endif()
  must("${CMAKE_COMMAND}" -S "${SOURCE}/tests/consumer" -B "${consumer}" -G Ninja -DCMAKE_BUILD_TYPE=Release
       "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_PREFIX_PATH=${prefix}"
       "-DCOMPONENT=${component}" "-DABSENT=${absent}" -C "${hidden}")
  must("${CMAKE_COMMAND}" --build "${consumer}")
  must("${CMAKE_COMMAND}" -E chdir "${consumer}" "${consumer}/consumer")
endforeach()

# --- packages that appear later ---------------------------------------------------------------------------------------
if(HIDDEN)
  must("${CMAKE_COMMAND}" -E chdir "${SOURCE}" ${configure} -DCMAKE_IGNORE_PATH=)
  foreach(component IN LISTS HIDDEN)
    must_have(${component} on)
  endforeach()
  must("${CMAKE_COMMAND}" --build "${BUILD}")
  must("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
  must("${prefix}/bin/hapticut" --version)
endif()
