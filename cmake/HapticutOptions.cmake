# SPDX-License-Identifier: Apache-2.0
# Build settings and the table of optional components.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo" FORCE)
endif()

# Uses ccache if it is installed, independent of the folder of this clone. Not set for projects that include this one.
find_program(HAPTICUT_CCACHE ccache)
mark_as_advanced(HAPTICUT_CCACHE)
if(HAPTICUT_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}")
  if(NOT (CMAKE_BUILD_TYPE STREQUAL "Debug" AND CMAKE_CXX_FLAGS_DEBUG MATCHES "-g( |$)"))
    list(APPEND CMAKE_CXX_COMPILER_LAUNCHER CCACHE_NOHASHDIR=true)  # a debugger needs the path of the sources
  endif()
  list(APPEND CMAKE_CXX_COMPILER_LAUNCHER "${HAPTICUT_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

option(HAPTICUT_INSTALL "Install hapticut together with this project" ${PROJECT_IS_TOP_LEVEL})
option(HAPTICUT_PHYSICS_ONLY "Only hapticut::physics: headers, which need Eigen and nothing else" OFF)
option(HAPTICUT_WITH_FUZZERS "Fuzzers of the readers of files, with clang++; part of the tests" OFF)
option(HAPTICUT_WARNINGS_AS_ERRORS "Treat warnings in hapticut's own code as errors" ${PROJECT_IS_TOP_LEVEL})

# hapticut_rooms(target [BATCH n]): with CMAKE_UNITY_BUILD the files of a folder are compiled as one, because most of
# the time goes into parsing the same headers repeatedly (docs/decisions/0008-time-to-build.md). BATCH: at most n at a
# time.
function(hapticut_rooms target)
  cmake_parse_arguments(ARG "" "BATCH" "" ${ARGN})
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(room "${source}" DIRECTORY)
    string(REPLACE "${PROJECT_SOURCE_DIR}/" "" room "${room}")  # path inside the project
    string(MAKE_C_IDENTIFIER "room_${room}" room)
    if(ARG_BATCH)
      math(EXPR count_${room} "0${count_${room}} + 1")
      math(EXPR batch "(${count_${room}} - 1) / ${ARG_BATCH}")
      string(APPEND room "_${batch}")
    endif()
    set_property(SOURCE "${source}" PROPERTY UNITY_GROUP "${room}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# hapticut_library(name source...): the component hapticut::<name>, which depends on the core.
function(hapticut_library name)
  add_library(hapticut_${name} ${ARGN})
  add_library(hapticut::${name} ALIAS hapticut_${name})
  target_include_directories(hapticut_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(hapticut_${name} PUBLIC hapticut::hapticut PRIVATE $<BUILD_INTERFACE:hapticut_build_flags>)
  set_target_properties(hapticut_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON VERSION ${PROJECT_VERSION} SOVERSION 0
    DEFINE_SYMBOL "")  # all symbols are visible, and static and shared libraries have the same objects
endfunction()

# hapticut_place_of_program(source target): tells a source where the program of a target is, in the build and after the
# installation. Only such a source contains the path of the build folder; ccache can share all others between clones.
function(hapticut_place_of_program source target)
  set(built "")
  if(TARGET ${target})
    set(built "$<TARGET_FILE:${target}>")
  endif()
  set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS
    HAPTICUT_PROGRAMS_INSTALLED="${CMAKE_INSTALL_FULL_LIBEXECDIR}/hapticut/" HAPTICUT_PROGRAM_BUILT="${built}")
endfunction()

# Compile options of the project's targets. They do not affect users' code.
add_library(hapticut_build_flags INTERFACE)
target_compile_features(hapticut_build_flags INTERFACE cxx_std_20)
target_compile_options(hapticut_build_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>
  # In a unity build, each source looks like a header to this warning.
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
  # clang++ also reports local names as shadowing that exist in the unnamed namespace of another source in the unity
  # build.
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:Clang>>:-Wno-shadow>
  # Compiler output is independent of the folder of the sources.
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
  # Code for shared libraries may call and inline its own functions directly.
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  $<$<BOOL:${HAPTICUT_WARNINGS_AS_ERRORS}>:-Werror>)

# Ignores undefined behaviour in third-party headers. The path is relative, so ccache works across clones.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,-]*undefined")
  file(RELATIVE_PATH _ignored "${CMAKE_BINARY_DIR}" "${PROJECT_SOURCE_DIR}/tests/support/undefined.ignorelist")
  target_compile_options(hapticut_build_flags INTERFACE "-fsanitize-ignorelist=${_ignored}")
endif()

# Dependencies of each component: `package to find|target or variable that proves it|Debian package`.
set(HAPTICUT_NEEDS_SIMD "hwy|hwy_FOUND|libhwy-dev")
set(HAPTICUT_NEEDS_IO "HapticutHDF5|HapticutHDF5_FOUND|libhdf5-dev" "PNG|PNG_FOUND|libpng-dev"
    "LibArchive|LibArchive_FOUND|libarchive-dev" "ZLIB|ZLIB_FOUND|zlib1g-dev")
set(HAPTICUT_NEEDS_IMPORT "PNG|PNG_FOUND|libpng-dev" "TIFF|TIFF_FOUND|libtiff-dev"
    "LibArchive|LibArchive_FOUND|libarchive-dev" "EXPAT|EXPAT_FOUND|libexpat1-dev" "ZLIB|ZLIB_FOUND|zlib1g-dev")
set(HAPTICUT_NEEDS_ITK "ITK|ITK_FOUND|libinsighttoolkit5-dev")
set(HAPTICUT_NEEDS_ASSIMP "assimp|assimp_FOUND|libassimp-dev" "nlohmann_json|nlohmann_json_FOUND|nlohmann-json3-dev")
set(HAPTICUT_NEEDS_SETTINGS "tomlplusplus|tomlplusplus_FOUND|libtomlplusplus-dev")
set(HAPTICUT_NEEDS_C "tomlplusplus|tomlplusplus_FOUND|libtomlplusplus-dev")
set(HAPTICUT_NEEDS_VIEW "Boost|Boost_FOUND|libboost-dev")
set(HAPTICUT_NEEDS_CLI "CLI11|CLI11_FOUND|libcli11-dev" "tomlplusplus|tomlplusplus_FOUND|libtomlplusplus-dev"
    "nlohmann_json|nlohmann_json_FOUND|nlohmann-json3-dev")
set(HAPTICUT_NEEDS_TESTS "GTest|GTest_FOUND|libgtest-dev" "rapidcheck|rapidcheck_FOUND|librapidcheck-dev")
set(HAPTICUT_NEEDS_BENCHMARKS "benchmark|benchmark_FOUND|libbenchmark-dev")
set(HAPTICUT_NEEDS_EXAMPLES "")
set(HAPTICUT_NEEDS_PYTHON "Python|Python_FOUND|python3-dev" "pybind11|pybind11_FOUND|pybind11-dev")

# Libraries that need only the core and are found with it.
set(HAPTICUT_COMPONENTS_WITH_CORE build surface heat islands sound analysis)

# Optional components of hapticut::import; the target exists with and without them.
set(HAPTICUT_COMPONENTS_OF_IMPORT ITK ASSIMP)

# The component without which a component is off.
set(HAPTICUT_BASE_OF_IMPORT IO)
set(HAPTICUT_BASE_OF_ITK IMPORT)
set(HAPTICUT_BASE_OF_ASSIMP IMPORT)

set(HAPTICUT_ITK_MODULES ITKCommon ITKIOImageBase ITKIOGDCM
    ITKImageFunction ITKImageGrid ITKDistanceMap)

# hapticut_component(NAME "what it is"): AUTO (default) turns it on when its dependencies are found, ON requires them,
# OFF skips it.
macro(hapticut_component name purpose)
  if("${name}" STREQUAL "PYTHON")
    set(_default OFF)  # `pip install .` turns it on
  elseif(PROJECT_IS_TOP_LEVEL OR "${name}" MATCHES "^(SIMD|IO|IMPORT|ITK|ASSIMP)$")
    set(_default AUTO)
  else()
    set(_default OFF)
  endif()
  set(HAPTICUT_WITH_${name} ${_default} CACHE STRING "${purpose}: AUTO, ON or OFF")
  set_property(CACHE HAPTICUT_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
  set(HAPTICUT_${name} FALSE)
  set(_missing "")
  set(_base "${HAPTICUT_BASE_OF_${name}}")
  set(_without_base FALSE)
  if(_base AND NOT HAPTICUT_${_base})
    if(HAPTICUT_WITH_${name} AND NOT HAPTICUT_WITH_${name} STREQUAL "AUTO")
      message(FATAL_ERROR "HAPTICUT_WITH_${name}=ON adds to HAPTICUT_WITH_${_base}, which is off: set HAPTICUT_WITH_${_base}=ON")
    endif()
    set(_without_base TRUE)
  elseif(HAPTICUT_WITH_${name})
    foreach(_need IN LISTS HAPTICUT_NEEDS_${name})
      string(REPLACE "|" ";" _need "${_need}")
      list(GET _need 0 _package)
      list(GET _need 1 _proof)
      list(GET _need 2 _debian)
      if(_package STREQUAL "ITK")
        # Debian's GDCM reports missing programs, which are not needed.
        set(_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
        set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
        find_package(ITK 5.2 QUIET COMPONENTS ${HAPTICUT_ITK_MODULES})
        set(CMAKE_MESSAGE_LOG_LEVEL "${_log_level}")
      elseif(_package STREQUAL "Python")
        find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
      else()
        find_package(${_package} QUIET)
      endif()
      if(NOT ${_proof})
        list(APPEND _missing ${_debian})
      endif()
    endforeach()
    if(NOT _missing)
      set(HAPTICUT_${name} TRUE)
    elseif(NOT HAPTICUT_WITH_${name} STREQUAL "AUTO")
      list(JOIN _missing " " _missing)
      message(FATAL_ERROR "HAPTICUT_WITH_${name}=ON, but something is missing: sudo apt-get install ${_missing}")
    endif()
  endif()
  if(HAPTICUT_${name})
    list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: on  (${purpose})")
  elseif(_without_base)
    list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: off (${purpose}, needs ${_base}, which is off)")
  elseif(_missing)
    list(JOIN _missing " " _missing)
    list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: off (${purpose}, to turn it on: sudo apt-get install ${_missing})")
  else()
    list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: off (${purpose}, HAPTICUT_WITH_${name}=OFF)")
  endif()
endmacro()

function(hapticut_report_components)
  message(STATUS "hapticut ${PROJECT_VERSION}, ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE}")
  foreach(_line IN LISTS HAPTICUT_COMPONENT_REPORT)
    message(STATUS "  ${_line}")
  endforeach()
endfunction()
