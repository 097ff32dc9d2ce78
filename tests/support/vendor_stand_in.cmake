# SPDX-License-Identifier: Apache-2.0
# Functions for the stand-ins of vendors' SDKs.

# vendor_adapter_under_test(name STAND_IN PART): the adapter of HAPTICUT_WITH_<PART> against its stand-in, from the same
# sources that a machine with the SDK builds, in strict ISO C++.
function(vendor_adapter_under_test name stand_in part)
  get_property(sources GLOBAL PROPERTY HAPTICUT_${part}_SOURCES)
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PUBLIC hapticut::hapticut ${stand_in} PRIVATE hapticut_build_flags)
endfunction()

# vendor_header_test(Suite.Name WILL_FAIL flags...): uses_header.cpp of this folder parses with those flags, or must not.
function(vendor_header_test name will_fail)
  add_test(NAME "${name}" COMMAND ${CMAKE_CXX_COMPILER} ${ARGN} -fsyntax-only
    -isystem ${CMAKE_CURRENT_SOURCE_DIR}/include ${CMAKE_CURRENT_SOURCE_DIR}/uses_header.cpp)
  set_tests_properties("${name}" PROPERTIES WILL_FAIL ${will_fail} LABELS unit)
endfunction()

# vendor_finder_test(Suite.Name PACKAGE LIBRARY modules): our find module in the folder `modules` finds an SDK laid out like ${CMAKE_CURRENT_BINARY_DIR}/sdk,
# whose include folder is the stand-in's, and only what is there.
function(vendor_finder_test name package library modules)
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/sdk")
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}/include" "${CMAKE_CURRENT_BINARY_DIR}/sdk/include" SYMBOLIC)
  add_test(NAME "${name}" COMMAND ${CMAKE_COMMAND} -DPACKAGE=${package} -DLIBRARY=${library}
    -DSOURCE=${CMAKE_CURRENT_SOURCE_DIR}/finder -DBINARY=${CMAKE_CURRENT_BINARY_DIR}/finder
    -DSDK=${CMAKE_CURRENT_BINARY_DIR}/sdk "-DFLAGS=${CMAKE_CXX_FLAGS}" -DMODULES=${modules}
    -DCOMPILER=${CMAKE_CXX_COMPILER} -DGENERATOR=${CMAKE_GENERATOR}
    -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/run_finder.cmake)
  set_tests_properties("${name}" PROPERTIES LABELS unit)
endfunction()
